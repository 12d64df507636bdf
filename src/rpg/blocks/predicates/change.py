"""stayed, moved, swapped, took_place, turned: relative to the start of the episode."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator
from itertools import permutations
from random import Random
from typing import Any

from rpg.blocks.geometry import carried
from rpg.blocks.predicate import NearMiss, Predicate
from rpg.blocks.predicates.common import PAST, put, shift
from rpg.blocks.state import IDENTITY, BlockState, product, yaw_quat
from rpg.blocks.verdict import Verdict, at_least, at_most, every, some
from rpg.ir.relations import Moved, Stayed, Swapped, TookPlace, Turned

MATCHED = 5
"""Groups up to this size may swap in any pairing; larger ones in the order given."""


def start_of(state: BlockState) -> BlockState:
    """The state in which the episode began."""
    return state.start or state


def travelled(name: str, state: BlockState) -> float:
    """Distance of a block from where the episode found it."""
    return math.dist(state.position[name], start_of(state).position[name])


class StayedPredicate(Predicate[Stayed]):
    """Each block is where it was."""

    def evaluate(self, node: Stayed, state: BlockState) -> Verdict:
        return every([at_most(travelled(a, state), node.tolerance) for a in state.resolve(node.a)])

    def near_misses(self, node: Stayed, state: BlockState, rng: Random) -> Iterator[NearMiss]:
        a = state.resolve(node.a)[0]
        yield from _from_start(a, f"{a} pushed away from where it was", node.tolerance + PAST, state)


class MovedPredicate(Predicate[Moved]):
    """Each block is somewhere else."""

    def evaluate(self, node: Moved, state: BlockState) -> Verdict:
        return every([at_least(travelled(a, state), node.at_least) for a in state.resolve(node.a)])

    def near_misses(self, node: Moved, state: BlockState, rng: Random) -> Iterator[NearMiss]:
        a = state.resolve(node.a)[0]
        yield from _from_start(a, f"{a} hardly moved", node.at_least - PAST, state)
        yield from _from_start(a, f"{a} where it was", 0.0, state)


class SwappedPredicate(Predicate[Swapped]):
    """Each block stands where its counterpart stood."""

    def evaluate(self, node: Swapped, state: BlockState) -> Verdict:
        return _taken(node.a, node.b, node.tolerance, state) & _taken(node.b, node.a, node.tolerance, state)

    def propose(self, node: Swapped, block: str, state: BlockState, rng: Random) -> Iterator[tuple[float, float]]:
        theirs = node.b if block in node.a else node.a
        start = start_of(state)
        yield from (start.position[n][:2] for n in theirs if n in start.position)

    def near_misses(self, node: Swapped, state: BlockState, rng: Random) -> Iterator[NearMiss]:
        a, b = node.a[0], node.b[0]
        start = start_of(state)
        yield NearMiss(f"{a} and {b} back where they were", put_back(state, (*node.a, *node.b)))
        place = min(node.b, key=lambda n: math.dist(start.position[n], state.position[a]))
        (px, py, _), (x, y, _) = start.position[place], state.position[a]
        dy = node.tolerance + PAST
        if len(node.a) == 1:
            load = carried(state, a)
            yield NearMiss(f"{a} not quite in the place of {b}", shift(state, load, px - x, py + dy - y))
            yield NearMiss(f"only {a} in its new place", put_back(state, (b,)))


class TookPlacePredicate(Predicate[TookPlace]):
    """Each block stands where one of the others stood."""

    def evaluate(self, node: TookPlace, state: BlockState) -> Verdict:
        return _taken(node.a, node.b, node.tolerance, state)

    def propose(self, node: TookPlace, block: str, state: BlockState, rng: Random) -> Iterator[tuple[float, float]]:
        if block in node.a:
            start = start_of(state)
            yield from (start.position[n][:2] for n in node.b if n in start.position)

    def near_misses(self, node: TookPlace, state: BlockState, rng: Random) -> Iterator[NearMiss]:
        a, start = node.a[0], start_of(state)
        place = min(node.b, key=lambda n: math.dist(start.position[n], state.position[a]))
        (px, py, _), (x, y, _) = start.position[place], state.position[a]
        dy = node.tolerance + PAST
        for side, way in ((dy, "left"), (-dy, "right")):
            aside = shift(state, carried(state, a), px - x, py + side - y)
            yield NearMiss(f"{a} too far {way} of the place of {place}", aside)
        yield NearMiss(f"{a} where it was", put_back(state, (a,)))


def _taken(names: tuple[str, ...], places: tuple[str, ...], tolerance: float, state: BlockState) -> Verdict:
    """Whether each block is where one of the others was, each at a place of its own."""
    start = start_of(state)
    deals = permutations(places, len(names)) if len(places) <= MATCHED else [places]
    return some(
        [
            every(
                [
                    at_most(math.dist(state.position[n], start.position[p]), tolerance)
                    for n, p in zip(names, deal, strict=False)
                ]
            )
            for deal in deals
        ]
    )


class TurnedPredicate(Predicate[Turned]):
    """The block has turned about the vertical."""

    def evaluate(self, node: Turned, state: BlockState) -> Verdict:
        yaw, upright = yaw_since_start(node.block, state)
        off = min(abs((yaw - w + 180.0) % 360.0 - 180.0) for w in wanted_turns(node))
        return at_most(max(off, upright), node.tolerance)

    def near_misses(self, node: Turned, state: BlockState, rng: Random) -> Iterator[NearMiss]:
        begun = start_of(state).orientation.get(node.block, IDENTITY)
        past = node.tolerance + 3.0
        for degrees, what in (
            (node.degrees + past, "too far"),
            (node.degrees - past, "too little"),
            (0.0, "not at all"),
        ):
            gaps = (abs((degrees - w + 180.0) % 360.0 - 180.0) for w in wanted_turns(node))
            if min(gaps) > node.tolerance:
                quat = product(yaw_quat(math.radians(degrees)), begun)
                turned = put(state, node.block, state.position[node.block], quat)
                yield NearMiss(f"{node.block} turned {what}", turned)


def wanted_turns(node: Turned) -> tuple[float, ...]:
    """The turns in degrees that `node` accepts."""
    return (node.degrees, -node.degrees) if node.either_way else (node.degrees,)


def put_back(state: BlockState, blocks: Iterable[str]) -> BlockState:
    """`state` with some blocks where they started."""
    start = start_of(state)
    return state.moved({n: (start.position[n], start.orientation.get(n, IDENTITY)) for n in blocks})


def _from_start(name: str, what: str, distance: float, state: BlockState) -> Iterator[NearMiss]:
    """The block at a distance along y from where it started, on the level of its start."""
    x, y, z = start_of(state).position[name]
    sign = 1.0 if y < 0.0 else -1.0
    yield NearMiss(what, put(state, name, (x, y + sign * distance, z), state.orientation.get(name, IDENTITY)))


def yaw_since_start(name: str, state: BlockState) -> tuple[float, float]:
    """Degrees that a block has turned about the vertical since the start, and how far it is tipped from then."""
    now, then = state.axes(name), start_of(state).axes(name)
    r = [[sum(now[i][k] * then[j][k] for k in range(3)) for j in range(3)] for i in range(3)]
    yaw = math.degrees(math.atan2(r[1][0] - r[0][1], r[0][0] + r[1][1]))
    return yaw, math.degrees(math.acos(max(-1.0, min(1.0, r[2][2]))))


TABLE: dict[str, Predicate[Any]] = {
    "stayed": StayedPredicate(),
    "moved": MovedPredicate(),
    "swapped": SwappedPredicate(),
    "took_place": TookPlacePredicate(),
    "turned": TurnedPredicate(),
}
