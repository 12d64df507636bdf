"""stayed, moved, swapped, turned: relative to the start of the episode."""

from __future__ import annotations

import math
from collections.abc import Iterator
from itertools import permutations
from random import Random
from typing import Any

from rpg.blocks.nouns import phrase, verb
from rpg.blocks.predicate import Predicate
from rpg.blocks.state import BlockState, World
from rpg.blocks.verdict import Verdict, at_least, at_most, every, some
from rpg.ir.relations import Moved, Stayed, Swapped, Turned

MATCHED = 5
"""Groups up to this size may swap in any pairing; larger ones in the order given."""


def start_of(state: BlockState) -> BlockState:
    """The state in which the episode began."""
    return state.start or state


def travelled(name: str, state: BlockState) -> float:
    """Distance of a block from where the episode found it."""
    return math.dist(state.position[name], start_of(state).position[name])


class StayedPredicate(Predicate[Stayed]):
    """Each block is where it was."""

    def evaluate(self, node: Stayed, state: BlockState) -> Verdict:
        return every([at_most(travelled(a, state), node.tolerance) for a in state.resolve(node.a)])

    def english(self, node: Stayed, world: World) -> str:
        return f"{phrase(node.a, world)} {verb(node.a, 'stays', 'stay')} where {verb(node.a, 'it is', 'they are')}"


class MovedPredicate(Predicate[Moved]):
    """Each block is somewhere else."""

    def evaluate(self, node: Moved, state: BlockState) -> Verdict:
        return every([at_least(travelled(a, state), node.at_least) for a in state.resolve(node.a)])

    def english(self, node: Moved, world: World) -> str:
        words = f"{phrase(node.a, world)} {verb(node.a)} moved by at least"
        return f"{words} {round(node.at_least * 100, 1):g} cm"


class SwappedPredicate(Predicate[Swapped]):
    """Each block stands where its counterpart stood."""

    def evaluate(self, node: Swapped, state: BlockState) -> Verdict:
        return self._taken(node.a, node.b, node, state) & self._taken(node.b, node.a, node, state)

    def _taken(self, names: tuple[str, ...], places: tuple[str, ...], node: Swapped, state: BlockState) -> Verdict:
        start = start_of(state)
        deals = permutations(places, len(names)) if len(places) <= MATCHED else [places]
        return some(
            [
                every(
                    [
                        at_most(math.dist(state.position[n], start.position[p]), node.tolerance)
                        for n, p in zip(names, deal, strict=False)
                    ]
                )
                for deal in deals
            ]
        )

    def propose(self, node: Swapped, block: str, state: BlockState, rng: Random) -> Iterator[tuple[float, float]]:
        theirs = node.b if block in node.a else node.a
        start = start_of(state)
        yield from (start.position[n][:2] for n in theirs if n in start.position)

    def english(self, node: Swapped, world: World) -> str:
        return f"{phrase(node.a, world)} and {phrase(node.b, world)} have swapped places"


class TurnedPredicate(Predicate[Turned]):
    """The block has turned about the vertical."""

    def evaluate(self, node: Turned, state: BlockState) -> Verdict:
        yaw, upright = yaw_since_start(node.block, state)
        wanted = (node.degrees, -node.degrees) if node.either_way else (node.degrees,)
        off = min(abs((yaw - w + 180.0) % 360.0 - 180.0) for w in wanted)
        return at_most(max(off, upright), node.tolerance)

    def english(self, node: Turned, world: World) -> str:
        way = "" if node.either_way else (" counter-clockwise" if node.degrees > 0 else " clockwise")
        return f"{phrase(node.block, world)} is turned by {abs(node.degrees):g} degrees{way}"


def yaw_since_start(name: str, state: BlockState) -> tuple[float, float]:
    """Degrees that a block has turned about the vertical since the start, and how far it is tipped from then."""
    now, then = state.axes(name), start_of(state).axes(name)
    r = [[sum(now[i][k] * then[j][k] for k in range(3)) for j in range(3)] for i in range(3)]
    yaw = math.degrees(math.atan2(r[1][0] - r[0][1], r[0][0] + r[1][1]))
    return yaw, math.degrees(math.acos(max(-1.0, min(1.0, r[2][2]))))


TABLE: dict[str, Predicate[Any]] = {
    "stayed": StayedPredicate(),
    "moved": MovedPredicate(),
    "swapped": SwappedPredicate(),
    "turned": TurnedPredicate(),
}
