"""Sampling of initial states: scattered, in a heap that has settled, at a pose, or already arranged.

Every block draws from a generator of its own, seeded by the episode's seed and the name that the block came into the
task with, so that adding, removing or renaming other blocks leaves it where it was.
"""

from __future__ import annotations

import math
from collections import deque
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass, field
from functools import lru_cache
from itertools import count
from random import Random

import numpy as np

from rpg.blocks.arrange import arrange
from rpg.blocks.constants import TABLE_Z, WORKSPACE_X, WORKSPACE_Y
from rpg.blocks.geometry import Polygon, clear_of, footprint, patch_outline, polygon_gap, rectangle
from rpg.blocks.heaps import Heap, above, dropped, in_one_piece, shaft
from rpg.blocks.physics import Physics, leave, left, settled_state
from rpg.blocks.scene import compiled
from rpg.blocks.state import BlockState, Quat, Vec3, World, yaw_quat
from rpg.core.diagnostics import Diagnostic, Refusal
from rpg.ir.goal import All, Goal
from rpg.ir.schema import InitialState
from rpg.ir.walk import names, plain

CLEARANCE = 0.012
"""Gap (m) kept between scattered blocks where there is room for it, so that a gripper can reach between them."""
TIGHT = 0.004
"""Gap (m) kept in any case."""
BORDER = 0.005
"""Scattered centres stay this far (m) inside the workspace."""
LEAST_X, LEAST_Y = WORKSPACE_X[0] + BORDER, WORKSPACE_Y[0] + BORDER
SPAN_X, SPAN_Y = WORKSPACE_X[1] - BORDER - LEAST_X, WORKSPACE_Y[1] - BORDER - LEAST_Y
TURN = 2 * math.pi
PROPOSALS = 120
FEW = 6
"""Proposals that are looked at one by one; only on a crowded table all of them are looked at, at once."""
LAYOUTS = 20
HEAP_MARGIN = 0.025
"""A heap may spread this far (m) beyond its shaft."""
STIRRED = 0.005
"""Nothing but heaps may move farther (m) than this while a start settles."""


class _Obstacle:
    """A convex outline to keep clear of: its middle (x, y), the `radius` of the circle around it, and that of a circle
    about its middle that lies `within` it."""

    def __init__(self, outline: Polygon, radius: float | None = None, within: float = 0.0) -> None:
        self.outline = outline
        self.x, self.y = middle = _middle(outline)
        self.radius = max(math.dist(middle, p) for p in outline) if radius is None else radius
        self.within = within


@dataclass
class _Layout:
    """A start under construction: blocks placed so far, and what to keep clear of."""

    world: World
    position: dict[str, Vec3] = field(default_factory=dict)
    orientation: dict[str, Quat] = field(default_factory=dict)
    obstacles: list[_Obstacle] = field(default_factory=list)
    heaps: list[Heap] = field(default_factory=list)

    def put_flat(self, name: str, x: float, y: float, yaw: float) -> None:
        """A block on the table, turned by `yaw`."""
        size = self.world.edge[name]
        self.position[name], self.orientation[name] = (x, y, TABLE_Z + size / 2), yaw_quat(yaw)
        self.reserve(x, y, yaw, size)

    def reserve(self, x: float, y: float, yaw: float, size: float) -> None:
        """The place of a block of edge `size` on the table, which others keep clear of."""
        self.obstacles.append(_Obstacle(_outline(x, y, yaw, size), size / math.sqrt(2), size / 2))

    def put(self, name: str, position: Vec3, orientation: Quat, outline: Polygon) -> None:
        """A block anywhere, with its outline on the table."""
        self.position[name], self.orientation[name] = position, orientation
        self.obstacles.append(_Obstacle(outline, within=self.world.edge[name] / 2))

    def keep_clear(self, outline: Polygon) -> None:
        self.obstacles.append(_Obstacle(outline))

    def state(self) -> BlockState:
        """What is placed so far, in the order of the world."""
        placed = [name for name in self.world.blocks if name in self.position]
        return BlockState(self.world, {n: self.position[n] for n in placed}, {n: self.orientation[n] for n in placed})

    def free(self, x: float, y: float, radius: float, clearance: float) -> bool:
        """Is a disc around (x, y) clear of everything by `clearance`?"""
        radius += clearance
        for other in self.obstacles:
            dx, dy, reach = x - other.x, y - other.y, radius + other.radius
            if dx * dx + dy * dy < reach * reach:
                return False
        return True

    def fits(self, outline: Polygon, clearance: float) -> bool:
        """Is `outline` clear of everything by `clearance`?"""
        x, y = _middle(outline)
        reach = math.dist((x, y), outline[0]) + clearance
        for other in self.obstacles:
            near = (x - other.x) ** 2 + (y - other.y) ** 2 < (reach + other.radius) ** 2
            if near and polygon_gap(outline, other.outline) < clearance:
                return False
        return True


def _middle(outline: Polygon) -> tuple[float, float]:
    """Mean of an outline's corners."""
    return (sum([x for x, _ in outline]) / len(outline), sum([y for _, y in outline]) / len(outline))


def sample_start(
    init: InitialState, world: World, seed: int, attempt: int = 0, own: Callable[[], Physics | None] = lambda: None
) -> BlockState:
    """The start that `seed` draws from `init`, at rest. Attempts give independent starts. `own`: a simulation of the
    world that starts may settle in.

    Raises Refusal (`start-no-room`, `start-unstable`) where there is none.
    """
    unstable = False
    for number in range(LAYOUTS):
        draw = f"{seed}/{attempt}/{number}"
        layout = _compose(init, world, draw)
        if layout is None:
            continue
        found, heaps = layout.state(), tuple(layout.heaps)
        if not (init.arranged or heaps):
            return found
        state = dropped(found, heaps) if heaps else settled_state(found, own())
        if state is not None and _acceptable(heaps, found, state):
            return _rounded(state)
        unstable = True
    raise Refusal([_unstable() if unstable else _no_room(world)])


_foreseen: deque[tuple[object, dict[int, BlockState]]] = deque(maxlen=1)
"""The starts that seed 0 draws for one task, by attempt, which somebody has drawn already."""


def foresee(init: InitialState, world: World) -> Iterator[BlockState]:
    """What seed 0 draws, attempt by attempt. The task that is made of this next does not draw them a second time."""
    drawn: dict[int, BlockState] = {}
    _foreseen.append((_said(init, world), drawn))
    model = compiled(tuple(world.assets.values())) if init.arranged else None
    physics = Physics(world, model, left(model)) if model is not None else None
    try:
        for attempt in count():
            drawn[attempt] = sample_start(init, world, 0, attempt, lambda: physics)
            yield drawn[attempt]
    finally:
        if physics is not None:
            leave(physics)


def foreseen(init: InitialState, world: World, seed: int, attempt: int) -> BlockState | None:
    """What `seed` draws, where that was foreseen, and is asked for the first time."""
    for said, drawn in _foreseen if seed == 0 else ():
        if attempt in drawn and said == _said(init, world):
            start = drawn.pop(attempt)
            return BlockState(world, start.position, start.orientation)
    return None


def _said(init: InitialState, world: World) -> object:
    """What starts are drawn from; where the instruction speaks of it does not matter."""
    return [*map(plain, init.arranged)], init.heaps, init.poses, init.vacant, [*world.assets.values()]


def _rounded(state: BlockState) -> BlockState:
    """Poses without the last digits, in which the solver's noise differs with what else stands on the table."""
    return BlockState(
        world=state.world,
        position={n: (round(x, 9), round(y, 9), round(z, 9)) for n, (x, y, z) in state.position.items()},
        orientation={
            n: (round(w, 9), round(x, 9), round(y, 9), round(z, 9)) for n, (w, x, y, z) in state.orientation.items()
        },
    )


def _compose(init: InitialState, world: World, draw: str) -> _Layout | None:
    """One try at a layout; None where something found no place."""
    layout = _Layout(world)
    for patch in world.patches.values():
        if patch.position is not None:
            # Of a circle too: a patch of another shape must leave the blocks where they start.
            layout.keep_clear(rectangle(patch.position, patch.size))
    if init.arranged and not _put_arranged(init, layout, draw):
        return None
    _put_poses(init, layout, draw)
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
                layout.reserve(*place, size)
        if name is not None and name in world.blocks and name not in layout.position:
            block = world.blocks[name]
            place = _place(layout, block.size, Random(f"{draw}/{block.origin or name}"))
            if place is None:
                return None
            layout.put_flat(name, *place)
    return layout


def _place(layout: _Layout, size: float, rng: Random) -> tuple[float, float, float] | None:
    """A free place (x, y, yaw) for a block of edge `size`: with room around it, else wherever it fits."""
    radius = size / math.sqrt(2)
    drawn = []
    for _ in range(FEW):
        place = _proposal(rng)
        if layout.free(place[0], place[1], radius, CLEARANCE):
            return place
        drawn.append(place)
    drawn += [_proposal(rng) for _ in range(PROPOSALS - FEW)]
    others = np.array([(other.x, other.y, other.radius, other.within) for other in layout.obstacles])
    middles = np.array(drawn)
    dx, dy = (np.subtract.outer(middles[:, k], others[:, k]) for k in (0, 1))
    square = dx * dx + dy * dy
    with_room = (square >= (radius + CLEARANCE + others[:, 2]) ** 2).all(axis=1)
    if with_room.any():
        return drawn[int(with_room.argmax())]
    perhaps = (square >= (size / 2 + others[:, 3]) ** 2).all(axis=1)
    candidates = (drawn[k] for k in np.flatnonzero(perhaps))
    return next((place for place in candidates if layout.fits(_outline(*place, size), TIGHT)), None)


def _proposal(rng: Random) -> tuple[float, float, float]:
    """An (x, y, yaw) drawn from the workspace."""
    draw = rng.random
    return LEAST_X + SPAN_X * draw(), LEAST_Y + SPAN_Y * draw(), -math.pi + TURN * draw()


def _outline(x: float, y: float, yaw: float, size: float) -> Polygon:
    """The footprint of a level block."""
    c, s = math.cos(yaw) * size / 2, math.sin(yaw) * size / 2
    return (x + c - s, y + s + c), (x - c - s, y - s + c), (x - c + s, y - s - c), (x + c + s, y + s - c)


def _put_poses(init: InitialState, layout: _Layout, draw: str) -> None:
    for start in init.poses:
        block = layout.world.blocks[start.block]
        rng = Random(f"{draw}/{block.origin or block.name}")
        x, y = (value + rng.uniform(-start.jitter, start.jitter) for value in start.position)
        layout.put_flat(block.name, x, y, start.yaw)


def _put_arranged(init: InitialState, layout: _Layout, draw: str) -> bool:
    """Blocks that a goal mentions, in a state where it holds; off the patches that it does not mention."""
    goal, world, others = _arrangement(init.arranged, layout.world)
    found = arrange(goal, world, rng=Random(f"{draw}/arranged"), natural=False)[0]
    outlines = {name: footprint(found, name) for name in found.position}
    if not all(clear_of(outline, other, TIGHT) for outline in outlines.values() for other in others):
        return False
    for name, outline in outlines.items():
        layout.put(name, found.position[name], found.orientation[name], outline)
    return True


@lru_cache(maxsize=1)
def _arrangement(arranged: tuple[Goal, ...], world: World) -> tuple[Goal, World, list[Polygon]]:
    """What is built at every start of one task: the goal that it is built by, its objects alone, and the outlines of
    the patches that are not part of it."""
    goal = All(goals=arranged)
    mentioned = set(names(goal))
    others = [patch_outline(patch) for name, patch in world.patches.items() if name not in mentioned]
    return goal, World(asset for name, asset in world.assets.items() if name in mentioned), others


def _put_heap(names: tuple[str, ...], layout: _Layout, rng: Random) -> bool:
    """Blocks above a free place, ready to fall into a heap."""
    side = shaft(layout.world, names)
    for _ in range(PROPOSALS):
        x = rng.uniform(WORKSPACE_X[0] + side / 2, WORKSPACE_X[1] - side / 2)
        y = rng.uniform(WORKSPACE_Y[0] + side / 2, WORKSPACE_Y[1] - side / 2)
        spread = _outline(x, y, 0.0, side + 2 * HEAP_MARGIN)
        if layout.fits(spread, CLEARANCE):
            break
    else:
        return False
    heap = Heap(names, x, y, side)
    layout.heaps.append(heap)
    for name, (position, orientation) in above(layout.world, heap, rng).items():
        layout.position[name], layout.orientation[name] = position, orientation
    layout.keep_clear(spread)
    return True


def _acceptable(heaps: Iterable[Heap], before: BlockState, state: BlockState) -> bool:
    """Has a start settled within the workspace, heaps in one piece and all else where it was put?"""
    heaped = {name for heap in heaps for name in heap.names}
    for name, (x, y, z) in state.position.items():
        if not (WORKSPACE_X[0] <= x <= WORKSPACE_X[1] and WORKSPACE_Y[0] <= y <= WORKSPACE_Y[1] and z > TABLE_Z):
            return False
        if name not in heaped and math.dist((x, y, z), before.position[name]) > STIRRED:
            return False
    return all(in_one_piece(heap, state) for heap in heaps) and not (heaped and _on_patches(heaped, state))


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


def solved_at_start(attempts: int) -> Diagnostic:
    """Among so many starts there is none with the goal ahead."""
    return Diagnostic(
        code="start-solves-goal",
        message=f"the goal holds, is lost, or is past its first stage in each of {attempts} starts",
        hint="say how the blocks start, or ask for something that is not so from the beginning",
        origin="initial",
        facts={"attempts": attempts},
    )


def crowded(attempts: int) -> Diagnostic:
    """Among so many starts there is none from which the goal can be reached."""
    return Diagnostic(
        code="start-no-room",
        message=f"in none of {attempts} starts does what has to stay where it is leave room for the goal",
        hint="let fewer blocks stay where they are, or say how they start",
        origin="initial",
        facts={"attempts": attempts},
    )
