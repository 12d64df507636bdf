"""Sampling of initial states: scattered, in a heap that has settled, at a pose, or already arranged.

Every block draws from a generator of its own, seeded by the episode's seed and the name that the block came into the
task with, so that adding, removing or renaming other blocks leaves it where it was.
"""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass, field
from random import Random

from rpg.blocks.constants import TABLE_Z, WORKSPACE_X, WORKSPACE_Y
from rpg.blocks.geometry import Polygon, body_gap, footprint, polygon_gap
from rpg.blocks.physics import settled_state
from rpg.blocks.state import BlockState, Quat, Vec3, World, yaw_quat
from rpg.core.diagnostics import Diagnostic, Refusal
from rpg.ir.goal import All
from rpg.ir.schema import InitialState
from rpg.ir.walk import names

CLEARANCE = 0.012
"""Gap (m) kept between scattered blocks where there is room for it, so that a gripper can reach between them."""
TIGHT = 0.004
"""Gap (m) kept in any case."""
BORDER = 0.005
"""Scattered centres stay this far (m) inside the workspace."""
PROPOSALS = 120
LAYOUTS = 20
HEAP_SPREAD = 0.6
HEAP_TRIES = 12
HEAP_CHAIN = 1.0
"""In a heap every block is within this many edges of another one."""


@dataclass
class _Layout:
    """A start under construction: blocks placed so far, and outlines to keep clear of."""

    world: World
    position: dict[str, Vec3] = field(default_factory=dict)
    orientation: dict[str, Quat] = field(default_factory=dict)
    circles: list[tuple[float, float, float]] = field(default_factory=list)
    outlines: list[Polygon] = field(default_factory=list)

    def put(self, name: str, position: Vec3, orientation: Quat) -> None:
        self.position[name], self.orientation[name] = position, orientation
        self.keep_clear(footprint(self.state(), name))

    def keep_clear(self, outline: Polygon) -> None:
        x, y = (sum(p[k] for p in outline) / len(outline) for k in (0, 1))
        self.circles.append((x, y, max(math.dist((x, y), p) for p in outline)))
        self.outlines.append(outline)

    def state(self) -> BlockState:
        return BlockState(self.world, self.position, self.orientation)

    def free(self, x: float, y: float, radius: float, clearance: float) -> bool:
        """Is a disc around (x, y) clear of everything by `clearance`?"""
        return all((x - a) ** 2 + (y - b) ** 2 >= (radius + r + clearance) ** 2 for a, b, r in self.circles)

    def fits(self, outline: Polygon, clearance: float) -> bool:
        """Is `outline` clear of everything by `clearance`?"""
        return all(polygon_gap(outline, other) >= clearance for other in self.outlines)


def sample_start(init: InitialState, world: World, seed: int, attempt: int = 0) -> BlockState:
    """The start that `seed` draws from `init`, at rest. Attempts give independent starts.

    Raises Refusal (`start-no-room`, `start-unstable`) where there is none.
    """
    diagnostic = _no_room(world)
    for layout in range(LAYOUTS):
        draw = f"{seed}/{attempt}/{layout}"
        found = _compose(init, world, draw)
        if found is None:
            continue
        if not (init.arranged or init.heaps):
            return found
        state = settled_state(found)
        if state is not None and _acceptable(init, found, state):
            return state
        diagnostic = _unstable()
    raise Refusal([diagnostic])


def _compose(init: InitialState, world: World, draw: str) -> BlockState | None:
    """One try at a layout; None where something found no place."""
    layout = _Layout(world)
    for patch in world.patches.values():
        if patch.position is not None:
            layout.keep_clear(footprint(layout.state(), patch.name))
    _put_poses(init, layout, draw)
    if init.arranged:
        _put_arranged(init, layout, draw)
    for index, heap in enumerate(init.heaps):
        if not _put_heap(heap, layout, Random(f"{draw}/heap {index}")):
            return None
    vacant: dict[str | None, list[tuple[str, float]]] = {}
    for vacancy in init.vacant:
        vacant.setdefault(vacancy.before, []).append((vacancy.origin, vacancy.size))
    for name in (*world.assets, None):
        for origin, size in vacant.get(name, ()):
            place = _place(layout, size, Random(f"{draw}/{origin}"))
            if place is not None:
                layout.circles.append((place[0], place[1], size / math.sqrt(2)))
                layout.outlines.append(_outline(*place, size))
        if name is not None and name in world.blocks and name not in layout.position:
            block = world.blocks[name]
            place = _place(layout, block.size, Random(f"{draw}/{block.origin or name}"))
            if place is None:
                return None
            x, y, yaw = place
            layout.put(name, (x, y, TABLE_Z + block.size / 2), yaw_quat(yaw))
    order = list(world.blocks)
    return BlockState(world, {n: layout.position[n] for n in order}, {n: layout.orientation[n] for n in order})


def _place(layout: _Layout, size: float, rng: Random) -> tuple[float, float, float] | None:
    """A free place (x, y, yaw) for a block of edge `size`: with room around it, else wherever it fits."""
    radius = size / math.sqrt(2)
    drawn = []
    for _ in range(PROPOSALS):
        x = rng.uniform(WORKSPACE_X[0] + BORDER, WORKSPACE_X[1] - BORDER)
        y = rng.uniform(WORKSPACE_Y[0] + BORDER, WORKSPACE_Y[1] - BORDER)
        yaw = rng.uniform(-math.pi, math.pi)
        if layout.free(x, y, radius, CLEARANCE):
            return x, y, yaw
        drawn.append((x, y, yaw))
    return next((place for place in drawn if layout.fits(_outline(*place, size), TIGHT)), None)


def _outline(x: float, y: float, yaw: float, size: float) -> Polygon:
    """The footprint of a level block."""
    c, s = math.cos(yaw) * size / 2, math.sin(yaw) * size / 2
    return (x + c - s, y + s + c), (x - c - s, y - s + c), (x - c + s, y - s - c), (x + c + s, y + s - c)


def _put_poses(init: InitialState, layout: _Layout, draw: str) -> None:
    for start in init.poses:
        block = layout.world.blocks[start.block]
        rng = Random(f"{draw}/{block.origin or block.name}")
        x, y = (value + rng.uniform(-start.jitter, start.jitter) for value in start.position)
        layout.put(block.name, (x, y, TABLE_Z + block.size / 2), yaw_quat(start.yaw))


def _put_arranged(init: InitialState, layout: _Layout, draw: str) -> None:
    """Blocks that a goal mentions, in a state where it holds."""
    from rpg.blocks.arrange import arrange

    goal = All(goals=init.arranged)
    mentioned = set(names(goal)) | set(layout.position)
    assets = [a for name, a in layout.world.assets.items() if name in mentioned or name in layout.world.patches]
    before = layout.state() if layout.position else None
    found = arrange(goal, World(assets), rng=Random(f"{draw}/arranged"), start=before)[0]
    for name in layout.world.blocks:
        if name in mentioned and name not in layout.position:
            layout.put(name, found.position[name], found.orientation[name])


def _put_heap(heap: Iterable[str], layout: _Layout, rng: Random) -> bool:
    """Blocks above a free place, turned anyhow, ready to fall into a heap."""
    blocks = [layout.world.blocks[name] for name in heap]
    size = max(block.size for block in blocks)
    spread = HEAP_SPREAD * size * (1.0 if len(blocks) > 2 else 0.5)
    radius = size * math.sqrt(len(blocks)) * 0.8 + size
    for _ in range(PROPOSALS):
        x = rng.uniform(WORKSPACE_X[0] + size, WORKSPACE_X[1] - size)
        y = rng.uniform(WORKSPACE_Y[0] + size, WORKSPACE_Y[1] - size)
        if layout.free(x, y, radius, CLEARANCE):
            break
    else:
        return False
    for level, block in enumerate(blocks):
        height = TABLE_Z + size + level * size * 1.1
        place = (x + rng.uniform(-spread, spread), y + rng.uniform(-spread, spread), height)
        layout.position[block.name], layout.orientation[block.name] = place, _turned_anyhow(rng)
    layout.circles.append((x, y, radius))
    layout.outlines.append(_outline(x, y, 0.0, 2 * radius))
    return True


def _turned_anyhow(rng: Random) -> Quat:
    """A uniformly random orientation."""
    parts = [rng.gauss(0.0, 1.0) for _ in range(4)]
    length = math.sqrt(sum(part * part for part in parts))
    w, x, y, z = (part / length for part in parts)
    return (w, x, y, z)


def _acceptable(init: InitialState, before: BlockState, state: BlockState) -> bool:
    """Has a start settled within the workspace, heaps in one piece and all else where it was put?"""
    heaped = {name for heap in init.heaps for name in heap}
    for name, (x, y, z) in state.position.items():
        if not (WORKSPACE_X[0] <= x <= WORKSPACE_X[1] and WORKSPACE_Y[0] <= y <= WORKSPACE_Y[1] and z > TABLE_Z):
            return False
        if name not in heaped and math.dist((x, y, z), before.position[name]) > 0.005:
            return False
    return all(_in_one_piece(tuple(heap), state) for heap in init.heaps) and not _on_patches(heaped, state)


def _in_one_piece(heap: tuple[str, ...], state: BlockState) -> bool:
    """Is every block of the heap within reach of another one, and something on top of something?"""
    chain = HEAP_CHAIN * max(state.world.edge[name] for name in heap)
    reached, frontier = {heap[0]}, [heap[0]]
    while frontier:
        name = frontier.pop()
        near = [n for n in heap if n not in reached and body_gap(state, name, n) <= chain]
        reached.update(near)
        frontier += near
    raised = any(state.bottom(name) > TABLE_Z + state.world.edge[name] / 4 for name in heap)
    return len(reached) == len(heap) and (raised or len(heap) < 3)


def _on_patches(blocks: Iterable[str], state: BlockState) -> bool:
    outlines = [footprint(state, name) for name, patch in state.world.patches.items() if patch.position is not None]
    return any(polygon_gap(footprint(state, name), outline) < 0.0 for name in sorted(blocks) for outline in outlines)


def _no_room(world: World) -> Diagnostic:
    return Diagnostic(
        code="start-no-room",
        message=f"the {len(world.blocks)} blocks and {len(world.patches)} patches leave no room for a start in which "
        "no two blocks touch",
        hint="use fewer or smaller blocks, or smaller patches",
        origin="initial",
        facts={"blocks": len(world.blocks), "patches": len(world.patches)},
    )


def _unstable() -> Diagnostic:
    return Diagnostic(
        code="start-unstable",
        message="no start came to rest inside the workspace",
        hint="start with fewer blocks in the heap, or with a structure that stands by itself",
        origin="initial",
    )
