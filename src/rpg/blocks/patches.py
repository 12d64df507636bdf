"""Where goal patches lie and how large they are: fixed at compile time, so that what must lie on them fits."""

from __future__ import annotations

import math
from collections.abc import Iterator
from itertools import islice, permutations
from random import Random

from rpg.blocks.arrange import CHANGES
from rpg.blocks.arrange.alternatives import alternatives
from rpg.blocks.arrange.explain import conditions
from rpg.blocks.arrange.pieces import Assembly, Clash, Piece
from rpg.blocks.arrange.solve import Solver
from rpg.blocks.constants import WORKSPACE_X, WORKSPACE_Y
from rpg.blocks.evaluate import satisfied
from rpg.blocks.geometry import patch_outline, polygon_gap
from rpg.blocks.nouns import number
from rpg.blocks.predicates import PREDICATES
from rpg.blocks.state import BlockState, World
from rpg.core.diagnostics import Diagnostic, Refusal
from rpg.ir import goal as g
from rpg.ir.assets import GoalPatch
from rpg.ir.node import members
from rpg.ir.relations import On, OnPatch
from rpg.ir.schema import TaskSchema
from rpg.ir.structures import Stack, Towers
from rpg.ir.walk import atoms, instances, names

SPACE = 0.01
"""Room around what lies on a patch, and between its pieces (m)."""
APART = 0.02
"""Least gap between patches (m)."""
LONG = 2.0
"""A patch at least this many times longer than wide is a long one, and stays one."""
LARGEST_SQUARE = 0.20
"""A square patch that would have to be larger (m) becomes a rectangle."""
MOST_DEALT = 5
SHUFFLED_ORDERS = 100
"""All ways to deal so many places to the patches are tried; of more places, so many ways."""
RANDOM_LAYOUTS = 200
TABLE_AREA = (WORKSPACE_X[1] - WORKSPACE_X[0]) * (WORKSPACE_Y[1] - WORKSPACE_Y[0])
CHECKED_LAYOUTS = 12
ARRANGE_TRIES = 1500
Spot = tuple[float, float]
Demand = dict[str, dict[str, None]]


def place_patches(schema: TaskSchema) -> TaskSchema:
    """`schema` with every patch large enough for what must lie on it, and at a place on the table.

    Patches that have a position keep it. Relations between patches that the goal states are honoured.
    """
    if not schema.patches:
        return schema
    world = World(schema.assets)
    demand = _demand(schema.goal, world)
    for goal in schema.init.arranged:
        _merge(demand, _demand(goal, world))
    sized = {p.name: _grown(p, _pieces_on(tuple(demand.get(p.name, ())), schema.goal, world)) for p in schema.patches}
    placed = _placed(schema, sized)
    return schema.model_copy(update={"assets": tuple(placed.get(a.name, a) for a in schema.assets)})


def _demand(goal: g.Goal, world: World) -> Demand:
    """Blocks that must lie on each patch when the goal holds."""
    found: Demand = {}
    match goal:
        case OnPatch():
            found[goal.patch] = dict.fromkeys(members(goal.a))
        case Stack() if goal.patch is not None:
            found[goal.patch] = dict.fromkeys(goal.blocks[:1])
        case Towers() if goal.matching is not None:
            for patch in goal.matching:
                color = world.patches[patch].color
                found[patch] = dict.fromkeys([n for n in goal.blocks if world.blocks[n].color == color][:1])
        case g.Any():
            found = max((_demand(part, world) for part in goal.goals), key=_size, default={})
        case g.Count():
            number = goal.at_least or (len(goal.over) if goal.at_most is None else goal.at_most)
            for part in instances(goal)[:number]:
                _merge(found, _demand(part, world))
        case g.Not():
            pass
        case _:
            for part in _parts(goal):
                _merge(found, _demand(part, world))
    return found


def _parts(goal: g.Goal) -> tuple[g.Goal, ...]:
    match goal:
        case g.All():
            return goal.goals
        case g.Sequence():
            return tuple(stage.goal for stage in goal.stages)
        case g.Always():
            return (goal.goal,)
        case _:
            return ()


def _merge(into: Demand, more: Demand) -> None:
    for patch, blocks in more.items():
        into.setdefault(patch, {}).update(blocks)


def _size(demand: Demand) -> int:
    return sum(len(blocks) for blocks in demand.values())


def _pieces_on(blocks: tuple[str, ...], goal: g.Goal, world: World) -> list[tuple[float, float]]:
    """Extents along x and y of the footprints of the pieces that these blocks form."""
    assembly = _assembly(goal, world)
    pieces: dict[int, Piece] = {}
    for name in blocks:
        pieces.setdefault(id(assembly.of[name]), assembly.of[name])
    extents = []
    for piece in pieces.values():
        own = [(piece.position[n], world.edge[n]) for n in blocks if n in piece.position]
        edge = max(e for _, e in own)
        extents.append(
            (
                max(p[0] for p, _ in own) - min(p[0] for p, _ in own) + edge,
                max(p[1] for p, _ in own) - min(p[1] for p, _ in own) + edge,
            )
        )
    return extents


def _assembly(goal: g.Goal, world: World) -> Assembly:
    """The structures of a goal, laid out the most natural way, without places on the table."""
    assembly = Assembly(world)
    for literals in islice(alternatives(goal, world), 1):
        for atom in (atom for atom, holds, _ in literals if holds):
            bare = atom.model_copy(update={"patch": None}) if isinstance(atom, Stack) else atom
            if isinstance(bare, Towers):
                bare = bare.model_copy(update={"matching": None})
            try:
                for clusters in islice(PREDICATES[bare.kind].build(bare, world, Random(0)), 1):
                    for cluster in clusters:
                        assembly.add(cluster)
                if isinstance(bare, On):
                    assembly.put_on(assembly.resolve(bare.a), assembly.resolve(bare.b))
            except Clash:
                continue
    return assembly


def _grown(patch: GoalPatch, extents: list[tuple[float, float]]) -> GoalPatch:
    """The patch, at least as large as these pieces side by side on it."""
    if not extents:
        return patch
    if len(extents) == 1:
        fits = [extents[0]]
    else:
        cell = [max(e[k] for e in extents) + SPACE for k in (0, 1)]
        shapes = [(-(-len(extents) // columns), columns) for columns in range(1, len(extents) + 1)]
        fits = [(rows * cell[0] - SPACE, columns * cell[1] - SPACE) for rows, columns in shapes]
    sizes = [_enclosing(patch, x + SPACE, y + SPACE) for x, y in fits]
    size = min(sizes, key=lambda s: (s[0] * s[1], abs(s[0] - s[1])))
    shape = "rectangle" if patch.shape == "square" and size[0] != size[1] else patch.shape
    return patch if size == patch.size else patch.model_copy(update={"size": size, "shape": shape})


def _enclosing(patch: GoalPatch, x: float, y: float) -> tuple[float, float]:
    """The least size of this patch's shape, not smaller than it is, that encloses x by y."""
    wide, high = patch.size
    if patch.shape == "circle":
        diameter = _up(max(wide, math.hypot(x, y) if x > wide * 0.7 or y > wide * 0.7 else wide))
        return diameter, diameter
    if patch.shape == "square" and max(x, y) <= LARGEST_SQUARE:
        side = _up(max(wide, x, y))
        return side, side
    new = [_up(max(wide, x)), _up(max(high, y))]
    for k in (0, 1):
        if patch.size[k] >= LONG * patch.size[1 - k] - 1e-9:
            new[k] = max(new[k], _up(LONG * new[1 - k]))
    return new[0], new[1]


def _up(length: float) -> float:
    """Rounded up to half a centimetre."""
    return round(math.ceil(length / 0.005 - 1e-6) * 0.005, 4)


def _placed(schema: TaskSchema, sized: dict[str, GoalPatch]) -> dict[str, GoalPatch]:
    """The patches at the first layout that the goal can be arranged around; else at the first that fits them."""
    goals = [*conditions(schema.goal), *(part for goal in schema.init.arranged for part in conditions(goal))]
    between = [goal for goal in goals if names(goal) and set(names(goal)) <= set(sized)]
    fallback: dict[str, GoalPatch] | None = None
    fits = (layout for layout in _layouts(list(sized.values())) if _honours(layout, between))
    for layout in islice(fits, CHECKED_LAYOUTS):
        world = World(tuple(layout.get(a.name, a) for a in schema.assets))
        if Solver(schema.goal, world, _imagined(schema, world), ARRANGE_TRIES).solve(Random(0)) is not None:
            return layout
        fallback = fallback or layout
    fallback = fallback or next(_layouts(list(sized.values())), None)
    if fallback is None:
        raise Refusal([_no_room(list(sized.values()))])
    return fallback


def _imagined(schema: TaskSchema, world: World) -> BlockState | None:
    """A start, for goals that compare with one."""
    if not any(atom.kind in CHANGES for atom in atoms(schema.goal)):
        return None
    return Solver(g.All(goals=schema.init.arranged), world, None, ARRANGE_TRIES).solve(Random(0))


def _no_room(patches: list[GoalPatch]) -> Diagnostic:
    area = sum(p.size[0] * p.size[1] for p in patches)
    return Diagnostic(
        code="patches-no-room",
        message=f"the {number(len(patches))} patches do not fit on the table side by side",
        hint="use fewer or smaller patches",
        facts={"patches": len(patches), "area_m2": round(area, 4), "available_m2": round(TABLE_AREA, 4)},
        origin="patches",
    )


def _honours(layout: dict[str, GoalPatch], between: list[g.Goal]) -> bool:
    state = BlockState(World(layout.values()), {}, {})
    return all(satisfied(goal, state) for goal in between)


def _layouts(patches: list[GoalPatch]) -> Iterator[dict[str, GoalPatch]]:
    """Places for the patches that have none: in a line, in two, then anywhere; never overlapping, inside the table."""
    free = [p for p in patches if p.position is None]
    if not free:
        yield {p.name: p for p in patches}
        return
    rng = Random(len(patches))
    alike = len({(p.size, p.shape) for p in free}) == 1
    for spots in _spot_lists(free, rng):
        for order in _orders(spots, rng):
            layout = {p.name: p for p in patches}
            for patch, spot in zip(free, order, strict=True):
                layout[patch.name] = patch.model_copy(update={"position": spot})
            if _separate(list(layout.values())):
                yield layout
            elif alike:
                break


def _orders(spots: list[Spot], rng: Random) -> Iterator[tuple[Spot, ...]]:
    """Ways to deal the places: as they are, then all others, or some where there are many."""
    if len(spots) <= MOST_DEALT:
        yield from permutations(spots)
        return
    yield tuple(spots)
    for _ in range(SHUFFLED_ORDERS):
        yield tuple(rng.sample(spots, len(spots)))


def _spot_lists(free: list[GoalPatch], rng: Random) -> Iterator[list[Spot]]:
    middle = (sum(WORKSPACE_X) / 2, sum(WORKSPACE_Y) / 2)
    widths = [p.size[1] for p in free]
    gap = min(0.10, (WORKSPACE_Y[1] - WORKSPACE_Y[0] - sum(widths)) / (len(free) + 1))
    if gap >= APART:
        yield [(middle[0], y) for y in _line(widths, gap, middle[1])]
    depths = [p.size[0] for p in free]
    for rows in (2, 3):
        yield from _rows(free, rows, middle)
    gap = min(0.08, (WORKSPACE_X[1] - WORKSPACE_X[0] - sum(depths)) / (len(free) + 1))
    if gap >= APART:
        yield [(x, middle[1]) for x in reversed(_line(depths, gap, middle[0]))]
    for _ in range(RANDOM_LAYOUTS):
        yield [_anywhere(patch, rng) for patch in free]


def _line(widths: list[float], gap: float, middle: float) -> list[float]:
    """Centres of things side by side around `middle`, the first one at the greatest coordinate."""
    at = middle + (sum(widths) + gap * (len(widths) - 1)) / 2
    centres = []
    for width in widths:
        centres.append(round(at - width / 2, 3))
        at -= width + gap
    return centres


def _rows(free: list[GoalPatch], rows: int, middle: Spot) -> Iterator[list[Spot]]:
    """Places in several rows, each from left to right, the far row first."""
    columns = -(-len(free) // rows)
    deep, wide = max(p.size[0] for p in free), max(p.size[1] for p in free)
    across = min(wide + 0.08, (WORKSPACE_Y[1] - WORKSPACE_Y[0] - wide) / max(columns - 1, 1))
    along = min(deep + 0.06, (WORKSPACE_X[1] - WORKSPACE_X[0] - 0.6 * deep) / (rows - 1))
    if across >= wide + APART - 1e-9 and along >= deep + APART - 1e-9:
        cells = [(r, c) for r in range(rows) for c in range(columns)][: len(free)]
        yield [
            (
                round(middle[0] + ((rows - 1) / 2 - r) * along, 3),
                round(middle[1] + ((columns - 1) / 2 - c) * across, 3),
            )
            for r, c in cells
        ]


def _anywhere(patch: GoalPatch, rng: Random) -> Spot:
    (x0, x1), (y0, y1) = WORKSPACE_X, WORKSPACE_Y
    hx, hy = min(patch.size[0] / 2, (x1 - x0) / 2), min(patch.size[1] / 2, (y1 - y0) / 2)
    return round(rng.uniform(x0 + hx, x1 - hx), 3), round(rng.uniform(y0 + hy, y1 - hy), 3)


def _separate(patches: list[GoalPatch]) -> bool:
    outlines = [patch_outline(p) for p in patches]
    return all(polygon_gap(p, q) >= APART - 1e-9 for i, p in enumerate(outlines) for q in outlines[:i])
