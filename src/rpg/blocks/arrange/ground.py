"""Room on the table: which columns of blocks stand where, and how far a piece would be from them."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from functools import lru_cache
from typing import NamedTuple

from rpg.blocks.arrange.pieces import Piece
from rpg.blocks.geometry import Point, Polygon, polygon_separation, shadow, sides, square_separation
from rpg.blocks.state import BlockState, Quat, matrix
from rpg.ir import goal as g
from rpg.ir.node import members
from rpg.ir.relations import Adjacent, Beside, Distance, Touching
from rpg.ir.walk import names

MIN_GAP = 0.005
"""Blocks of different pieces keep this far apart (m) unless contact is asked for."""
NEIGHBOURHOOD = 0.12
"""Columns farther apart than this are not measured exactly."""
TRESPASS = 0.5
"""What it costs to stand on a patch without being asked to."""


class Column(NamedTuple):
    """Blocks one above the other: centre, half of the bounding box's side, outline about the centre, names.

    `way`: along the sides of the outline where it is a square; `square`: it is, along the axes."""

    x: float
    y: float
    half: float
    outline: Polygon
    way: Point | None
    side: float
    square: bool
    blocks: frozenset[str]


class Ground:
    """The columns of the pieces that are placed."""

    def __init__(self, pieces: Sequence[Piece], state: BlockState, wanted: Iterable[g.Atom]) -> None:
        world = state.world
        self.columns = {id(piece): _columns(piece, state) for piece in pieces}
        self.placed: dict[int, list[Column]] = {}
        self.gaps: dict[frozenset[str], float] = {}
        self.welcome: dict[str, set[str]] = {name: set() for name in world.patches}
        self.patches = {
            name: (*patch.position, patch.size[0] / 2, patch.size[1] / 2)
            for name, patch in world.patches.items()
            if patch.position is not None
        }
        for atom in wanted:
            self._note(atom)

    def _note(self, atom: g.Atom) -> None:
        if self.welcome:
            mentioned = names(atom)
            for patch in (n for n in mentioned if n in self.welcome):
                self.welcome[patch].update(mentioned)
        least = _least_gap(atom)
        if least is not None:
            pairs = ((a, b) for a in members(atom.a) for b in members(atom.b))  # type: ignore[union-attr]
            self.gaps.update((frozenset(pair), least) for pair in pairs)

    def occupy(self, piece: Piece, origin: tuple[float, float]) -> None:
        self.placed[id(piece)] = [_at(column, origin) for column in self.columns[id(piece)]]

    def leave(self, piece: Piece) -> None:
        del self.placed[id(piece)]

    def clearance(self, piece: Piece, origin: tuple[float, float]) -> float | None:
        """Gap to the nearest placed column, at most NEIGHBOURHOOD; None where the piece would collide."""
        nearest = NEIGHBOURHOOD
        for column in self.columns[id(piece)] if self.placed else ():
            x, y = column.x + origin[0], column.y + origin[1]
            for others in self.placed.values():
                for other in others:
                    reach = column.half + other.half
                    dx, dy = abs(x - other.x) - reach, abs(y - other.y) - reach
                    if dx >= nearest or dy >= nearest:
                        continue
                    gap = math.hypot(dx, dy) if dx > 0.0 and dy > 0.0 else dx if dx > dy else dy
                    if gap >= nearest:
                        continue
                    if not (column.square and other.square):
                        gap = _separation(column, origin, other)
                    if gap < (self._least(column, other) if self.gaps else MIN_GAP) - 1e-9:
                        return None
                    if gap < nearest:
                        nearest = gap
        return nearest

    def _least(self, a: Column, b: Column) -> float:
        wished = [
            self.gaps[pair] for pair in (frozenset((p, q)) for p in a.blocks for q in b.blocks) if pair in self.gaps
        ]
        return min(wished, default=MIN_GAP)

    def trespass(self, piece: Piece, origin: tuple[float, float]) -> float:
        """The price of lying on patches that say nothing about this piece."""
        price = 0.0
        for name, (px, py, hx, hy) in self.patches.items():
            if self.welcome[name].isdisjoint(piece.position):
                dx, dy = origin[0] - px, origin[1] - py
                price += TRESPASS * any(
                    abs(c.x + dx) < c.half + hx + MIN_GAP and abs(c.y + dy) < c.half + hy + MIN_GAP
                    for c in self.columns[id(piece)]
                )
        return price


def _columns(piece: Piece, state: BlockState) -> list[Column]:
    """The columns of a piece about its own origin."""
    found: dict[tuple[float, float], Column] = {}
    for name, (x, y, _) in piece.position.items():
        shadow = _shadow(x, y, state.world.edge[name], state.orientation[name])
        column = Column(x, y, *shadow, frozenset((name,)))
        at = (round(x, 4), round(y, 4))
        other = found.get(at)
        if other is not None:
            larger = column if column.half > other.half else other
            column = larger._replace(blocks=column.blocks | other.blocks)
        found[at] = column
    return list(found.values())


@lru_cache(maxsize=1024)
def _shadow(x: float, y: float, edge: float, quat: Quat) -> tuple[float, Polygon, Point | None, float, bool]:
    """What a block at (x, y) that is turned like this covers of the table, as a column has it."""
    axes = matrix(quat)
    outline = shadow((x, y, 0.0), edge / 2, axes)
    half = max([max(abs(u - x), abs(v - y)) for u, v in outline])
    return half, outline, sides(axes), edge / 2, half < edge / 2 + 1e-6


def _at(column: Column, origin: tuple[float, float]) -> Column:
    return column._replace(x=column.x + origin[0], y=column.y + origin[1], outline=_moved(column.outline, origin))


def _moved(outline: Polygon, origin: tuple[float, float]) -> Polygon:
    ox, oy = origin
    return tuple((x + ox, y + oy) for x, y in outline)


def _separation(column: Column, origin: tuple[float, float], other: Column) -> float:
    """Greatest distance between the outlines of a column at an origin and of a placed one, along a normal of a side."""
    if column.way is None or other.way is None:
        return polygon_separation(_moved(column.outline, origin), other.outline)
    offset = (other.x - column.x - origin[0], other.y - column.y - origin[1])
    return square_separation(offset, column.way, column.side, other.way, other.side)


def _least_gap(atom: g.Atom) -> float | None:
    """The least gap that a condition on closeness leaves to its blocks; None where the usual one will do."""
    match atom:
        case Touching():
            return 0.0
        case Beside() | Adjacent() if atom.gap_edges < 0.25:
            return 0.0
        case Distance(measure="faces") if atom.maximum is not None and atom.maximum < 2 * MIN_GAP:
            return 0.0
        case _:
            return None
