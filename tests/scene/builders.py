"""Worlds and states for tests of the scene."""

from __future__ import annotations

import math

from rpg.blocks.constants import TABLE_Z
from rpg.blocks.state import IDENTITY, BlockState, Quat, Vec3, World
from rpg.ir.assets import ColoredCube, Faces, SemanticCube

HALF = 0.02


def plain(count: int) -> World:
    """`count` red blocks b0, b1, ..."""
    return World([ColoredCube(name=f"b{k}", color="red") for k in range(count)])


def lettered() -> World:
    """One cube with another letter on each face."""
    return World([SemanticCube(name="x", labels=Faces(top="T", bottom="D", front="F", back="B", left="L", right="R"))])


def at(world: World, *places: Vec3, turns: dict[str, Quat] | None = None) -> BlockState:
    """Blocks in the order of the world at heights above the table; level unless turned."""
    names = list(world.blocks)
    position = {name: (x, y, TABLE_Z + z) for name, (x, y, z) in zip(names, places, strict=True)}
    return BlockState(world, position, {name: (turns or {}).get(name, IDENTITY) for name in names})


def tower(count: int) -> list[Vec3]:
    """Places of a straight tower."""
    return [(0.55, 0.0, HALF + 2 * HALF * k) for k in range(count)]


def about(axis: str, degrees: float) -> Quat:
    """A turn about one of the world's axes."""
    half = math.radians(degrees) / 2
    x, y, z = (math.sin(half) if name == axis else 0.0 for name in "xyz")
    return (math.cos(half), x, y, z)
