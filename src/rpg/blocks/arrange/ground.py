"""Room on the table: which columns of blocks stand where, and how far a piece would be from them."""

from __future__ import annotations

import math
from collections.abc import Iterable
from typing import NamedTuple

from rpg.blocks.arrange.pieces import Assembly, Piece
from rpg.blocks.geometry import Polygon, footprint, polygon_separation
from rpg.blocks.state import BlockState
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
    """Blocks one above the other: centre, half of the bounding box's side, outline about the centre, names."""

    x: float
    y: float
    half: float
    outline: Polygon
    square: bool
    blocks: frozenset[str]


class Ground:
    """The columns of the pieces that are placed."""

    def __init__(self, assembly: Assembly, state: BlockState, wanted: Iterable[g.Atom]) -> None:
        self.columns = {id(piece): _columns(piece, state) for piece in assembly.pieces()}
        self.placed: dict[int, list[Column]] = {}
        self.gaps: dict[frozenset[str], float] = {}
        self.welcome: dict[str, set[str]] = {name: set() for name in assembly.world.patches}
        self.patches = {
            name: (*patch.position, patch.size[0] / 2, patch.size[1] / 2)
            for name, patch in assembly.world.patches.items()
            if patch.position is not None
        }
        for atom in wanted:
            self._note(atom, assembly)

    def _note(self, atom: g.Atom, assembly: Assembly) -> None:
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
        for column in self.columns[id(piece)]:
            x, y = column.x + origin[0], column.y + origin[1]
            for others in self.placed.values():
                for other in others:
                    reach = column.half + other.half
                    dx, dy = abs(x - other.x) - reach, abs(y - other.y) - reach
                    gap = math.hypot(dx, dy) if dx > 0.0 and dy > 0.0 else max(dx, dy)
                    if gap >= nearest:
                        continue
                    if not (column.square and other.square):
                        gap = polygon_separation(_at(column, origin).outline, other.outline)
                    if gap < self._least(column, other) - 1e-9:
                        return None
                    nearest = min(nearest, gap)
        return nearest

    def _least(self, a: Column, b: Column) -> float:
        if not self.gaps:
            return MIN_GAP
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
    own = BlockState(state.world, piece.position, state.orientation)
    found: dict[tuple[float, float], Column] = {}
    for name, (x, y, _) in piece.position.items():
        outline = footprint(own, name)
        half = max(max(abs(u - x), abs(v - y)) for u, v in outline)
        at = (round(x, 4), round(y, 4))
        square = half < state.world.edge[name] / 2 + 1e-6
        column = Column(x, y, half, outline, square, frozenset({name}))
        other = found.get(at)
        if other is not None:
            larger = column if column.half > other.half else other
            column = larger._replace(blocks=column.blocks | other.blocks)
        found[at] = column
    return list(found.values())


def _at(column: Column, origin: tuple[float, float]) -> Column:
    ox, oy = origin
    return column._replace(x=column.x + ox, y=column.y + oy, outline=tuple((x + ox, y + oy) for x, y in column.outline))


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
