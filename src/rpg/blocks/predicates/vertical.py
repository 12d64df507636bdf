"""on, above, on_table, clear: what rests on what."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator
from random import Random
from typing import Any

import numpy as np

from rpg.blocks.centres import Centres, Mask
from rpg.blocks.geometry import carried, footprint_gap, riders, supporters, table_gap
from rpg.blocks.predicate import NearMiss, Predicate
from rpg.blocks.predicates.common import PAST, set_aside, shift, stand_on, swap, tilted
from rpg.blocks.predicates.plainly import off, perhaps_on
from rpg.blocks.state import BlockState, World
from rpg.blocks.verdict import FALSE, Verdict, at_most, every, holds, some
from rpg.ir.node import Lowest, members
from rpg.ir.relations import Above, Clear, On, OnTable

GROUND = "table"
DIRECTLY = On(a=("a",), b=("b",))
"""The tolerances of one link of a stack."""
LINK = DIRECTLY.gap + 1e-6
"""A block's centre is nowhere lower over the one it is on than half of both edges, but for this much (m)."""


def directly_on(a: str, b: str, state: BlockState, node: On = DIRECTLY) -> Verdict:
    """`a` rests directly on `b`, with the tolerances of `node`."""
    if a == b:
        return FALSE
    ax, ay, _ = state.position[a]
    bx, by, _ = state.position[b]
    edge = state.world.edge
    limit = node.offset_edges * max(edge[a], edge[b]) + node.slack
    margin = min(
        1.0 - abs(state.bottom(a) - state.top(b)) / node.gap,
        1.0 - math.hypot(ax - bx, ay - by) / limit,
        1.0 - state.tilt(a) / node.tilt,
    )
    return holds(margin)


def above(a: str, b: str, state: BlockState) -> Verdict:
    """`a` is above `b` in the same stack: a chain of blocks, each directly on the next, leads from `a` down to `b`."""
    reached, frontier, edge = {a: 1.0}, [a], state.world.edge
    while frontier:
        block = frontier.pop()
        for other, place in state.position.items():
            if state.position[block][2] - place[2] < (edge[block] + edge[other]) / 2 - LINK:
                continue
            link = directly_on(block, other, state)
            margin = min(reached[block], link.margin)
            if link.value and margin > reached.get(other, -1.0):
                reached[other] = margin
                frontier.append(other)
    return holds(reached[b]) if a != b and b in reached else ~holds(_apartness(a, b, state))


def _apartness(a: str, b: str, state: BlockState) -> float:
    """How far `a` is from any place above `b`, in edges; positive."""
    (ax, ay, az), (bx, by, bz) = state.position[a], state.position[b]
    edge = max(state.world.edge[a], state.world.edge[b])
    return max(math.hypot(ax - bx, ay - by) / edge - 0.5, (bz - az) / edge + 0.5, 0.01)


class OnPredicate(Predicate[On]):
    """Each of `a` is directly on one of `b`."""

    def evaluate(self, node: On, state: BlockState) -> Verdict:
        below = state.resolve(node.b)
        return every([some([directly_on(a, b, state, node) for b in below]) for a in state.resolve(node.a)])

    def holds(self, node: On, state: BlockState) -> bool:
        below, edge = state.resolve(node.b), state.world.edge

        def on(a: str, b: str) -> bool:
            reach = node.offset_edges * max(edge[a], edge[b]) + node.slack
            return not off(state, a, b, reach, node.gap) and directly_on(a, b, state, node).value

        return all(any(on(a, b) for b in below) for a in state.resolve(node.a))

    def plainly_not(self, node: On, state: BlockState) -> bool:
        below, edge = state.resolve(node.b), state.world.edge

        def apart(a: str, b: str) -> bool:
            reach = node.offset_edges * max(edge[a], edge[b]) + node.slack
            return a == b or off(state, a, b, 2 * reach, 2 * node.gap)

        return any(all(apart(a, b) for b in below) for a in state.resolve(node.a))

    def perhaps(self, node: On, many: Centres) -> Mask:
        found = many.all()
        if not isinstance(node.a, tuple) or not isinstance(node.b, tuple):
            return found
        below, edge = many.of(node.b), many.edges(node.b)
        for a in node.a:
            own = many.world.edge[a]
            reach = node.offset_edges * np.maximum(own, edge) + node.slack
            found &= perhaps_on(many.of((a,)), below, (own + edge) / 2, reach, node.gap).any(axis=1)
        return found

    def near_misses(self, node: On, state: BlockState, rng: Random) -> Iterator[NearMiss]:
        a = state.resolve(node.a)[0]
        below = state.resolve(node.b)
        b = next(b for b in below if directly_on(a, b, state, node))
        load = carried(state, a)
        (ax, ay, _), (bx, by, _) = state.position[a], state.position[b]
        past = node.offset_edges * max(state.world.edge[a], state.world.edge[b]) + node.slack + PAST
        if len(below) == 1:
            yield NearMiss(f"{a} past the edge of {b}", shift(state, load, bx - ax, by + past - ay))
            yield NearMiss(f"{b} on {a}", swap(state, a, b))
        yield NearMiss(f"{a} floating over {b}", shift(state, load, 0.0, 0.0, node.gap + PAST))
        yield NearMiss(f"{a} tilted on {b}", tilted(state, a, node.tilt + 5.0))
        yield NearMiss(f"{a} set down on the table", set_aside(state, a))

    def supports(self, node: On, world: World) -> Iterable[tuple[str, str]]:
        if len(members(node.a)) == 1 and len(members(node.b)) == 1:
            yield members(node.a)[0], members(node.b)[0]


class AbovePredicate(Predicate[Above]):
    """Each of `a` is above all of `b`."""

    def evaluate(self, node: Above, state: BlockState) -> Verdict:
        below = state.resolve(node.b)
        return every(above(a, b, state) for a in state.resolve(node.a) for b in below)

    def near_misses(self, node: Above, state: BlockState, rng: Random) -> Iterator[NearMiss]:
        a, b = state.resolve(node.a)[0], state.resolve(node.b)[0]
        yield NearMiss(f"{a} set down on the table", set_aside(state, a))
        yield NearMiss(f"{b} above {a}", swap(state, a, b))
        aside = 0.5 * max(state.world.edge[a], state.world.edge[b]) + DIRECTLY.slack + PAST
        below = supporters(state, a)
        if len(below) == 1:
            (ax, ay, _), (bx, by, _) = state.position[a], state.position[below[0]]
            yield NearMiss(
                f"{a} past the edge of {below[0]}", shift(state, carried(state, a), bx - ax, by + aside - ay)
            )


class OnTablePredicate(Predicate[OnTable]):
    """The lowest point of each block is at the table top."""

    def evaluate(self, node: OnTable, state: BlockState) -> Verdict:
        return every(at_most(abs(table_gap(state, a)), node.gap) for a in state.resolve(node.a))

    def near_misses(self, node: OnTable, state: BlockState, rng: Random) -> Iterator[NearMiss]:
        a = state.resolve(node.a)[0]
        yield NearMiss(f"{a} over the table", shift(state, carried(state, a), 0.0, 0.0, node.gap + PAST))
        tops = [n for n in state.position if n not in carried(state, a) and not riders(state, n)]
        if tops and not isinstance(node.a, Lowest):
            yield NearMiss(f"{a} on {tops[0]}", stand_on(state, a, tops[0]))

    def supports(self, node: OnTable, world: World) -> Iterable[tuple[str, str]]:
        if not isinstance(node.a, Lowest):
            yield from ((a, GROUND) for a in members(node.a))


class ClearPredicate(Predicate[Clear]):
    """No block rests on any of these."""

    def evaluate(self, node: Clear, state: BlockState) -> Verdict:
        return every(self._clear(a, state) for a in state.resolve(node.a))

    def _clear(self, name: str, state: BlockState) -> Verdict:
        loads = riders(state, name)
        if not loads:
            return Verdict(True, 1.0)
        edge = state.world.edge[name]
        return Verdict(False, min(footprint_gap(state, load, name) for load in loads) / edge)

    def near_misses(self, node: Clear, state: BlockState, rng: Random) -> Iterator[NearMiss]:
        a = state.resolve(node.a)[0]
        other = next(
            (n for n in state.position if n != a and not riders(state, n) and n not in supporters(state, a)), None
        )
        if other is not None:
            yield NearMiss(f"{other} on {a}", stand_on(state, other, a))
            edge = max(state.world.edge[a], state.world.edge[other])
            yield NearMiss(f"{other} half on {a}", shift(stand_on(state, other, a), [other], 0.0, 0.4 * edge))


TABLE: dict[str, Predicate[Any]] = {
    "on": OnPredicate(),
    "above": AbovePredicate(),
    "on_table": OnTablePredicate(),
    "clear": ClearPredicate(),
}
