"""facing: which face of a block points where, and how its symbol is turned."""

from __future__ import annotations

import math
from collections.abc import Iterator
from functools import lru_cache
from random import Random
from typing import Any

from rpg.blocks.predicate import NearMiss, Predicate
from rpg.blocks.predicates.common import put, tilted
from rpg.blocks.state import IDENTITY, BlockState, Quat, World, product, yaw_quat
from rpg.blocks.verdict import FALSE, TRUE, Verdict, some
from rpg.blocks.visibility import TOWARD, Toward, readable, turned, visible
from rpg.ir.assets import FACES, Block, Face, SemanticCube
from rpg.ir.relations import Facing

HALF = math.sqrt(0.5)
PAST_DEGREES = 24.0
"""A turn just past what counts as facing somewhere, or as upright (14 and 20 degrees)."""


def shown_faces(node: Facing, world: World) -> tuple[Face, ...]:
    """The faces that may do what `node` asks: the one it names, those with its label, or all."""
    if node.face is not None:
        return (node.face,)
    return FACES if node.label is None else _faces_with(node.label, world.blocks[node.block])


@lru_cache(maxsize=64)
def _faces_with(label: str, block: Block) -> tuple[Face, ...]:
    return tuple(f for f in FACES if isinstance(block, SemanticCube) and block.symbol(f) == label)


def directions(node: Facing) -> tuple[Toward, ...]:
    """The directions that `node` accepts."""
    return ("up", "front") if node.toward == "viewer" else (node.toward,)


class FacingPredicate(Predicate[Facing]):
    """Some face that is meant points the right way, is turned as asked, and is visible where it can be."""

    def evaluate(self, node: Facing, state: BlockState) -> Verdict:
        found = [
            self._shows(node, face, toward, state)
            for face in shown_faces(node, state.world)
            for toward in directions(node)
        ]
        return some(found) if found else FALSE

    def holds(self, node: Facing, state: BlockState) -> bool:
        return any(
            self._shows(node, face, toward, state).value
            for face in shown_faces(node, state.world)
            for toward in directions(node)
        )

    def _shows(self, node: Facing, face: Face, toward: Toward, state: BlockState) -> Verdict:
        normal, upright = TOWARD[toward]
        up = None if node.turn is None else turned(normal, upright, node.turn)
        verdict = readable(state, node.block, face, normal, up, node.normal_cos, node.upright_cos)
        return verdict & seen(node.block, face, toward, state) if verdict else verdict

    def near_misses(self, node: Facing, state: BlockState, rng: Random) -> Iterator[NearMiss]:
        name = node.block
        own = state.orientation.get(name, IDENTITY)
        turns: dict[str, Quat] = {
            "turned by a quarter": yaw_quat(math.pi / 2),
            "turned by half": yaw_quat(math.pi),
            "turned a little": yaw_quat(math.radians(PAST_DEGREES)),
            "tipped onto its side": (HALF, HALF, 0.0, 0.0),
            "tipped forward": (HALF, 0.0, HALF, 0.0),
            "upside down": (0.0, 1.0, 0.0, 0.0),
        }
        for what, turn in turns.items():
            mutant = put(state, name, state.position[name], product(turn, own))
            if not self.holds(node, mutant):
                yield NearMiss(f"{name} {what}", mutant)
        tipped = tilted(state, name, PAST_DEGREES)
        if not self.holds(node, tipped):
            yield NearMiss(f"{name} tilted", tipped)


def seen(name: str, face: Face, toward: Toward, state: BlockState) -> Verdict:
    """Faces that point up or at the viewer must be visible; the others cannot be from where the viewer stands."""
    return visible(state, name, face) if toward in ("up", "front") else TRUE


TABLE: dict[str, Predicate[Any]] = {"facing": FacingPredicate()}
