"""in_region: halves, corners, edges and the middle of the table, as the viewer names them."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from functools import cache, lru_cache
from random import Random
from typing import Any

from rpg.blocks.constants import WORKSPACE_X, WORKSPACE_Y
from rpg.blocks.geometry import carried
from rpg.blocks.predicate import NearMiss, Predicate
from rpg.blocks.predicates.common import shift
from rpg.blocks.state import BlockState
from rpg.blocks.verdict import Verdict, every, holds
from rpg.ir.node import members
from rpg.ir.relations import InRegion, Region

CORNER = (0.10, 0.12)
"""Depth of a corner along x and y."""
MIDDLE_RADIUS = 0.08
EDGE_DEPTH = 0.05
DIRECTIONS = ((1, 0), (-1, 0), (0, 1), (0, -1), (1, 1), (1, -1), (-1, 1), (-1, -1))
INSET = 0.025
"""How far inside of the workspace's border proposals lie."""

CORNERS: tuple[Region, ...] = ("near_left_corner", "near_right_corner", "far_left_corner", "far_right_corner")
EDGES: tuple[Region, ...] = ("left_edge", "right_edge", "near_edge", "far_edge")
MIDDLE = (sum(WORKSPACE_X) / 2, sum(WORKSPACE_Y) / 2)
BEST = 12
"""So many of the places that are farthest inside of a region are proposed."""
Place = tuple[float, float]


_INWARD: dict[str, Callable[[float, float], float]] = {
    "near": lambda x, _: x - WORKSPACE_X[0],
    "far": lambda x, _: WORKSPACE_X[1] - x,
    "right": lambda _, y: y - WORKSPACE_Y[0],
    "left": lambda _, y: WORKSPACE_Y[1] - y,
}
"""Distance inward from each side of the workspace."""
_BEYOND: dict[str, Callable[[float, float], float]] = {
    "near": lambda x, _: MIDDLE[0] - x,
    "far": lambda x, _: x - MIDDLE[0],
    "right": lambda _, y: MIDDLE[1] - y,
    "left": lambda _, y: y - MIDDLE[1],
}
"""Distance beyond the middle towards each side."""


def region_margin(region: Region, x: float, y: float, edge: float) -> float:
    """Slack of a centre in a region, over the tolerance of that region."""
    return _margin_in(region)(x, y, edge)


@cache
def _margin_in(region: Region) -> Callable[[float, float, float], float]:
    """The slack in a region of a block's centre (x, y), by the block's edge too."""
    if region in ("corner", "edge"):
        parts = [_margin_in(part) for part in (CORNERS if region == "corner" else EDGES)]
        return lambda x, y, edge: max([margin(x, y, edge) for margin in parts])
    match region.split("_"):
        case ["middle"]:
            return lambda x, y, _: 1.0 - math.hypot(x - MIDDLE[0], y - MIDDLE[1]) / MIDDLE_RADIUS
        case [side, "half"]:
            beyond = _BEYOND[side]
            return lambda x, y, edge: (beyond(x, y) - edge / 2) / (edge / 2)
        case [side, "edge"]:
            inward = _INWARD[side]
            return lambda x, y, _: 1.0 - inward(x, y) / EDGE_DEPTH
        case [depth, side, "corner"]:
            along, across = _INWARD[depth], _INWARD[side]
            return lambda x, y, _: min(1.0 - along(x, y) / CORNER[0], 1.0 - across(x, y) / CORNER[1])
    raise ValueError(f"there is no region {region!r}")


class InRegionPredicate(Predicate[InRegion]):
    """Each centre lies in the region."""

    def evaluate(self, node: InRegion, state: BlockState) -> Verdict:
        names = state.resolve(node.a)
        if len(names) == 1:
            return self._in(node.region, names[0], state)
        return every([self._in(node.region, name, state) for name in names])

    def _in(self, region: Region, name: str, state: BlockState) -> Verdict:
        x, y, _ = state.where(name)
        return holds(region_margin(region, x, y, state.world.edge.get(name, 0.04)))

    def propose(self, node: InRegion, block: str, state: BlockState, rng: Random) -> Iterator[tuple[float, float]]:
        if block not in members(node.a):
            return
        if len(members(node.a)) > 1:
            yield from side_by_side(node.region, state.world.edge[block])
            return
        best, good = _rated(node.region)
        draws = [rng.random() for _ in _grid()]
        yield from (place for *_, place in sorted([(-margin, draws[k], place) for k, margin, place in best])[:BEST])
        places = list(good)
        rng.shuffle(places)
        yield from places[:24]

    def near_misses(self, node: InRegion, state: BlockState, rng: Random) -> Iterator[NearMiss]:
        a = next((n for n in state.resolve(node.a) if n in state.position), None)
        if a is None:
            return
        x, y, _ = state.position[a]
        edge = state.world.edge[a]
        out = (_way_out(node.region, x, y, edge), "just outside of"), (_farthest(node.region, edge), "far from")
        for place, what in out:
            yield NearMiss(f"{a} {what} the region", shift(state, carried(state, a), place[0] - x, place[1] - y))


@cache
def _grid() -> list[Place]:
    """Places all over the workspace, 2.5 cm apart."""
    (x0, x1), (y0, y1) = WORKSPACE_X, WORKSPACE_Y
    xs = [x0 + INSET + k * (x1 - x0 - 2 * INSET) / 10 for k in range(11)]
    ys = [y0 + INSET + k * (y1 - y0 - 2 * INSET) / 18 for k in range(19)]
    return [(x, y) for x in xs for y in ys]


@lru_cache(maxsize=32)
def _rated(region: Region) -> tuple[list[tuple[int, float, Place]], list[Place]]:
    """For a block of the usual size, the places among which the BEST in a region are, each with its number and its
    slack; and all the good ones."""
    rated = [(k, region_margin(region, *place, 0.04), place) for k, place in enumerate(_grid())]
    least = sorted((margin for _, margin, _ in rated), reverse=True)[BEST - 1]
    return [found for found in rated if found[1] >= least], [place for _, margin, place in rated if margin > 0.2]


@lru_cache(maxsize=64)
def _farthest(region: Region, edge: float) -> Place:
    """The place that is least in a region."""
    return min(_grid(), key=lambda place: region_margin(region, place[0], place[1], edge))


@lru_cache(maxsize=32)
def side_by_side(region: Region, edge: float) -> tuple[tuple[float, float], ...]:
    """Places in a region at which blocks stand close together, from the corner or the edge on which it borders."""
    pitch = 1.25 * edge
    axes = []
    for (low, high), from_high in ((WORKSPACE_X, "far" in region), (WORKSPACE_Y, "left" in region)):
        steps = range(int((high - low - 2 * INSET) / pitch) + 1)
        axes.append([high - INSET - k * pitch if from_high else low + INSET + k * pitch for k in steps])
    places = [(x, y) for x in axes[0] for y in axes[1] if region_margin(region, x, y, edge) > 0.05]
    return tuple(sorted(places, key=lambda place: -region_margin(region, place[0], place[1], edge)))


def _way_out(region: Region, x: float, y: float, edge: float) -> tuple[float, float]:
    """The nearest place outside of a region, along an axis or slantwise."""
    for step in range(1, 100):
        for dx, dy in DIRECTIONS:
            place = (x + 0.005 * step * dx, y + 0.005 * step * dy)
            outside = min(inward(*place) for inward in _INWARD.values()) < 0.0
            if not outside and region_margin(region, *place, edge) < -0.02:
                return place
    return _farthest(region, edge)


TABLE: dict[str, Predicate[Any]] = {"in_region": InRegionPredicate()}
