"""row: blocks in one straight line on one level."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from itertools import pairwise
from random import Random
from typing import Any

from rpg.blocks.centres import Centres, Mask
from rpg.blocks.geometry import footprint_gap
from rpg.blocks.predicate import Cluster, NearMiss, Predicate
from rpg.blocks.predicates.common import (
    BUILD_GAP,
    PAST_SHARE,
    SPANS,
    TOUCH,
    Line,
    centroid,
    flatness,
    gaps_along,
    largest_edge,
    levelness,
    pair_edge,
    shift,
    slack,
    spin,
    swap,
)
from rpg.blocks.predicates.order import ordered, sequences, swaps
from rpg.blocks.predicates.plainly import CORNER, straight, uneven
from rpg.blocks.predicates.reading import apart, legible, unreadable
from rpg.blocks.predicates.stack import alone
from rpg.blocks.state import IDENTITY, BlockState, Quat, Vec3, World, yaw_quat
from rpg.blocks.traits import AWAY, UP, Traits, symbols_shown
from rpg.blocks.verdict import ROUNDING, Verdict, every, holds
from rpg.ir.node import SLOPES, Axis, Slope
from rpg.ir.order import Order
from rpg.ir.structures import Row

_DIAGONAL = 1.0 / math.sqrt(2.0)
_RISING, _FALLING = (_DIAGONAL, -_DIAGONAL), (-_DIAGONAL, -_DIAGONAL)
_WAYS: dict[Axis | Slope, tuple[tuple[float, float], ...]] = {
    "x": ((1.0, 0.0),),
    "y": ((0.0, -1.0),),
    "rising": (_RISING,),
    "falling": (_FALLING,),
    "diagonal": (_RISING, _FALLING),
}
"""The unit vectors of each line: away from the viewer, or from left to right."""
_TURN = math.pi / 4
_YAWS: dict[Axis | Slope, list[float]] = {
    "y": [0.0], "x": [math.pi / 2], "rising": [_TURN], "falling": [-_TURN], "diagonal": [_TURN, -_TURN],
}  # fmt: skip
"""How a row from left to right is turned to lie along it."""
_ROUNDED = 3e-4
"""Metres between blocks that touch on a diagonal: places are rounded, and they must not reach into each other."""
SIDES: dict[str, Axis] = {"left": "y", "right": "y", "front": "x", "back": "x"}
"""The axis that a first side asks for."""
READ_ORDERS = ("label", "number")
"""Orders of symbols: another symbol that adjoins the row would be read with it."""
SLANT = 0.45
"""Turn (radians) of the rows that lie along no axis."""


def best_line(state: BlockState, names: Sequence[str]) -> Line:
    """Blocks along the line with the least squared distance from their centres."""
    points = [state.position[name] for name in names]
    n = len(points)
    cx, cy = sum([x for x, _, _ in points]) / n, sum([y for _, y, _ in points]) / n
    xx = yy = xy = 0.0
    for x, y, _ in points:
        dx, dy = x - cx, y - cy
        xx += dx * dx
        yy += dy * dy
        xy += dx * dy
    angle = 0.5 * math.atan2(2.0 * xy, xx - yy)
    ux, uy = math.cos(angle), math.sin(angle)
    if (uy > 0.0) if abs(uy) >= abs(ux) else (ux < 0.0):
        ux, uy = -ux, -uy
    ranked = sorted(
        [
            ((x - cx) * ux + (y - cy) * uy, name, (y - cy) * ux - (x - cx) * uy)
            for name, (x, y, _) in zip(names, points, strict=True)
        ]
    )
    return Line([name for _, name, _ in ranked], [a for a, _, _ in ranked], [o for _, _, o in ranked], (ux, uy))


def line_of(node: Row, state: BlockState) -> Line:
    """The blocks of a row along their best line; those of a diagonal from its left end, whichever way it is steeper."""
    line = best_line(state, node.blocks)
    if node.axis not in SLOPES or line.direction[1] < 0.0:
        return line
    (ux, uy), off = line.direction, [-o for o in reversed(line.off)]
    return Line(line.sequence[::-1], [-a for a in reversed(line.along)], off, (-ux, -uy))


def angle_to(axis: Axis | Slope, direction: tuple[float, float]) -> float:
    """Degrees between a line and an axis."""
    ux, uy = direction
    return min(math.degrees(math.atan2(abs(ux * vy - uy * vx), abs(ux * vx + uy * vy))) for vx, vy in _WAYS[axis])


def straightness(line: Line, state: BlockState, line_edges: float) -> float:
    """Margin of "centres near their best line, one after the other along it"."""
    edge = largest_edge(state, line.sequence)
    margin = slack(max(map(abs, line.off)), line_edges * edge)
    for k in range(1, len(line.along)):
        step, aside = line.along[k] - line.along[k - 1], abs(line.off[k] - line.off[k - 1])
        margin = min(margin, (step - aside) / edge - CORNER)
    return margin


def axis_of(node: Row) -> Axis | Slope | None:
    """The axis that a row must lie along: its own, that of its first side, or the one that reading asks for."""
    implied = SIDES.get(node.order.first or "")
    return node.axis or implied or ("y" if node.readable else None)


def from_first(order: Order, sequence: Sequence[str]) -> list[str]:
    """A sequence from left or front, as the order counts it."""
    return list(sequence)[::-1] if order.first in ("right", "back") else list(sequence)


def lined_up(line: Line, state: BlockState, node: Row) -> float:
    """Margin of "level, straight, and along the axis", gaps apart."""
    names = line.sequence
    margin = min(levelness(state, names), flatness(state, names))
    if len(names) > 1:
        margin = min(margin, straightness(line, state, node.line_edges))
        axis = axis_of(node)
        if axis is not None:
            margin = min(margin, slack(angle_to(axis, line.direction), node.angle))
    return margin


def spacing(node: Row, sequence: Sequence[str], state: BlockState) -> float:
    """Margin of the distances between neighbours."""
    pairs = list(pairwise(sequence))
    if not pairs:
        return 1.0
    gaps = gaps_along(state, sequence)
    margins = []
    if node.touching:
        margins += [1.0 - gap / TOUCH for gap in gaps]
    if node.gap is not None:
        margins += [slack(abs(max(gap, 0.0) - node.gap), node.tolerance) for gap in gaps]
    if node.spacing is not None:
        position = state.position
        steps = [math.dist(position[a][:2], position[b][:2]) for a, b in pairs]
        margins += [slack(abs(step - node.spacing), node.tolerance) for step in steps]
    if not margins:
        edges = [pair_edge(state, a, b) for a, b in pairs]
        margins += [slack(gap, node.gap_edges * edge) for gap, edge in zip(gaps, edges, strict=True)]
    if node.evenly:
        limit = node.even_edges * largest_edge(state, sequence)
        margins.append(slack(max(gaps) - min(gaps), limit))
    return min(margins)


class RowPredicate(Predicate[Row]):
    """Best line, gaps, order, readability."""

    def evaluate(self, node: Row, state: BlockState) -> Verdict:
        return self._along(line_of(node, state), node, state)

    def _along(self, line: Line, node: Row, state: BlockState) -> Verdict:
        parts = [holds(min(lined_up(line, state, node), spacing(node, line.sequence, state)))]
        if node.order.by != "any":
            parts.append(_in_order(node, line, state))
        if node.readable:
            parts.append(
                legible(state, line.sequence, UP, AWAY, node.excused) & alone(state, line.sequence, node.covered)
            )
            if node.order.by in READ_ORDERS:
                parts.append(apart(state, line, node.gap_edges, node.covered, symbols=True))
        return every(parts)

    def plainly_not(self, node: Row, state: BlockState) -> bool:
        return node.order.by != "any" and not self.in_order(node, state)

    def loosened(self, node: Row) -> Row | None:
        if node.order.by != "given":
            return None
        return node.model_copy(update={"order": Order(), "axis": axis_of(node)})

    def in_order(self, node: Row, state: BlockState) -> Verdict:
        return _in_order(node, line_of(node, state), state)

    def holds(self, node: Row, state: BlockState) -> bool:
        if uneven(state, node.blocks):
            return False
        line = line_of(node, state)
        if straightness(line, state, node.line_edges) < -ROUNDING:
            return False
        if node.order.by != "any" and not _in_order(node, line, state):
            return False
        return self._along(line, node, state).value

    def perhaps(self, node: Row, many: Centres) -> Mask:
        return straight(many, node, node.blocks, axis_of(node))

    def build(self, node: Row, world: World, rng: Random) -> Iterator[list[Cluster]]:
        for sequence in sequences(node.order, node.blocks, Traits(world), rng):
            forward = from_first(node.order, sequence)
            for yaw in self._yaws(node):
                cluster = lay(node, forward, yaw, world)
                if cluster is not None:
                    yield [cluster]
            if node.order.first is None and node.order.by != "any":
                cluster = lay(node, forward[::-1], self._yaws(node)[0], world)
                if cluster is not None:
                    yield [cluster]

    def _yaws(self, node: Row) -> list[float]:
        """Turns of a row from left to right: along its axis, or along y, along x, slanting."""
        axis = axis_of(node)
        return _YAWS[axis] if axis is not None else [0.0, math.pi / 2, SLANT]

    def near_misses(self, node: Row, state: BlockState, rng: Random) -> Iterator[NearMiss]:
        names = node.blocks
        if len(names) < 2:
            return
        line = line_of(node, state)
        if len(names) > 2:
            yield _out_of_line(node, line, state)
        yield gap_too_large(node, line, state)
        if node.evenly and len(names) > 2:
            gaps = gaps_along(state, line.sequence)
            step = PAST_SHARE * node.even_edges * largest_edge(state, names) + max(gaps) - gaps[-1]
            dx, dy = line.direction[0] * step, line.direction[1] * step
            yield NearMiss(f"{line.sequence[-1]} spaced unlike the others", shift(state, line.sequence[-1:], dx, dy))
        axis = axis_of(node)
        if axis is not None:
            aslant = PAST_SHARE * node.angle + angle_to(axis, line.direction)
            yield NearMiss("the row aslant", spin(state, names, aslant, centroid(state, names)))
        sequence = from_first(node.order, line.sequence)
        traits, either = Traits(state.world), node.order.first is None
        for a, b in swaps(node.order, sequence, traits, either):
            yield NearMiss(f"{a} and {b} exchanged", swap(state, a, b))
        if node.readable:
            yield from unreadable(state, line.sequence, UP, AWAY, node.excused)


def _in_order(node: Row, line: Line, state: BlockState) -> Verdict:
    traits = Traits(state.world, symbols_shown(state, node.blocks, UP))
    return ordered(node.order, from_first(node.order, line.sequence), traits, node.order.first is None)


def lay(node: Row, sequence: list[str], yaw: float, world: World) -> Cluster | None:
    """The row from left to right, turned by `yaw`; None where it is longer than the workspace.

    The blocks of a diagonal stand square to the table, corner to corner; those that touch, or of which the gaps are
    told, are turned with their line.
    """
    edges = [world.edge[name] for name in sequence]
    cornered = node.axis in SLOPES and (node.touching, node.gap, node.spacing) == (False, None, None)
    steps = row_steps([edge / _DIAGONAL for edge in edges] if cornered else edges, room_along(yaw), node)
    if steps is None:
        return None
    turn = IDENTITY if node.readable or cornered else yaw_quat(0.0 if abs(yaw) > 1.5 else yaw)
    poses: dict[str, tuple[Vec3, Quat | None]] = {}
    offset = -sum(steps) / 2
    for k, name in enumerate(sequence):
        x, y = math.sin(yaw) * offset, -math.cos(yaw) * offset
        poses[name] = ((x, y, edges[k] / 2), None if name in node.excused else turn)
        offset += steps[k] if k < len(steps) else 0.0
    return Cluster(poses)


def _out_of_line(node: Row, line: Line, state: BlockState) -> NearMiss:
    """The middle block moved aside until, with the line fitted anew, it is past what is allowed."""
    k = min(range(len(line.along)), key=lambda j: abs(line.along[j]))
    hold = 1.0 / len(line.along) + line.along[k] ** 2 / sum(a * a for a in line.along)
    out = PAST_SHARE * node.line_edges * largest_edge(state, line.sequence) / (1.0 - hold) + abs(line.off[k])
    ux, uy = line.direction
    return NearMiss(f"{line.sequence[k]} out of the line", shift(state, [line.sequence[k]], -uy * out, ux * out))


def gap_too_large(node: Row, line: Line, state: BlockState) -> NearMiss:
    """The last block moved on along the line until its gap is past what is allowed."""
    before, last = line.sequence[-2:]
    gap, edge = footprint_gap(state, before, last), pair_edge(state, before, last)
    limit = node.gap_edges * edge
    if node.touching:
        limit = TOUCH
    if node.gap is not None:
        limit = node.gap + node.tolerance
    if node.spacing is not None:
        limit = gap + 2 * node.tolerance
    if node.evenly:
        limit = max(limit, gap + node.even_edges * largest_edge(state, line.sequence))
    step = limit - gap + max(0.25 * limit, 0.003)
    dx, dy = line.direction[0] * step, line.direction[1] * step
    return NearMiss(f"{last} too far from {before}", shift(state, [last], dx, dy))


def room_along(yaw: float) -> float:
    """How long a row turned by `yaw` from left to right may be between its outer centres, in metres.

    A slanting one may be no longer than one along y, though the diagonal of the workspace is.
    """
    across = abs(math.sin(yaw))
    return min(SPANS["y"], SPANS["x"] / across if across > 1e-9 else SPANS["y"])


def row_steps(edges: list[float], room: float, node: Row) -> list[float] | None:
    """Distances between the centres of neighbours, or None where `edges` do not fit side by side."""
    pairs = [(a + b) / 2 for a, b in pairwise(edges)]
    if sum(edges) > room + 1e-9:
        return None
    if node.spacing is not None:
        steps = [node.spacing] * len(pairs)
        return steps if all(s >= p for s, p in zip(steps, pairs, strict=True)) and sum(steps) <= room else None
    gap = (_ROUNDED if node.axis in SLOPES else 0.0) if node.touching else BUILD_GAP if node.gap is None else node.gap
    free = room - sum(pairs)
    if pairs and free < gap * len(pairs):
        if node.gap is not None:
            return None
        gap = math.floor(free / len(pairs) * 1e4) / 1e4
    return [pair + gap for pair in pairs]


TABLE: dict[str, Predicate[Any]] = {"row": RowPredicate()}
