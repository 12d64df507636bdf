"""Predicate: one definition of an atom of the goal language.

Each file of `rpg.blocks.predicates` defines predicates for a family of atoms and registers them in its table;
`rpg.blocks.predicates.PREDICATES` maps an atom's kind to its predicate.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from random import Random
from typing import Generic, TypeVar

from rpg.blocks.centres import Centres, Mask
from rpg.blocks.state import BlockState, Quat, Vec3, World
from rpg.blocks.verdict import TRUE, Verdict
from rpg.ir.node import Node

N = TypeVar("N", bound=Node)


@dataclass(frozen=True)
class Cluster:
    """Blocks whose poses relative to each other are settled; the solver only translates it over the table.

    `poses`: centre (x, y, z) with z above the lowest point of the cluster, and orientation (None: any that is level).
    `grounded`: its lowest blocks stand on the table (false for a piece that hangs on another cluster's block).
    `fixed`: positions are world x, y and must not move.
    """

    poses: dict[str, tuple[Vec3, Quat | None]]
    grounded: bool = True
    fixed: bool = False


@dataclass(frozen=True)
class NearMiss:
    """A state that almost satisfies an atom but must not, with what was done to it in a few words."""

    what: str
    state: BlockState


class Predicate(ABC, Generic[N]):
    """What an atom means; of the methods that are not abstract, subclasses override those that apply to their kind.

    The lowering to code needs no method: an atom lowers to the call of the BlockTask method named as its kind, with
    its fields as arguments. Its clause in English is in `rpg.blocks.english`, under its kind.
    """

    @abstractmethod
    def evaluate(self, node: N, state: BlockState) -> Verdict:
        """Truth and margin of the atom on `state`."""

    def holds(self, node: N, state: BlockState) -> bool:
        """The truth of `evaluate` alone, for judging many states: most are ruled out at a glance."""
        return self.evaluate(node, state).value

    def plainly_not(self, node: N, state: BlockState) -> bool:
        """Is it seen at a glance that the atom fails by the whole of its tolerance, or more?"""
        return False

    def loosened(self, node: N) -> N | None:
        """The atom without its order, where `in_order` judges that by itself; None where it does not."""
        return None

    def in_order(self, node: N, state: BlockState) -> Verdict:
        """The order alone: with what is `loosened` it is all that the atom says."""
        return TRUE

    def perhaps(self, node: N, many: Centres) -> Mask:
        """The states in which the atom may hold, as far as the centres of blocks tell; never wrong about the others."""
        return many.all()

    def build(self, node: N, world: World, rng: Random) -> Iterator[list[Cluster]]:
        """Ways to lay out the blocks of a structure, most natural first; nothing for a relation.

        A relation constrains where clusters go and is searched for instead, by `propose` and `evaluate`.
        """
        yield from ()

    def propose(self, node: N, block: str, state: BlockState, rng: Random) -> Iterator[tuple[float, float]]:
        """Places (x, y) for the foot of `block` that are likely to satisfy the atom, given the blocks in `state`.

        `state` holds only what is placed already. The solver has proposals of its own around every placed object;
        give only those that are exact or hard to hit (a distance, a midpoint, a region, a patch).
        """
        yield from ()

    @abstractmethod
    def near_misses(self, node: N, state: BlockState, rng: Random) -> Iterator[NearMiss]:
        """States a small change away from `state` (which satisfies the atom) that must not satisfy it."""

    def supports(self, node: N, world: World) -> Iterable[tuple[str, str]]:
        """Edges (what rests, what it rests on) that the atom demands; "table" is the ground."""
        return ()
