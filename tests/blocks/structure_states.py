"""Hand-made worlds and states for the tests of structures."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from random import Random

from rpg.blocks.constants import TABLE_Z
from rpg.blocks.predicate import Cluster
from rpg.blocks.predicates import PREDICATES
from rpg.blocks.state import IDENTITY, BlockState, Quat, World, yaw_quat
from rpg.ir.assets import Asset, ColoredCube, GoalPatch, SemanticCube
from rpg.ir.node import Node

E = 0.04


def plain(**colors: str) -> list[Asset]:
    """Plain cubes: name=colour."""
    return [ColoredCube(name=name, color=color) for name, color in colors.items()]


def cubes(count: int, color: str = "red", prefix: str = "b") -> list[Asset]:
    """So many plain cubes of one colour: b0, b1, ..."""
    return [ColoredCube(name=f"{prefix}{k}", color=color) for k in range(count)]


def letters(word: str) -> list[Asset]:
    """Symbol cubes named s0, s1, ... in the order of `word`."""
    return [SemanticCube(name=f"s{k}", label=symbol) for k, symbol in enumerate(word)]


def patch(name: str, color: str, x: float, y: float, side: float = 0.1) -> Asset:
    return GoalPatch(name=name, color=color, size=(side, side), position=(x, y))


def world(*groups: Iterable[Asset]) -> World:
    return World([asset for group in groups for asset in group])


Place = tuple[float, float] | tuple[float, float, float]


def state(
    objects: World,
    places: Mapping[str, Place],
    turns: Mapping[str, Quat] | None = None,
    yaw: float = 0.0,
    at: tuple[float, float] = (0.55, 0.0),
) -> BlockState:
    """Blocks at places relative to `at`, the whole turned by `yaw` about it; the third number is the level above the
    table in edges."""
    c, s = math.cos(yaw), math.sin(yaw)
    position = {}
    for name, place in places.items():
        x, y, level = (*place, 0.0)[:3]
        height = TABLE_Z + objects.edge[name] / 2 + level * E
        position[name] = (at[0] + c * x - s * y, at[1] + s * x + c * y, height)
    orientation = {name: (turns or {}).get(name, yaw_quat(yaw) if yaw else IDENTITY) for name in places}
    return BlockState(objects, position, orientation)


def placed(clusters: list[Cluster], objects: World, apart: float = 0.25) -> BlockState:
    """Clusters side by side along y, far from each other."""
    position, orientation = {}, {}
    for k, cluster in enumerate(clusters):
        for name, ((x, y, z), quat) in cluster.poses.items():
            position[name] = (0.55 + x, k * apart + y, TABLE_Z + z)
            orientation[name] = quat or IDENTITY
    return BlockState(objects, position, orientation)


def value(node: Node, on: BlockState) -> bool:
    verdict = PREDICATES[node.kind].evaluate(node, on)  # type: ignore[attr-defined]
    assert verdict.margin >= 0.0 if verdict.value else verdict.margin <= 0.0
    return verdict.value


def check_built(node: Node, objects: World, extras: Mapping[str, Place] | None = None, least: int = 1) -> int:
    """Every way to build `node` satisfies it with room to spare, and every near-miss of it does not."""
    predicate = PREDICATES[node.kind]  # type: ignore[attr-defined]
    misses = 0
    built = list(predicate.build(node, objects, Random(1)))
    assert built, "no way to build it"
    for clusters in built[:8]:
        made = placed(clusters, objects)
        if extras:
            made = BlockState(
                objects,
                {**made.position, **state(objects, extras).position},
                {**made.orientation, **dict.fromkeys(extras, IDENTITY)},
            )
        verdict = predicate.evaluate(node, made)
        assert verdict.value and verdict.margin > 0.05, (node, verdict, made.position)
        for miss in predicate.near_misses(node, made, Random(1)):
            assert not predicate.evaluate(node, miss.state).value, (node, miss.what)
            misses += 1
    assert misses >= least
    return misses
