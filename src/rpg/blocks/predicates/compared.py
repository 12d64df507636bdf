"""closer, equidistant: distances from one thing compared with each other."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from itertools import islice, product
from random import Random
from typing import Any

from rpg.blocks.geometry import carried, plane_distance
from rpg.blocks.predicate import NearMiss, Predicate
from rpg.blocks.predicates.common import PAST, shift
from rpg.blocks.predicates.proximity import ring
from rpg.blocks.state import BlockState
from rpg.blocks.verdict import Verdict, at_least, at_most, every
from rpg.ir.node import members
from rpg.ir.relations import Closer, Equidistant

CLOSE = 0.07
"""How close to what it is to be closer to a block is put first, in metres."""
BEYOND = 0.05
"""How much farther than that what is to be farther is put first, in metres."""
ALONG = (0.0, 0.06, -0.06, 0.1, -0.1, 0.03, -0.03)
"""Where on the line of places that are as far from one end as from the other a block is tried, in metres."""
HALVINGS = 40

Measure = Callable[[BlockState], float]


class CloserPredicate(Predicate[Closer]):
    """Each of `a` is closer to each of `b` than to any of `c`."""

    def evaluate(self, node: Closer, state: BlockState) -> Verdict:
        triples = _triples(node, state)
        return every(at_least(lead(state, *triple), node.by, node.by or 0.01) for triple in triples)

    def propose(self, node: Closer, block: str, state: BlockState, rng: Random) -> Iterator[tuple[float, float]]:
        hubs, ends, others = (_placed(part, block, state) for part in (node.a, node.b, node.c))
        if block in members(node.a):
            for x, y in ends:
                for u, v in others:
                    off = math.hypot(x - u, y - v) or 1.0
                    yield x + CLOSE * (x - u) / off, y + CLOSE * (y - v) / off
                yield from ring(x, y, CLOSE, rng)
            return
        nearer = block in members(node.b)
        for x, y in hubs:
            far = [math.hypot(x - u, y - v) for u, v in (others if nearer else ends)]
            if nearer:
                yield from ring(x, y, min([CLOSE, *(0.6 * off for off in far)]), rng)
            else:
                yield from ring(x, y, max(far, default=2 * CLOSE) + BEYOND, rng)

    def near_misses(self, node: Closer, state: BlockState, rng: Random) -> Iterator[NearMiss]:
        a, b, c = min(_triples(node, state), key=lambda triple: lead(state, *triple))
        short = node.by - PAST
        found: list[BlockState | None] = []
        if a in state.position:
            found.append(_toward(state, a, c, lambda at: lead(at, a, b, c) - short))
        found += _farther(state, c, a, plane_distance(state, a, b) + short)
        found += _farther(state, b, a, plane_distance(state, a, c) - short)
        yield from islice(_spoilt(self, node, found, f"{a} hardly closer to {b} than to {c}"), 1)


class EquidistantPredicate(Predicate[Equidistant]):
    """Each of `a` is at one distance from all of `b` and `c`."""

    def evaluate(self, node: Equidistant, state: BlockState) -> Verdict:
        ends = (*state.resolve(node.b), *state.resolve(node.c))
        spreads = [spread(state, a, ends) for a in state.resolve(node.a)]
        return every(at_most(wide, node.tolerance, node.tolerance or 0.01) for wide in spreads)

    def propose(self, node: Equidistant, block: str, state: BlockState, rng: Random) -> Iterator[tuple[float, float]]:
        ends = [*_placed(node.b, block, state), *_placed(node.c, block, state)]
        if block not in members(node.a):
            for x, y in _placed(node.a, block, state):
                for u, v in ends[:1]:
                    yield from ring(x, y, math.hypot(x - u, y - v), rng)
            return
        if len(ends) > 2 and (middle := _circumcentre(*ends[:3])) is not None:
            yield middle
        elif len(ends) > 1:
            (x, y), (u, v) = ends[:2]
            off = math.hypot(x - u, y - v) or 1.0
            for t in ALONG:
                yield (x + u) / 2 + t * (v - y) / off, (y + v) / 2 - t * (u - x) / off

    def near_misses(self, node: Equidistant, state: BlockState, rng: Random) -> Iterator[NearMiss]:
        ends = (*state.resolve(node.b), *state.resolve(node.c))
        a = max(state.resolve(node.a), key=lambda name: spread(state, name, ends))
        ranked = sorted(ends, key=lambda end: plane_distance(state, a, end))
        near, far = ranked[0], ranked[-1]
        past = node.tolerance + PAST
        found: list[BlockState | None] = []
        if a in state.position:
            found.append(_toward(state, a, near, lambda at: past - spread(at, a, ends)))
        found += _farther(state, far, a, plane_distance(state, a, near) + past)
        found += _farther(state, near, a, plane_distance(state, a, far) + past)
        yield from islice(_spoilt(self, node, found, f"{far} farther from {a} than {near}"), 1)


def _farther(state: BlockState, end: str, hub: str, far: float) -> list[BlockState | None]:
    """`end` so far from `hub`: with what it carries, and alone."""
    if end not in state.position or far < 0.0:
        return []
    (x, y, _), (u, v, _) = state.where(end), state.where(hub)
    off = math.hypot(x - u, y - v)
    dx, dy = ((x - u) / off, (y - v) / off) if off > 1e-6 else (0.0, 1.0)
    step = far - off
    return [shift(state, load, step * dx, step * dy) for load in (carried(state, end), [end])]


def _spoilt(predicate: Predicate[Any], node: Any, states: list[BlockState | None], what: str) -> Iterator[NearMiss]:
    """Those of some states in which the atom does not hold."""
    yield from (NearMiss(what, at) for at in states if at is not None and not predicate.evaluate(node, at).value)


def lead(state: BlockState, a: str, b: str, c: str) -> float:
    """How much closer `a` is to `b` than to `c`, in metres."""
    return plane_distance(state, a, c) - plane_distance(state, a, b)


def spread(state: BlockState, a: str, ends: tuple[str, ...]) -> float:
    """By how much the distances of `a` from some others differ, in metres."""
    far = [plane_distance(state, a, end) for end in ends]
    return max(far) - min(far)


def _triples(node: Closer, state: BlockState) -> list[tuple[str, str, str]]:
    """Every member of `a`, of `b` and of `c`."""
    return [(a, b, c) for a, b, c in product(*(state.resolve(operand) for operand in (node.a, node.b, node.c)))]


def _placed(operand: Any, block: str, state: BlockState) -> list[tuple[float, float]]:
    """Centres of the members of an operand that are placed already."""
    there = [n for n in members(operand) if n != block and (n in state.position or n in state.world.patches)]
    return [state.where(name)[:2] for name in there]


def _toward(state: BlockState, a: str, c: str, left: Measure) -> BlockState | None:
    """`a` moved towards `c`, with what it carries, until nothing is `left`; None where that does not come about."""
    load = carried(state, a)
    if c in load:
        return None
    (ax, ay, _), (cx, cy, _) = state.where(a), state.where(c)

    def moved(share: float) -> BlockState:
        return shift(state, load, share * (cx - ax), share * (cy - ay))

    low, high = 0.0, 1.0
    if left(moved(high)) > 0.0:
        return None
    for _ in range(HALVINGS):
        middle = (low + high) / 2
        low, high = (middle, high) if left(moved(middle)) > 0.0 else (low, middle)
    return moved(high)


def _circumcentre(
    one: tuple[float, float], two: tuple[float, float], three: tuple[float, float]
) -> tuple[float, float] | None:
    """The point as far from one as from the others; None where they are in line."""
    (ax, ay), (bx, by), (cx, cy) = one, two, three
    bx, by, cx, cy = bx - ax, by - ay, cx - ax, cy - ay
    area = 2 * (bx * cy - by * cx)
    if abs(area) < 1e-6:
        return None
    b, c = bx * bx + by * by, cx * cx + cy * cy
    return ax + (cy * b - by * c) / area, ay + (bx * c - cx * b) / area


TABLE: dict[str, Predicate[Any]] = {"closer": CloserPredicate(), "equidistant": EquidistantPredicate()}
