"""Reading: which symbols are legible from where, and what stands so close that it would be read with them."""

from __future__ import annotations

import math
from collections.abc import Collection, Iterable, Iterator, Sequence

from rpg.blocks.geometry import footprint_gap, rests_on
from rpg.blocks.predicate import NearMiss
from rpg.blocks.predicates.common import Line, pair_edge, put, strangers
from rpg.blocks.state import IDENTITY, BlockState, Vec3, product
from rpg.blocks.traits import Traits
from rpg.blocks.verdict import FALSE, Verdict, holds
from rpg.blocks.visibility import reads

SLANT = 40.0
"""Degrees by which a glyph is turned so that it is surely not upright: twice what is allowed."""
ADJOINS_EDGES = 0.5
"""A block whose gap to a text is at most this many edges adjoins it: one with a symbol in any direction, a plain one in
the line of the text."""


def legible(state: BlockState, names: Iterable[str], normal: Vec3, up: Vec3, excused: Iterable[str] = ()) -> Verdict:
    """The symbols that these blocks have are read upright from the direction of `normal`.

    Those `excused` are turned in the plane of their face as another condition says.
    """
    found = [reads(state, name, normal, None if name in excused else up) for name in names]
    return holds(min((margin for symbol, margin in found if symbol), default=1.0))


def apart(
    state: BlockState,
    line: Line,
    gap_edges: float,
    covered: Sequence[str] = (),
    *,
    symbols: bool = False,
    beside: Collection[str] = (),
) -> Verdict:
    """Nothing else adjoins a row: no block on it or next in its line, no symbol close to it.

    Cubes that are `covered` may have one on them, and those `beside` may adjoin it, but in none of its gaps,
    and no symbol in its line. `symbols`: only blocks that show one are looked at.
    """
    sequence = line.sequence
    margin = 1.0
    traits = Traits(state.world)
    for other in strangers(state, sequence):
        lettered = bool(traits.symbol(other))
        if symbols and not lettered:
            continue
        told = other in beside
        reach = gap_edges if lettered else 0.0 if told else ADJOINS_EDGES
        margin = min(margin, _reading_on(state, line, reach, other))
        for name in sequence:
            margin = min(margin, _closeness(state, name, other, lettered and not told, name in covered))
    return holds(margin) if margin != 0.0 else FALSE


def _closeness(state: BlockState, name: str, other: str, lettered: bool, covered: bool) -> float:
    """How far `other` is from adjoining `name`, over the distance at which it does; -1 where it lies on it, but for
    one that is `covered` anyway."""
    edge = pair_edge(state, name, other)
    (ax, ay, az), (bx, by, bz) = state.position[name], state.position[other]
    if max(abs(ax - bx), abs(ay - by)) > 4.0 * edge:
        return 1.0
    if abs(az - bz) < edge * 0.75:
        return footprint_gap(state, name, other) / (ADJOINS_EDGES * edge) - 1.0 if lettered else 1.0
    return -1.0 if not covered and rests_on(state, other, name) else 1.0


def _reading_on(state: BlockState, line: Line, gap_edges: float, other: str) -> float:
    """How far `other` is from being taken for one of the row's cubes: before its first, after its last, or in a gap;
    with no `gap_edges`, in a gap alone."""
    ux, uy = line.direction
    aside = math.inf
    for end, sign in ((line.sequence[0], -1.0), (line.sequence[-1], 1.0)):
        edge = pair_edge(state, end, other)
        (ax, ay, az), (bx, by, bz) = state.position[end], state.position[other]
        dx, dy = bx - ax, by - ay
        across = abs(dy * ux - dx * uy)
        if abs(az - bz) >= edge * 0.75 or across >= edge:
            return 1.0
        aside = min(aside, across / edge)
        if sign * (dx * ux + dy * uy) > 0.0:
            if not gap_edges:
                return 1.0
            return min(1.0, footprint_gap(state, end, other) / (gap_edges * edge) - 1.0)
    return aside - 1.0


def unreadable(
    state: BlockState, names: Sequence[str], normal: Vec3, up: Vec3, excused: Iterable[str] = ()
) -> Iterator[NearMiss]:
    """One symbol upside down, lying on its side, or slanting, to the reader at `normal`."""
    name = next((n for n in names if n not in excused and reads(state, n, normal, up)[0]), None)
    if name is None:
        return
    for degrees, what in ((180.0, "upside down"), (90.0, "on its side"), (SLANT, "slanting")):
        c, s = math.cos(math.radians(degrees / 2)), math.sin(math.radians(degrees / 2))
        turn = (c, s * normal[0], s * normal[1], s * normal[2])
        quat = product(turn, state.orientation.get(name, IDENTITY))
        yield NearMiss(f"{name} {what}", put(state, name, state.position[name], quat))
