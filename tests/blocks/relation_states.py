"""Hand-made states for the tests of relations: blocks of 4 cm unless their name says otherwise, and two patches."""

from __future__ import annotations

import math
from typing import Any, NamedTuple

from rpg.blocks.constants import TABLE_Z
from rpg.blocks.state import BlockState, Quat, World, product, yaw_quat
from rpg.ir.assets import ColoredCube, Faces, GoalPatch, SemanticCube
from rpg.ir.goal import GOAL, Goal

E = 0.04
CUBE = SemanticCube(name="cube", labels=Faces(top="A", front="B", back="C", left="D", right="E", bottom="F"))
WORLD = World(
    [
        *(ColoredCube(name=name, color=name) for name in ("red", "blue", "green", "yellow")),
        ColoredCube(name="big", color="purple", size=0.08),
        CUBE,
        GoalPatch(name="mat", color="blue", position=(0.55, -0.15)),
        GoalPatch(name="spot", color="red", shape="circle", size=(0.12, 0.12), position=(0.55, 0.15)),
    ]
)


class At(NamedTuple):
    """Where a block stands: centre in the plane, height of its lowest face over the table, turns in degrees."""

    x: float
    y: float
    up: float = 0.0
    yaw: float = 0.0
    tilt: float = 0.0
    quat: Quat | None = None


def scene(start: BlockState | None = None, world: World = WORLD, **blocks: At | tuple[float, ...]) -> BlockState:
    """A state with these blocks and no others."""
    position, orientation = {}, {}
    for name, place in blocks.items():
        at = At(*place)
        half = math.radians(at.tilt) / 2
        quat = at.quat or product(yaw_quat(math.radians(at.yaw)), (math.cos(half), math.sin(half), 0.0, 0.0))
        position[name] = (at.x, at.y, TABLE_Z + at.up + world.edge[name] / 2)
        orientation[name] = quat
    return BlockState(world, position, orientation, start=start)


def goal(kind: str, **fields: Any) -> Goal:
    """A goal node from its fields."""
    return GOAL.validate_python({"kind": kind, **fields})
