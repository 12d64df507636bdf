"""between: on the way from one thing to another, on the table or up a tower."""

from __future__ import annotations

import math
from collections.abc import Iterator
from random import Random
from typing import Any

from rpg.blocks.geometry import carried
from rpg.blocks.predicate import NearMiss, Predicate
from rpg.blocks.predicates.common import PAST, set_aside, shift, swap
from rpg.blocks.predicates.direction import edge_between
from rpg.blocks.predicates.vertical import above
from rpg.blocks.state import BlockState
from rpg.blocks.verdict import FALSE, Verdict, every, holds, some
from rpg.ir.node import members
from rpg.ir.relations import Between


def along_segment(a: str, b: str, c: str, state: BlockState) -> tuple[float, float, float]:
    """Where the foot of `a` lies on the segment from `b` to `c` (0 to 1), its distance from the line, the length."""
    (ax, ay, _), (bx, by, _), (cx, cy, _) = state.where(a), state.where(b), state.where(c)
    ux, uy = cx - bx, cy - by
    length = math.hypot(ux, uy)
    if length < 1e-9:
        return -1.0, math.hypot(ax - bx, ay - by), 0.0
    share = ((ax - bx) * ux + (ay - by) * uy) / (length * length)
    return share, abs((ax - bx) * uy - (ay - by) * ux) / length, length


class BetweenPredicate(Predicate[Between]):
    """Each of `a` lies between a member of `b` and one of `c`."""

    def evaluate(self, node: Between, state: BlockState) -> Verdict:
        ends = [(b, c) for b in state.resolve(node.b) for c in state.resolve(node.c) if b != c]
        return every(
            [some([self._between(node, a, b, c, state) for b, c in ends]) for a in state.resolve(node.a)],
        )

    def _between(self, node: Between, a: str, b: str, c: str, state: BlockState) -> Verdict:
        if a in (b, c):
            return FALSE
        if all(name in state.position for name in (a, b, c)):
            low, high = (b, c) if state.position[b][2] <= state.position[c][2] else (c, b)
            if above(high, low, state):
                return above(high, a, state) & above(a, low, state)
        share, off, length = along_segment(a, b, c, state)
        edge = max(edge_between(state, a, b), edge_between(state, a, c))
        inside = min(share, 1.0 - share) * length / edge
        # The ends themselves do not count as between: exactly there is outside.
        return holds(min(inside - 1e-5, 1.0 - off / (node.within_edges * edge)))

    def propose(self, node: Between, block: str, state: BlockState, rng: Random) -> Iterator[tuple[float, float]]:
        placed = [n for n in (*members(node.b), *members(node.c)) if n in state.position or n in state.world.patches]
        if block in members(node.a) and len(placed) >= 2:
            (bx, by, _), (cx, cy, _) = state.where(placed[0]), state.where(placed[-1])
            for share in (0.5, 0.4, 0.6, 0.3, 0.7):
                yield bx + share * (cx - bx), by + share * (cy - by)
            return
        spread = 3.4 * state.world.edge.get(block, 0.04)
        for other in placed if not any(n in state.position for n in members(node.a)) else ():
            (ox, oy, _) = state.where(other)
            yield from ((ox + dx, oy + dy) for dx, dy in ((0.0, spread), (0.0, -spread), (spread, 0.0), (-spread, 0.0)))
        anchors = [n for n in members(node.a) if n in state.position]
        for anchor, other in ((a, o) for a in anchors for o in placed if block not in (a, o)):
            (ax, ay, _), (ox, oy, _) = state.where(anchor), state.where(other)
            yield 2 * ax - ox, 2 * ay - oy

    def near_misses(self, node: Between, state: BlockState, rng: Random) -> Iterator[NearMiss]:
        a, b, c = state.resolve(node.a)[0], state.resolve(node.b)[0], state.resolve(node.c)[0]
        if a not in state.position or len(state.resolve(node.b)) * len(state.resolve(node.c)) > 1:
            return
        if {b, c} <= state.position.keys() and (above(b, c, state) or above(c, b, state)):
            yield NearMiss(f"{a} set down on the table", set_aside(state, a))
            yield NearMiss(f"{a} and {b} exchanged", swap(state, a, b))
            return
        (ax, ay, _), (bx, by, _), (cx, cy, _) = state.where(a), state.where(b), state.where(c)
        length = math.hypot(cx - bx, cy - by)
        ux, uy = (cx - bx) / length, (cy - by) / length
        edge = max(edge_between(state, a, b), edge_between(state, a, c))
        off = node.within_edges * edge + PAST
        load = carried(state, a)
        mx, my = (bx + cx) / 2 - ax, (by + cy) / 2 - ay
        yield NearMiss(f"{a} off the line from {b} to {c}", shift(state, load, mx - off * uy, my + off * ux))
        for end, (ex, ey), sign in ((b, (bx, by), -1.0), (c, (cx, cy), 1.0)):
            beyond = shift(state, load, ex + sign * edge * ux - ax, ey + sign * edge * uy - ay)
            yield NearMiss(f"{a} beyond {end}", beyond)


TABLE: dict[str, Predicate[Any]] = {"between": BetweenPredicate()}
