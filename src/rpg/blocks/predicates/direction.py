"""left_of, right_of, in_front_of, behind: the viewer's directions on the table."""

from __future__ import annotations

from collections.abc import Iterator
from random import Random
from typing import Any

import numpy as np

from rpg.blocks.centres import Centres, Mask
from rpg.blocks.geometry import footprint_gap, reach
from rpg.blocks.predicate import NearMiss, Predicate
from rpg.blocks.predicates.common import PAST, place_beside
from rpg.blocks.predicates.plainly import ROOM
from rpg.blocks.state import BlockState, World
from rpg.blocks.verdict import Verdict, at_most, every, holds
from rpg.ir.node import members
from rpg.ir.relations import Directional

DIRECTIONS: dict[str, tuple[float, float]] = {
    "left_of": (0.0, 1.0),
    "right_of": (0.0, -1.0),
    "in_front_of": (-1.0, 0.0),
    "behind": (1.0, 0.0),
}
"""The unit vector from `b` to `a`."""
WORDS = {"left_of": "left of", "right_of": "right of", "in_front_of": "in front of", "behind": "behind"}


def edge_between(state: BlockState, a: str, b: str) -> float:
    """The larger edge of the blocks among the two, the measure of relative distances."""
    one, other = state.world.edge.get(a), state.world.edge.get(b)
    if one is None or other is None:
        return one or other or 0.04
    return max(one, other)


def offsets(kind: str, a: str, b: str, state: BlockState) -> tuple[float, float]:
    """Offset of `a` from `b` along the direction, and the distance across it."""
    ux, uy = DIRECTIONS[kind]
    ax, ay, _ = state.where(a)
    bx, by, _ = state.where(b)
    dx, dy = ax - bx, ay - by
    return dx * ux + dy * uy, abs(dx * uy - dy * ux)


def _across(kind: str, a: str, b: str, state: BlockState) -> float:
    """How far `a` is from `b` across the direction, to which side of it told by the sign."""
    ux, uy = DIRECTIONS[kind]
    (ax, ay, _), (bx, by, _) = state.where(a), state.where(b)
    return (ax - bx) * uy - (ay - by) * ux


def _shadowed(left: tuple[str, ...], right: tuple[str, ...]) -> tuple[tuple[str, ...], tuple[str, ...]]:
    """Of two groups the smaller, of which each block has to be straight before or behind the other one."""
    return (left, right) if len(left) <= len(right) else (right, left)


def least_offset(node: Directional, a: str, b: str, state: BlockState) -> float:
    """The least offset along the axis: so many edges, and for a patch at least to its outline."""
    return _least(node, a, b, edge_between(state, a, b), state)


def _least(node: Directional, a: str, b: str, edge: float, state: BlockState) -> float:
    patches, asked = state.world.patches, node.min_edges * edge
    if a not in patches and b not in patches:
        return asked
    k = 0 if DIRECTIONS[str(node.kind)][0] else 1  # type: ignore[attr-defined]
    return max(asked, sum(patches[n].size[k] / 2 for n in (a, b) if n in patches))


class DirectionalPredicate(Predicate[Directional]):
    """Offset along the axis, a 45-degree cone for single blocks, and what directly and immediately add."""

    def __init__(self, kind: str) -> None:
        self.kind = kind

    def evaluate(self, node: Directional, state: BlockState) -> Verdict:
        left, right = state.resolve(node.a), state.resolve(node.b)
        parts = self._parts(node, left, right, state)
        if node.immediate:
            gap, edge = min((footprint_gap(state, a, b), edge_between(state, a, b)) for a in left for b in right)
            parts.append(at_most(gap, node.gap_edges * edge))
        return parts[0] if len(parts) == 1 else every(parts)

    def holds(self, node: Directional, state: BlockState) -> bool:
        if node.immediate:
            return self.evaluate(node, state).value
        return all(part.value for part in self._parts(node, state.resolve(node.a), state.resolve(node.b), state))

    def _parts(
        self, node: Directional, left: tuple[str, ...], right: tuple[str, ...], state: BlockState
    ) -> list[Verdict]:
        """What has to hold of each pair, and of those that must not be off to a side of a group."""
        cone = not node.somewhere and len(left) == 1 and len(right) == 1
        straight = node.directly and len(right) == 1
        parts = [self._pair(node, a, b, cone, straight, state) for a in left for b in right]
        if node.directly and not straight:
            few, many = _shadowed(left, right)
            parts += [self._in_shadow(node, one, many, state) for one in few]
        return parts

    def _in_shadow(self, node: Directional, one: str, many: tuple[str, ...], state: BlockState) -> Verdict:
        """Whether a block is not off to a side of a group: at most as far across as `directly` allows from its ends."""
        apart = [_across(self.kind, one, other, state) for other in many]
        allowed = [node.across_edges * edge_between(state, one, other) for other in many]
        ends = (max(a + r for a, r in zip(apart, allowed, strict=True)),
                max(r - a for a, r in zip(apart, allowed, strict=True)))  # fmt: skip
        return holds(min(ends) / min(allowed))

    def perhaps(self, node: Directional, many: Centres) -> Mask:
        found = many.all()
        if not isinstance(node.a, tuple) or not isinstance(node.b, tuple):
            return found
        if not many.world.patches.keys().isdisjoint((*node.a, *node.b)):
            return found
        ux, uy = DIRECTIONS[self.kind]
        cone = not node.somewhere and len(node.a) == 1 and len(node.b) == 1
        bx, by, _ = many.of(node.b)
        for a in node.a:
            ax, ay, _ = many.of((a,))
            edge = np.maximum(many.world.edge[a], many.edges(node.b))
            along, across = (ax - bx) * ux + (ay - by) * uy, abs((ax - bx) * uy - (ay - by) * ux)
            found &= (along >= node.min_edges * edge - ROOM).all(axis=1)
            if cone:
                found &= (along - across >= -ROOM).all(axis=1)
            if node.directly and len(node.b) == 1:
                found &= (across <= node.across_edges * edge + ROOM).all(axis=1)
        return found

    def _pair(self, node: Directional, a: str, b: str, cone: bool, straight: bool, state: BlockState) -> Verdict:
        along, across = offsets(self.kind, a, b, state)
        edge = edge_between(state, a, b)
        margin = (along - _least(node, a, b, edge, state)) / edge
        if cone:
            margin = min(margin, (along - across) / edge)
        if straight:
            margin = min(margin, 1.0 - across / (node.across_edges * edge))
        return holds(margin)

    def propose(self, node: Directional, block: str, state: BlockState, rng: Random) -> Iterator[tuple[float, float]]:
        ux, uy = DIRECTIONS[self.kind]
        ahead = block in members(node.a)
        sign = 1.0 if ahead else -1.0
        for other in members(node.b if ahead else node.a):
            if other == block or not (other in state.position or other in state.world.patches):
                continue
            x, y, _ = state.where(other)
            for along, across in self._steps(node, block, other, state):
                yield x + sign * along * ux + across * uy, y + sign * along * uy + across * ux

    def near_misses(self, node: Directional, state: BlockState, rng: Random) -> Iterator[NearMiss]:
        left, right = state.resolve(node.a), state.resolve(node.b)
        pairs = [(a, b) for a in left for b in right]
        a, b = min(pairs, key=lambda pair: offsets(self.kind, pair[0], pair[1], state)[0])
        edge = edge_between(state, a, b)
        least = least_offset(node, a, b, state)
        yield self._placed(f"{a} on the other side of {b}", a, b, -least - edge, 0.0, state)
        yield self._placed(f"{a} not far enough {WORDS[self.kind]} {b}", a, b, least - PAST, 0.0, state)
        if not node.somewhere and len(pairs) == 1:
            along = least + 0.25 * edge
            yield self._placed(f"{a} more beside {b} than {WORDS[self.kind]} it", a, b, along, along + PAST, state)
        if node.directly and len(right) > 1:
            yield self._out_of_shadow(node, left, right, state)
        elif node.directly:
            across = node.across_edges * edge + PAST
            yield self._placed(f"{a} not straight {WORDS[self.kind]} {b}", a, b, least + across, across, state)
        if node.immediate and len(pairs) == 1:
            k = 0 if DIRECTIONS[self.kind][0] else 1
            along = reach(state, a)[k] + reach(state, b)[k] + node.gap_edges * edge + PAST
            yield self._placed(f"{a} too far {WORDS[self.kind]} {b}", a, b, max(along, least), 0.0, state)

    def _out_of_shadow(
        self, node: Directional, left: tuple[str, ...], right: tuple[str, ...], state: BlockState
    ) -> NearMiss:
        """A block of the smaller group just past an end of the larger one."""
        few, many = _shadowed(left, right)
        one = few[0]
        end = max(many, key=lambda other: node.across_edges * edge_between(state, one, other)
                  - _across(self.kind, one, other, state))  # fmt: skip
        across = node.across_edges * edge_between(state, one, end) + PAST
        along, _ = offsets(self.kind, one, end, state)
        ux, uy = DIRECTIONS[self.kind]
        moved = place_beside(state, one, end, along * ux + across * uy, along * uy - across * ux)
        return NearMiss(f"{one} off to a side of what it is straight {WORDS[self.kind]}", moved)

    def _placed(self, what: str, a: str, b: str, along: float, across: float, state: BlockState) -> NearMiss:
        """`a` (or, where it is a patch, `b`) moved so that their offset is as given."""
        ux, uy = DIRECTIONS[self.kind]
        dx, dy = along * ux + across * uy, along * uy + across * ux
        movable = a in state.position or b in state.position
        return NearMiss(what, place_beside(state, a, b, dx, dy) if movable else state)

    def _steps(self, node: Directional, a: str, b: str, state: BlockState) -> Iterator[tuple[float, float]]:
        edge = edge_between(state, a, b)
        least = least_offset(node, a, b, state)
        if node.immediate:
            reach = sum(self._half(n, state.world) for n in (a, b))
            yield max(least, reach + 0.5 * node.gap_edges * edge), 0.0
            return
        for more in (1.0, 0.5, 0.25, 2.0):
            yield least + more * edge, 0.0
        if not node.directly:
            yield from ((least + edge, side * edge) for side in (0.8, -0.8))
            yield from ((least + 2.0 * edge, side * edge) for side in (1.6, -1.6))

    def _half(self, name: str, world: World) -> float:
        patch = world.patches.get(name)
        return world.edge[name] / 2 if patch is None else patch.size[0 if DIRECTIONS[self.kind][0] else 1] / 2


TABLE: dict[str, Predicate[Any]] = {kind: DirectionalPredicate(kind) for kind in DIRECTIONS}
