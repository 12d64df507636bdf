"""Heaps: blocks dropped between smooth walls, which are then taken away."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache
from random import Random

import mujoco

from rpg.blocks.constants import TABLE_Z
from rpg.blocks.geometry import body_gap
from rpg.blocks.physics import Physics
from rpg.blocks.scene import build_spec
from rpg.blocks.state import BlockState, Quat, Vec3, World, product, yaw_quat
from rpg.ir.assets import Asset

WALL_HEIGHT, WALL_THICKNESS = 0.6, 0.01
PILED = 4
"""From so many blocks on, a heap has blocks lying on others."""
CHAIN_EDGES = 1.0
"""In a heap every block is within this many edges of another one."""
ELBOW_EDGES = 1.0
"""Blocks start to fall with this much room (in their edges) between the walls; corners may touch them."""
LEAN = math.radians(25)
"""Blocks start to fall at an angle of up to this."""
R = math.sqrt(0.5)
UPRIGHTS: tuple[Quat, ...] = (
    (1.0, 0.0, 0.0, 0.0),
    (0.0, 1.0, 0.0, 0.0),
    (R, R, 0.0, 0.0),
    (R, -R, 0.0, 0.0),
    (R, 0.0, R, 0.0),
    (R, 0.0, -R, 0.0),
)
"""One orientation for each face that can be up."""
FALL_STEPS = 15
"""Control steps that blocks have to fall between the walls."""
FLAT = 0.001
"""A block whose centre is no higher (m) over that of one on the table lies flat on it."""
AWAY = 10.0
"""Height (m) that walls are lifted to when they have done their work."""


@dataclass(frozen=True)
class Heap:
    """Blocks that fall into a heap around (x, y), at first within a square shaft of width `side` (m)."""

    names: tuple[str, ...]
    x: float
    y: float
    side: float


def shaft(world: World, names: Sequence[str]) -> float:
    """Width of the shaft for a heap of these blocks: hardly wide enough for all of them to lie side by side."""
    size = max(world.edge[name] for name in names)
    return size * max(1.8, 1.25 * math.sqrt(len(names)))


def above(world: World, heap: Heap, rng: Random) -> dict[str, tuple[Vec3, Quat]]:
    """The blocks of a heap over its place, one above the other and leaning a little, ready to fall."""
    found: dict[str, tuple[Vec3, Quat]] = {}
    height = TABLE_Z
    for name in heap.names:
        reach = world.edge[name] * math.sqrt(3) / 2
        room = max(0.0, (heap.side - ELBOW_EDGES * world.edge[name]) / 2)
        place = (heap.x + rng.uniform(-room, room), heap.y + rng.uniform(-room, room), height + reach)
        found[name] = (place, _tilted(rng))
        height += 2 * reach
    return found


def dropped(state: BlockState, heaps: tuple[Heap, ...]) -> BlockState | None:
    """`state` after its heaps have fallen and settled; None where something does not come to rest, or a heap falls
    apart."""
    physics = _shafts(state.world, tuple(heap.side for heap in heaps))
    physics.write(state)
    for index, heap in enumerate(heaps):
        physics.data.mocap_pos[index] = (heap.x, heap.y, TABLE_Z)
    physics.step(FALL_STEPS)
    physics.data.mocap_pos[:, 2] = AWAY
    if not physics.settle(lambda: _fell_apart(heaps, physics)) or not physics.sane():
        return None
    return physics.read()


def _fell_apart(heaps: tuple[Heap, ...], physics: Physics) -> bool:
    """Do all blocks of a heap that should have blocks on others lie flat on the table?"""
    edge = physics.world.edge
    flat = {name for name, z in physics.heights().items() if z - TABLE_Z - edge[name] / 2 < FLAT}
    return any(len(heap.names) >= PILED and flat.issuperset(heap.names) for heap in heaps)


def in_one_piece(heap: Heap, state: BlockState) -> bool:
    """Is every block within reach of another one, and (of PILED or more) some, but not all but one, lying on others?"""
    names = heap.names
    chain = CHAIN_EDGES * max(state.world.edge[name] for name in names)
    reached, frontier = {names[0]}, [names[0]]
    while frontier:
        name = frontier.pop()
        near = [n for n in names if n not in reached and body_gap(state, name, n) <= chain]
        reached.update(near)
        frontier += near
    raised = sum(state.bottom(name) > TABLE_Z + state.world.edge[name] / 4 for name in names)
    return len(reached) == len(names) and (len(names) < PILED or 0 < raised < len(names) - 1)


@lru_cache(maxsize=1)
def _shafts(world: World, sides: tuple[float, ...]) -> Physics:
    """The simulation that the heaps of one task fall in, one after the other."""
    return Physics(world, _walled(tuple(world.assets.values()), sides))


@lru_cache(maxsize=16)
def _walled(assets: tuple[Asset, ...], sides: tuple[float, ...]) -> mujoco.MjModel:
    """The scene with a square shaft of walls for each heap."""
    spec = build_spec(assets)
    for index, side in enumerate(sides):
        walls = spec.worldbody.add_body(name=f"walls {index}", mocap=True, pos=[0.0, 0.0, AWAY])
        away = side / 2 + WALL_THICKNESS
        for dx, dy in ((1, 0), (-1, 0), (0, 1), (0, -1)):
            walls.add_geom(
                type=mujoco.mjtGeom.mjGEOM_BOX,
                pos=[dx * away, dy * away, WALL_HEIGHT],
                size=[WALL_THICKNESS if dx else away, WALL_THICKNESS if dy else away, WALL_HEIGHT],
                friction=[0.05, 0.0, 0.0],
                priority=1,
            )
    return spec.compile()


def _tilted(rng: Random) -> Quat:
    """Any face up, any turn about the vertical, leaning a little: what comes to rest on others soon."""
    face = rng.choice(UPRIGHTS)
    lean, way, yaw = rng.uniform(0.0, LEAN), rng.uniform(-math.pi, math.pi), rng.uniform(-math.pi, math.pi)
    s = math.sin(lean / 2)
    leaning = (math.cos(lean / 2), s * math.cos(way), s * math.sin(way), 0.0)
    return product(leaning, product(yaw_quat(yaw), face))
