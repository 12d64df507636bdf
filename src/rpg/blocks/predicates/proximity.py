"""beside, adjacent, touching, near, apart, distance: how close things are."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from random import Random
from typing import Any

from rpg.blocks.geometry import body_gap, carried, footprint_gap, plainly_apart, plane_distance, reach, rests_on, riders
from rpg.blocks.predicate import NearMiss, Predicate
from rpg.blocks.predicates.common import PAST, place_beside, set_aside, shift, stand_on
from rpg.blocks.predicates.direction import edge_between
from rpg.blocks.state import BlockState
from rpg.blocks.verdict import Verdict, at_least, at_most, every, holds, some
from rpg.ir.node import members
from rpg.ir.relations import Adjacent, Apart, Beside, Distance, Near, Touching

LEVEL_GAP = 0.01
LEVEL_TILT = 15.0
RING_TRIES = 8


def level(a: str, b: str, state: BlockState) -> Verdict:
    """Both stand at one height, neither of them tilted; a patch is as high as the table."""
    parts = [1.0 - state.tilt(n) / LEVEL_TILT for n in (a, b) if n in state.position]
    bottoms = [state.bottom(n) if n in state.position else state.where(n)[2] for n in (a, b)]
    return holds(min(*parts, 1.0 - abs(bottoms[0] - bottoms[1]) / LEVEL_GAP))


def pairs(node: Any, state: BlockState) -> list[tuple[str, str]]:
    """Every pair of a member of `a` and another of `b`."""
    return [(a, b) for a in state.resolve(node.a) for b in state.resolve(node.b) if a != b]


def beside(a: str, b: str, state: BlockState, gap_edges: float) -> Verdict:
    """Level, and the gap between the footprints within the limit."""
    gap = footprint_gap(state, a, b)
    edge = edge_between(state, a, b)
    if a in state.position and b in state.position:
        overlap = holds(1.0 + min(gap, 0.0) / LEVEL_GAP)
        return level(a, b, state) & overlap & at_most(max(gap, 0.0), gap_edges * edge)
    return level(a, b, state) & holds(gap / edge) & at_most(gap, gap_edges * edge)


def apart_by(what: str, a: str, b: str, gap: float, state: BlockState) -> NearMiss:
    """`a` moved along the axis on which it is farthest from `b` until their footprints are `gap` apart."""
    (ax, ay, _), (bx, by, _) = state.where(a), state.where(b)
    sizes = tuple(p + q for p, q in zip(reach(state, a), reach(state, b), strict=True))
    if abs(ax - bx) > abs(ay - by):
        dx, dy = math.copysign(sizes[0] + gap, ax - bx), 0.0
    else:
        dx, dy = 0.0, math.copysign(sizes[1] + gap, ay - by)
    return NearMiss(what, place_beside(state, a, b, dx, dy))


def centres_apart_by(what: str, a: str, b: str, distance: float, state: BlockState) -> NearMiss:
    """`a` moved on the ray from `b` until their centres are `distance` apart."""
    (ax, ay, _), (bx, by, _) = state.where(a), state.where(b)
    now = math.hypot(ax - bx, ay - by)
    ux, uy = ((ax - bx) / now, (ay - by) / now) if now > 1e-6 else (0.0, 1.0)
    return NearMiss(what, place_beside(state, a, b, distance * ux, distance * uy))


def single_pair(node: Any, state: BlockState) -> tuple[str, str] | None:
    """The two objects of a relation between one and one, at least one of them a block."""
    found = pairs(node, state)
    return found[0] if len(found) == 1 and not state.position.keys().isdisjoint(found[0]) else None


class BesidePredicate(Predicate[Any]):
    """Some member of `a` is beside one of `b`."""

    def near_misses(self, node: Beside | Adjacent, state: BlockState, rng: Random) -> Iterator[NearMiss]:
        pair = single_pair(node, state)
        if pair is None:
            return
        a, b = pair
        gap = node.gap_edges * edge_between(state, a, b)
        yield apart_by(f"{a} too far from {b}", a, b, gap + PAST, state)
        if a in state.position and b in state.position:
            yield NearMiss(f"{a} higher than {b}", shift(state, carried(state, a), 0.0, 0.0, LEVEL_GAP + PAST))
            if not riders(state, b):
                yield NearMiss(f"{a} on {b}", stand_on(state, a, b))

    def evaluate(self, node: Beside | Adjacent, state: BlockState) -> Verdict:
        return some([beside(a, b, state, node.gap_edges) for a, b in pairs(node, state)])

    def propose(self, node: Any, block: str, state: BlockState, rng: Random) -> Iterator[tuple[float, float]]:
        yield from side_places(node, block, state, node.gap_edges, rng)


class TouchingPredicate(Predicate[Touching]):
    """The bodies of some member of `a` and one of `b` are at most a hair apart."""

    def evaluate(self, node: Touching, state: BlockState) -> Verdict:
        return some([at_most(max(body_gap(state, a, b), 0.0), node.gap) for a, b in pairs(node, state)])

    def holds(self, node: Touching, state: BlockState) -> bool:
        return any(
            not plainly_apart(state, a, b, node.gap) and at_most(max(body_gap(state, a, b), 0.0), node.gap).value
            for a, b in pairs(node, state)
        )

    def plainly_not(self, node: Touching, state: BlockState) -> bool:
        return all(plainly_apart(state, a, b, 2 * node.gap) for a, b in pairs(node, state))

    def propose(self, node: Touching, block: str, state: BlockState, rng: Random) -> Iterator[tuple[float, float]]:
        for x, y, other in _others(node, block, state):
            close = (state.world.edge[block] + state.world.edge[other]) / 2
            # "in front of" asks for a whole edge, so that exactly that far is on the brink
            for far in (close + node.gap / 2, close):
                yield from ((x + dx * far, y + dy * far) for dx, dy in _shuffled(SIDES, rng))

    def near_misses(self, node: Touching, state: BlockState, rng: Random) -> Iterator[NearMiss]:
        pair = single_pair(node, state)
        if pair is None:
            return
        a, b = pair
        upper, lower = (a, b) if state.position[a][2] >= state.position[b][2] else (b, a)
        if rests_on(state, upper, lower):
            lifted = shift(state, carried(state, upper), 0.0, 0.0, 1.4 * node.gap)
            yield NearMiss(f"{upper} not quite down on {lower}", lifted)
            yield NearMiss(f"{upper} set down on the table", set_aside(state, upper))
        else:
            yield apart_by(f"a gap between {a} and {b}", a, b, 1.4 * node.gap, state)


class NearPredicate(Predicate[Near]):
    """The nearest members are close."""

    def evaluate(self, node: Near, state: BlockState) -> Verdict:
        return some([at_most(plane_distance(state, a, b), node.distance) for a, b in pairs(node, state)])

    def propose(self, node: Near, block: str, state: BlockState, rng: Random) -> Iterator[tuple[float, float]]:
        for x, y, _ in _others(node, block, state):
            yield from ring(x, y, 0.7 * node.distance, rng)

    def near_misses(self, node: Near, state: BlockState, rng: Random) -> Iterator[NearMiss]:
        pair = single_pair(node, state)
        if pair is not None:
            yield centres_apart_by(f"{pair[0]} too far from {pair[1]}", *pair, node.distance + PAST, state)


class ApartPredicate(Predicate[Apart]):
    """Even the nearest members are far from each other."""

    def evaluate(self, node: Apart, state: BlockState) -> Verdict:
        return every([at_least(plane_distance(state, a, b), node.distance) for a, b in pairs(node, state)])

    def near_misses(self, node: Apart, state: BlockState, rng: Random) -> Iterator[NearMiss]:
        a, b = min(pairs(node, state), key=lambda pair: plane_distance(state, *pair))
        if a in state.position or b in state.position:
            yield centres_apart_by(f"{a} too near {b}", a, b, node.distance - PAST, state)


class DistancePredicate(Predicate[Distance]):
    """The distance in the plane lies in a range: of the nearest members, where there are several."""

    def evaluate(self, node: Distance, state: BlockState) -> Verdict:
        measure: Callable[[BlockState, str, str], float]
        measure = plane_distance if node.measure == "centres" else footprint_gap
        value = min(measure(state, a, b) for a, b in pairs(node, state))
        parts = []
        scale = range_scale(node)
        if node.minimum is not None:
            parts.append(at_least(value, node.minimum, scale))
        if node.maximum is not None:
            parts.append(at_most(value, node.maximum, scale))
        return every(parts)

    def propose(self, node: Distance, block: str, state: BlockState, rng: Random) -> Iterator[tuple[float, float]]:
        middle = range_middle(node)
        for x, y, other in _others(node, block, state):
            if node.measure == "centres":
                yield from ring(x, y, middle, rng)
            else:
                edge = state.world.edge
                far = middle + (edge.get(other, 0.1) + edge.get(block, 0.1)) / 2
                yield from ((x + dx * far, y + dy * far) for dx, dy in _shuffled(SIDES, rng))

    def near_misses(self, node: Distance, state: BlockState, rng: Random) -> Iterator[NearMiss]:
        pair = single_pair(node, state)
        if pair is None:
            return
        place = centres_apart_by if node.measure == "centres" else apart_by
        if node.minimum is not None and node.minimum > PAST:
            yield place(f"{pair[0]} too near {pair[1]}", *pair, node.minimum - PAST, state)
        if node.maximum is not None:
            yield place(f"{pair[0]} too far from {pair[1]}", *pair, node.maximum + PAST, state)


SIDES = ((1.0, 0.0), (-1.0, 0.0), (0.0, 1.0), (0.0, -1.0))


def side_places(
    node: Any, block: str, state: BlockState, gap_edges: float, rng: Random
) -> Iterator[tuple[float, float]]:
    """Places at the four sides of what is placed already, in the middle of the allowed gap."""
    for x, y, other in _others(node, block, state):
        edge = state.world.edge
        sizes = state.world.patches[other].size if other in state.world.patches else (edge[other], edge[other])
        gap = gap_edges * max(edge.get(block, 0.0), edge.get(other, 0.0)) / 2
        for dx, dy in _shuffled(SIDES, rng):
            far = (sizes[0] if dx else sizes[1]) / 2 + edge.get(block, 0.1) / 2 + gap
            yield x + dx * far, y + dy * far


def ring(x: float, y: float, radius: float, rng: Random) -> Iterator[tuple[float, float]]:
    """Places on a circle: along the axes first, then anywhere."""
    turns = [k * math.pi / 2 for k in range(4)]
    rng.shuffle(turns)
    turns += [rng.uniform(0.0, 2 * math.pi) for _ in range(RING_TRIES)]
    yield from ((x + radius * math.cos(t), y + radius * math.sin(t)) for t in turns)


def range_scale(node: Distance) -> float:
    """What slack in a distance is measured by: half of the range, or a centimetre."""
    if node.minimum is not None and node.maximum is not None and node.maximum > node.minimum:
        return (node.maximum - node.minimum) / 2
    return 0.01


def range_middle(node: Distance) -> float:
    """A distance well inside of the range."""
    low = node.minimum or 0.0
    return (low + node.maximum) / 2 if node.maximum is not None else low + 0.02


def _others(node: Any, block: str, state: BlockState) -> Iterator[tuple[float, float, str]]:
    """Centres of the other side's members that are placed already."""
    mine, theirs = members(node.a), members(node.b)
    if block not in mine:
        mine, theirs = theirs, mine
    for other in theirs:
        if other != block and (other in state.position or other in state.world.patches):
            x, y, _ = state.where(other)
            yield x, y, other


def _shuffled(sides: tuple[tuple[float, float], ...], rng: Random) -> list[tuple[float, float]]:
    return rng.sample(sides, len(sides))


TABLE: dict[str, Predicate[Any]] = {
    "beside": BesidePredicate(),
    "adjacent": BesidePredicate(),
    "touching": TouchingPredicate(),
    "near": NearPredicate(),
    "apart": ApartPredicate(),
    "distance": DistancePredicate(),
}
