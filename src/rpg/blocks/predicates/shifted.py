"""shifted, approached, receded: how far which way, or how much closer, seen from the start of the episode."""

from __future__ import annotations

import math
from collections.abc import Iterator
from itertools import combinations, islice
from random import Random
from typing import Any

from rpg.blocks.geometry import carried, plane_distance
from rpg.blocks.predicate import NearMiss, Predicate
from rpg.blocks.predicates.change import put_back, start_of
from rpg.blocks.predicates.common import PAST, shift
from rpg.blocks.predicates.proximity import centres_apart_by, pairs, ring
from rpg.blocks.state import BlockState
from rpg.blocks.verdict import Verdict, at_least, at_most, every
from rpg.ir.node import Direction
from rpg.ir.relations import Ranged, Shifted

WAYS: dict[Direction, tuple[float, float]] = {
    "left": (0.0, 1.0),
    "right": (0.0, -1.0),
    "front": (-1.0, 0.0),
    "back": (1.0, 0.0),
}
"""The viewer's directions as unit vectors."""
BEYOND = (0.02, 0.01, 0.04, 0.08, 0.12)
"""How much farther than it has to a block is put first, where nothing limits that (m)."""
ASIDE = 0.06
STEP = 0.016
"""Farther off the axis than this, places are tried so far from each other (m)."""
LEAST = 0.01
"""Margins are told in units of a tolerance, or of this length (m) where there is none."""


class ShiftedPredicate(Predicate[Shifted]):
    """Each block is so far on one side of where it was."""

    def evaluate(self, node: Shifted, state: BlockState) -> Verdict:
        return every([verdict for a in state.resolve(node.a) for verdict in _shifted(node, a, state)])

    def propose(self, node: Shifted, block: str, state: BlockState, rng: Random) -> Iterator[tuple[float, float]]:
        x, y, _ = start_of(state).position[block]
        ux, uy = WAYS[node.toward]
        for off in _asides(node.across):
            for far in islice(_lengths(node.at_least, node.at_most), 1 if off else None):
                yield x + far * ux - off * uy, y + far * uy + off * ux

    def near_misses(self, node: Shifted, state: BlockState, rng: Random) -> Iterator[NearMiss]:
        a = min(state.resolve(node.a), key=lambda name: travelled_along(node, name, state)[0])
        along, across = travelled_along(node, a, state)
        ux, uy = WAYS[node.toward]
        load = carried(state, a)

        def at(far: float, off: float) -> BlockState:
            """The block so far from where it was, and so far off the axis."""
            step, aside = far - along, off - across
            return shift(state, load, step * ux - aside * uy, step * uy + aside * ux)

        yield NearMiss(f"{a} hardly moved to the {node.toward}", at(node.at_least - PAST, across / 2))
        if node.at_most is not None:
            yield NearMiss(f"{a} moved too far to the {node.toward}", at(node.at_most + PAST, across))
        limit = along if node.across is None else node.across
        yield NearMiss(f"{a} moved too much aside", at(along, math.copysign(limit + PAST, across)))
        yield NearMiss(f"{a} moved the other way", at(-along, across))
        yield NearMiss(f"{a} where it was", at(0.0, 0.0))


class RangedPredicate(Predicate[Ranged]):
    """Each block is closer to each other one than it was (`sign` -1), or farther from it (1)."""

    def __init__(self, sign: float, how: str) -> None:
        self.sign, self.how = sign, how

    def evaluate(self, node: Ranged, state: BlockState) -> Verdict:
        return every([verdict for a, b in _pairs(node, state) for verdict in self._changed(node, a, b, state)])

    def _changed(self, node: Ranged, a: str, b: str, state: BlockState) -> Iterator[Verdict]:
        change, scale = self._change(a, b, state), _scale(node)
        yield at_least(change, node.at_least, scale)
        if node.at_most is not None:
            yield at_most(change, node.at_most, scale)

    def _change(self, a: str, b: str, state: BlockState) -> float:
        """By how much the distance has become what is asked for, in metres."""
        return self.sign * (plane_distance(state, a, b) - plane_distance(start_of(state), a, b))

    def propose(self, node: Ranged, block: str, state: BlockState, rng: Random) -> Iterator[tuple[float, float]]:
        start = start_of(state)
        known = state.position.keys() | state.world.patches.keys()
        for one, two in _pairs(node, start):
            other = two if one == block else one if two == block else block
            if other == block or other not in known:
                continue
            (x, y, _), (u, v, _), (sx, sy, _) = start.where(block), state.where(other), start.where(other)
            begun = plane_distance(start, one, two)
            dx, dy = ((x - sx) / begun, (y - sy) / begun) if begun > 1e-6 else (0.0, 1.0)
            for change in _lengths(node.at_least, node.at_most):
                far = begun + self.sign * change
                if far > 0.0:
                    yield u + far * dx, v + far * dy
                    yield from ring(u, v, far, rng)

    def near_misses(self, node: Ranged, state: BlockState, rng: Random) -> Iterator[NearMiss]:
        a, b = min(_pairs(node, state), key=lambda pair: self._change(pair[0], pair[1], state))
        begun = plane_distance(start_of(state), a, b)
        if (short := begun + self.sign * (node.at_least - PAST)) > 0.0:
            yield centres_apart_by(f"{a} hardly {self.how} {b} than it was", a, b, short, state)
        if node.at_most is not None and (far := begun + self.sign * (node.at_most + PAST)) > 0.0:
            yield centres_apart_by(f"{a} too much {self.how} {b} than it was", a, b, far, state)
        yield centres_apart_by(f"{a} as far from {b} as it was", a, b, begun, state)
        blocks = [name for name in dict.fromkeys((*_members(node, state),)) if name in state.position]
        yield NearMiss("all where they were", put_back(state, blocks))


def travelled_along(node: Shifted, name: str, state: BlockState) -> tuple[float, float]:
    """How far a block is from where it was along the axis, and across it (signed)."""
    (x, y, _), (u, v, _) = state.position[name], start_of(state).position[name]
    ux, uy = WAYS[node.toward]
    return (x - u) * ux + (y - v) * uy, (y - v) * ux - (x - u) * uy


def _shifted(node: Shifted, name: str, state: BlockState) -> Iterator[Verdict]:
    along, off = travelled_along(node, name, state)
    scale = _scale(node)
    yield at_least(along, node.at_least, scale)
    if node.at_most is not None:
        yield at_most(along, node.at_most, scale)
    if node.across is None:
        yield at_least(along, abs(off), scale)
    else:
        yield at_most(abs(off), node.across)


def _scale(node: Shifted | Ranged) -> float:
    """The tolerance that margins are measured in."""
    if node.at_most is None:
        return node.at_least or LEAST
    return (node.at_most - node.at_least) / 2 or LEAST


def _lengths(least: float, most: float | None) -> Iterator[float]:
    """Lengths in a range, the likeliest first."""
    if most is None:
        yield from (least + more for more in BEYOND)
    else:
        yield (least + most) / 2
        yield from (least + (most - least) * share for share in (0.3, 0.7))


def _asides(across: float | None) -> Iterator[float]:
    """How far off the axis, where a block may be well off it, as one is that goes along the other axis too."""
    yield 0.0
    if across is not None and across > ASIDE:
        step = max(STEP, across / 8)
        for count in range(1, int(across / step) + 1):
            yield from (count * step, -count * step)


def _members(node: Ranged, state: BlockState) -> Iterator[str]:
    for pair in _pairs(node, state):
        yield from pair


def _pairs(node: Ranged, state: BlockState) -> list[tuple[str, str]]:
    """Every two that are compared."""
    return list(combinations(state.resolve(node.a), 2)) if node.a == node.b else pairs(node, state)


TABLE: dict[str, Predicate[Any]] = {
    "shifted": ShiftedPredicate(),
    "approached": RangedPredicate(-1.0, "closer to"),
    "receded": RangedPredicate(1.0, "farther from"),
}
