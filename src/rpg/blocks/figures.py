"""Ideal figures as cells: where their blocks stand, in units of the pitch between neighbours.

Pure data for predicates and front ends: what a figure looks like, how many blocks it takes, which cells form a line.
x is away from the viewer, y to the left; row 0 is the farthest, column 0 the leftmost, level 0 the lowest.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, replace
from functools import cache, lru_cache
from typing import NamedTuple

from rpg.blocks.layers import by_layers
from rpg.ir.node import Direction
from rpg.ir.structures import Cells, Figure, Grid, Pyramid, Staircase

NAMED = 15.0
"""A figure with a named direction may be turned from it by at most this (degrees)."""
NEAREST = 45.0
"""Rows lie along y when they are nearer to it than to x."""
NEXT = 1.01
"""Cells no farther than this from each other, in pitches, are next to each other."""
MAX_RADIUS = 0.15
"""Radius in metres of the largest circle that the workspace holds."""
FEWEST = {"circle": 8, "square": 8, "rectangle": 10, "triangle": 6, "L": 5, "T": 5, "V": 5, "U": 7, "plus": 5, "X": 5}
"""The fewest blocks that show each figure plainly."""
FEWEST_FILLED = {"square": 9, "rectangle": 6, "triangle": 6, "circle": 7}
NATURAL: dict[str, Direction] = {"L": "right", "U": "back", "triangle": "back"}
"""Where undirected figures point as they are usually seen; the others point to the front."""
QUARTERS: dict[Direction, int] = {"front": 0, "right": 1, "back": 2, "left": 3}
"""Quarter turns counter-clockwise that bring a figure that points to the front to point elsewhere."""


class Cell(NamedTuple):
    """A place in a figure: position in pitches, level, and its line numbers."""

    x: float
    y: float
    level: int = 0
    row: int = 0
    column: int = 0


@dataclass(frozen=True, eq=False)
class Ideal:
    """A figure, compared by identity.

    `limit`: how far it may be turned from as it stands, in degrees (None: in any way, and mirrored too). `ring`: its
    cells go round in a circle, clockwise from the far side. `room`: the most that its pitch may be in metres, where
    that is not left to the blocks.
    """

    cells: tuple[Cell, ...]
    limit: float | None = None
    ring: bool = False
    room: float | None = None


@cache
def neighbors(ideal: Ideal) -> tuple[tuple[int, int], ...]:
    """The cells, two by two, that are next to each other at one level: a pitch apart."""
    cells = list(enumerate(ideal.cells))
    return tuple(
        (i, j)
        for i, one in cells
        for j, other in cells[:i]
        if one.level == other.level and math.hypot(one.x - other.x, one.y - other.y) < NEXT
    )


def ideals(node: Cells, count: int) -> tuple[Ideal, ...]:
    """The figures that `node` accepts for so many blocks, the most natural first; the same objects for every node
    that differs in its blocks alone."""
    return _ideals(_Form(node), count)


@cache
def _form_fields(kind: type[Cells]) -> tuple[str, ...]:
    return tuple(field for field in kind.model_fields if field not in Cells.model_fields)


class _Form:
    """A node, equal to every other one that asks for the same figures."""

    def __init__(self, node: Cells) -> None:
        lines = (node.pattern.kind, node.pattern.own, by_layers(node)) if node.pattern is not None else None
        self.node = node
        self.key = type(node), node.readable, lines, *[getattr(node, field) for field in _form_fields(type(node))]

    def __hash__(self) -> int:
        return hash(self.key)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, _Form) and self.key == other.key


@lru_cache(maxsize=512)
def _ideals(form: _Form, count: int) -> tuple[Ideal, ...]:
    node = form.node
    match node:
        case Grid():
            found = _grids(node)
        case Pyramid():
            found = _pyramids(node)
        case Staircase():
            found = _staircases(node)
        case Figure():
            found = _figures(node, count)
        case _:
            raise TypeError(f"no figure of kind {type(node).__name__}")
    return tuple(ideal for ideal in found if len(ideal.cells) == count)


@lru_cache(maxsize=64)
def flat_forms(count: int) -> tuple[Ideal, ...]:
    """Every flat figure of so many blocks, in any direction, a straight line among them."""
    found = [Ideal(_numbered((0.0, float(k)) for k in range(count)))]
    for filled in (False, True):
        for shape in sorted(FEWEST_FILLED if filled else FEWEST):
            node = Figure(blocks=("",), shape=shape, filled=filled)  # type: ignore[arg-type]
            found += [replace(ideal, limit=None) for ideal in ideals(node, count)]
    return tuple(found)


def upright(node: Cells) -> bool:
    """Is the figure a wall, seen from its side, rather than something seen from above?"""
    match node:
        case Grid():
            return node.rows == 1 and node.layers > 1
        case Pyramid():
            return min(node.base) == 1
        case _:
            return isinstance(node, Staircase)


def _reads_lines(node: Cells, kinds: tuple[str, ...] = ("row", "column", "reading")) -> bool:
    told = node.pattern is not None and node.pattern.kind in kinds and not node.pattern.own
    return told and not by_layers(node)


def _side_limit(node: Cells) -> float | None:
    """How far a wall may be turned from the viewer's left and right."""
    if node.readable:
        return NAMED
    return NEAREST if _reads_lines(node, ("reading",)) else None


def _grids(node: Grid) -> Iterator[Ideal]:
    cells = [
        Cell(-r, -c, level, r, c) for level in range(node.layers) for r in range(node.rows) for c in range(node.columns)
    ]
    if node.axis is not None:
        limit: float | None = NAMED
    elif node.rows == 1:
        limit = _side_limit(node)
    else:
        limit = NEAREST if node.rows != node.columns or _reads_lines(node) else None
    yield Ideal(_turned(cells, 1 if node.axis == "x" else 0), limit)


def _pyramids(node: Pyramid) -> Iterator[Ideal]:
    columns, rows = node.base if node.base[1] != 1 or node.base[0] == 1 else (node.base[0], 1)
    columns, rows = (rows, 1) if columns == 1 else (columns, rows)
    height = columns if rows == 1 else min(columns, rows)
    cells = []
    for level in range(height):
        inset, depth = level / 2, 0.0 if rows == 1 else level / 2
        for r in range(1 if rows == 1 else rows - level):
            cells += [Cell(-r - depth, -c - inset, level, r, c) for c in range(columns - level)]
    limit = _side_limit(node) if rows == 1 else NEAREST if _reads_lines(node) else None
    yield Ideal(_turned(cells, 0), limit)


def _staircases(node: Staircase) -> Iterator[Ideal]:
    last = node.steps - 1
    rising = [Cell(0.0, float(j), level, 0, last - j) for j in range(node.steps) for level in range(j + 1)]
    falling = [Cell(0.0, -float(j), level, 0, j) for j in range(node.steps) for level in range(j + 1)]
    if node.up is None:
        limit = _side_limit(node)
        yield Ideal(_turned(rising, 0), limit)
        if limit is not None:
            yield Ideal(_turned(falling, 0), limit)
    elif node.up in ("left", "right"):
        yield Ideal(_turned(rising if node.up == "left" else falling, 0), NAMED)
    else:
        yield Ideal(_turned(rising, 3 if node.up == "back" else 1), NAMED)


def _figures(node: Figure, count: int) -> Iterator[Ideal]:
    """Flat figures; those that can point are drawn pointing to the front."""
    if node.shape == "circle":
        yield _circle(count, node.filled)
        return
    implied = NEAREST if _reads_lines(node) else None
    limit = NAMED if node.pointing is not None else NEAREST / 2 if node.shape == "X" else implied
    for points in _drawings(node, count):
        for cells in _pointed(node, points):
            yield Ideal(_numbered(cells), limit)


Points = list[tuple[float, float]]


def _pointed(node: Figure, points: Points) -> Iterator[Points]:
    """A drawing turned to point where `node` says, or as it is usually seen; an L has its stem behind its foot.

    An L that points to the front or the back may have its stem on either side.
    """
    pointing = node.pointing or NATURAL.get(node.shape, "front")
    quarters = QUARTERS[pointing]
    mirrored = [(x, -y) for x, y in points]
    if node.shape == "L" and pointing == "right":
        yield _rotated(mirrored, quarters)
        return
    yield _rotated(points, quarters)
    if node.shape == "L" and pointing in ("front", "back"):
        yield _rotated(mirrored, quarters)


def _rotated(points: Points, quarters: int) -> Points:
    for _ in range(quarters):
        points = [(-y, x) for x, y in points]
    return points


def _drawings(node: Figure, count: int) -> Iterator[Points]:
    """The figure without its line numbers, for every size that fits `count` blocks."""
    for sides in [node.sides] if node.sides is not None else _sizes(node.shape, node.filled, count):
        a, b = sides
        if node.shape in ("square", "rectangle"):
            yield [(x, y) for x in range(a) for y in range(b) if node.filled or x in (0, a - 1) or y in (0, b - 1)]
        elif node.shape == "triangle":
            yield from _triangles(a, node.filled, node.pointing is not None)
        elif node.shape == "L":
            yield [(0.0, float(k)) for k in range(a)] + [(-float(k), 0.0) for k in range(1, b)]
        elif node.shape == "T":
            yield [(0.0, k - (a - 1) / 2) for k in range(a)] + [(-float(k), 0.0) for k in range(1, b)]
        elif node.shape == "V":
            yield from _vees(a)
        elif node.shape == "U":
            arms = [(-float(k), float(y)) for k in range(1, a) for y in (0, b - 1)]
            yield [(0.0, float(y)) for y in (0, b - 1, *range(1, b - 1))] + arms
        else:
            slant = math.pi / 4 if node.shape == "X" else 0.0
            bars = {(x, 0) for x in _arm(a)} | {(0, y) for y in _arm(b)}
            turn = cmath.rect(1.0, slant)
            yield [((p := complex(*bar) * turn).real, p.imag) for bar in sorted(bars)]


def _arm(length: int) -> range:
    return range(-(length // 2), length // 2 + 1)


def _triangles(side: int, filled: bool, pointing: bool) -> Iterator[Points]:
    """Equal sides; then as high as wide; then with a right angle. The apex is in front."""
    rows = [(k, [j - k / 2 for j in range(k + 1) if filled or k == side - 1 or j in (0, k)]) for k in range(side)]
    for height in (math.sqrt(0.75), 1.0):
        yield [(k * height, y) for k, row in rows for y in row]
    if not pointing:
        yield [(float(k), y + k / 2) for k, row in rows for y in row]


def _vees(arm: int) -> Iterator[Points]:
    """Two arms from an apex in front, opening by a third or a quarter of a turn's half."""
    for half in (math.pi / 6, math.pi / 4):
        step = math.cos(half), math.sin(half)
        yield [(0.0, 0.0)] + [(k * step[0], sign * k * step[1]) for k in range(1, arm) for sign in (1, -1)]


def _circle(count: int, filled: bool) -> Ideal:
    """A ring, or rings around a block in the middle; neighbours at unit distance."""
    if not filled:
        radius = 0.5 / math.sin(math.pi / count) if count > 1 else 0.0
        room = MAX_RADIUS / radius if radius else None
        return Ideal(tuple(Cell(x, y, 0, 0, k) for k, (x, y) in enumerate(_ring(count, radius))), None, True, room)
    points, left, k = [(0.0, 0.0)], count - 1, 0
    while left > 0:
        k += 1
        number = left if left <= 6 * k + 6 and k == 1 else min(left, 6 * k)
        points += _ring(number, max(float(k), 0.5 / math.sin(math.pi / max(number, 2))))
        left -= number
    return Ideal(_numbered(points), None)


def _ring(count: int, radius: float) -> Points:
    """Points on a circle, clockwise from the far side."""
    turns = [2 * math.pi * k / count for k in range(count)]
    return [(radius * math.cos(t), -radius * math.sin(t)) for t in turns]


def _sizes(shape: str, filled: bool, count: int) -> list[tuple[int, int]]:
    """Sides or arms of the figures of so many blocks, the most even first."""
    pairs = [(a, b) for a in range(2, count) for b in range(2, count)]
    if shape == "rectangle":
        fitting = [(a, b) for a, b in pairs if a <= b and (a * b if filled else 2 * (a + b) - 4) == count]
        fitting = [pair for pair in fitting if pair[0] != pair[1]] or fitting
    elif shape == "square":
        fitting = [(a, a) for a in range(2, count) if (a * a if filled else 4 * a - 4) == count]
    elif shape == "triangle":
        fitting = [(a, a) for a in range(2, count + 1) if (a * (a + 1) // 2 if filled else 3 * a - 3) == count]
    elif shape == "L":
        fitting = [(a, b) for a, b in pairs if a >= b and a + b - 1 == count]
        return sorted(fitting, key=lambda pair: (pair[0] == pair[1], abs(pair[0] - 1.5 * pair[1])))
    elif shape == "T":
        fitting = [(a, b) for a, b in pairs if a % 2 and a + b - 1 == count]
    elif shape == "V":
        fitting = [(a, a) for a in range(2, count) if 2 * a - 1 == count]
    elif shape == "U":
        fitting = [(a, b) for a, b in pairs if b >= 3 and b + 2 * (a - 1) == count]
    else:
        fitting = [(a, b) for a, b in pairs if a % 2 and b % 2 and a + b - 1 == count]
        fitting = [(a, b) for a, b in fitting if a == b] if shape == "X" else fitting
    return sorted(fitting, key=lambda pair: (abs(pair[0] - pair[1]), pair))


def _numbered(points: Iterable[tuple[float, float]]) -> tuple[Cell, ...]:
    """Cells with rows from far to near and columns from left to right, centred."""
    pool = [(round(x, 6), round(y, 6)) for x, y in points]
    rows = {x: k for k, x in enumerate(sorted({x for x, _ in pool}, reverse=True))}
    columns = {y: k for k, y in enumerate(sorted({y for _, y in pool}, reverse=True))}
    return _centred([Cell(x, y, 0, rows[x], columns[y]) for x, y in pool])


def _turned(cells: list[Cell], quarters: int) -> tuple[Cell, ...]:
    """Cells turned by quarters counter-clockwise, keeping their line numbers, centred."""
    places = _rotated([(cell.x, cell.y) for cell in cells], quarters)
    return _centred([cell._replace(x=x, y=y) for cell, (x, y) in zip(cells, places, strict=True)])


def _centred(cells: list[Cell]) -> tuple[Cell, ...]:
    cx = sum(cell.x for cell in cells) / len(cells)
    cy = sum(cell.y for cell in cells) / len(cells)
    return tuple(cell._replace(x=cell.x - cx, y=cell.y - cy) for cell in cells)


def figure_size(shape: str, filled: bool = False, sides: tuple[int, int] | None = None) -> int:
    """How many blocks a flat figure takes: by its sides, or the fewest that show it plainly."""
    if sides is None:
        return FEWEST_FILLED[shape] if filled and shape in FEWEST_FILLED else FEWEST[shape]
    node = Figure(blocks=("",), shape=shape, filled=filled, sides=sides)  # type: ignore[arg-type]
    return len(next(_drawings(node, 0)))


def ring_width(count: int, edge: float, gap: float = 0.0) -> float:
    """Distance in metres across the tightest circle of cubes that face its middle, between opposite centres."""
    return edge + (edge + gap) / math.tan(math.pi / count)


def pyramid_size(base: tuple[int, int]) -> int:
    """Blocks of a pyramid with so many at its base."""
    n, m = max(base), min(base)
    return n * (n + 1) // 2 if m == 1 else sum((n - k) * (m - k) for k in range(m))


def staircase_size(steps: int) -> int:
    """Blocks of a staircase of so many steps."""
    return steps * (steps + 1) // 2


def takes(node: Cells, count: int) -> bool:
    """Can the figure be made of exactly so many blocks?"""
    return bool(ideals(node, count))


def lines(cells: Iterable[Cell], kind: str) -> dict[tuple[int, ...], list[int]]:
    """The cells (by index) of each row, column or layer.

    A row is horizontal, from left to right. A column goes from front to back on the table, but is vertical in a
    figure of several layers.
    """
    pool = list(cells)
    tall = any(cell.level for cell in pool)
    found: dict[tuple[int, ...], list[int]] = {}
    for k, cell in enumerate(pool):
        if kind == "layer":
            key: tuple[int, ...] = (cell.level,)
        elif kind == "row":
            key = (cell.level, cell.row)
        else:
            key = (cell.row, cell.column) if tall else (cell.column,)
        found.setdefault(key, []).append(k)
    return found


def line_sizes(node: Cells, count: int) -> list[int]:
    """How many blocks share a value in each line of the node's pattern (two alternating values: checkerboard)."""
    found = ideals(node, count)
    if not found or node.pattern is None or node.pattern.kind == "reading":
        return []
    if node.pattern.kind == "checkerboard":
        odd = sum((cell.row + cell.column + cell.level) % 2 for cell in found[0].cells)
        return [count - odd, odd]
    return [len(cells) for cells in lines(found[0].cells, node.pattern.kind).values()]
