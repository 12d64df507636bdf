"""Figures as cells, and pictures of them with a look for each cell."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from tests.corpus.composed.ordering.phrased import Meaning

Cell = tuple[int, int, int]
"""Row from far to near, column from left to right, layer from the bottom."""


@dataclass(frozen=True)
class Figure:
    """Its cells; `pitch` between them; `slopes`: layers that stand over the gaps of those below, "flat" or "square"."""

    cells: tuple[Cell, ...]
    slopes: str = ""
    pitch: float = 1.0

    def draw(self, looks: Mapping[Cell, str]) -> str:
        """A picture of it with a look for each cell."""
        if self.slopes == "flat":
            return self._from_the_side(looks)
        rows, columns = 1 + max(r for r, _, _ in self.cells), 1 + max(c for _, c, _ in self.cells)
        lines = [" ".join(self._pile(r, c, looks) for c in range(columns)) for r in range(rows)]
        return f"{' | '.join(lines)} pitch={self.pitch}"

    def _pile(self, row: int, column: int, looks: Mapping[Cell, str]) -> str:
        over = {cell: "(0.5,0.5)" * (self.slopes == "square" and cell[2] % 2) for cell in self.cells}
        return "^".join(looks[x] + over[x] for x in sorted(self.cells) if x[:2] == (row, column)) or "."

    def _from_the_side(self, looks: Mapping[Cell, str]) -> str:
        base = 1 + max(c for _, c, _ in self.cells)
        rows = []
        for layer in range(base - 1, -1, -1):
            row = ["."] * (2 * base - 1)
            for c in range(base - layer):
                row[2 * c + layer] = looks[(0, c, layer)]
            rows.append(" ".join(row))
        return f"side pitch=0.55,1 {' | '.join(rows)}"

    def plain(self, color: str) -> str:
        """All of one colour."""
        return self.draw(dict.fromkeys(self.cells, color))


def of(*rows: str) -> Figure:
    """A figure flat on the table: `x` where a block lies."""
    return Figure(tuple((r, c, 0) for r, row in enumerate(rows) for c, x in enumerate(row) if x == "x"))


def line(count: int) -> Figure:
    """A row."""
    return Figure(tuple((0, c, 0) for c in range(count)), pitch=1.25)


def cuboid(rows: int, columns: int, layers: int = 1) -> Figure:
    """A grid, a wall, a tower, a solid cube."""
    return Figure(tuple((r, c, k) for r in range(rows) for c in range(columns) for k in range(layers)))


def pyramid(base: int) -> Figure:
    """A flat one."""
    return Figure(tuple((0, c, k) for k in range(base) for c in range(base - k)), "flat")


def square_pyramid(base: int) -> Figure:
    """One on a square, of two or three layers."""
    cells: list[Cell] = []
    for k in range(base):
        first = (k + 1) // 2
        cells += [(first + r, first + c, k) for r in range(base - k) for c in range(base - k)]
    return Figure(tuple(cells), "square")


def stairs(steps: int, *, left: bool = False) -> Figure:
    """A staircase going up to the right, or to the left."""
    return Figure(tuple((0, c, k) for c in range(steps) for k in range(steps - c if left else c + 1)))


L = {"right": of("x..", "x..", "xxx"), "left": of("..x", "..x", "xxx")}
"""By the side to which its foot points."""
T = {
    "me": of("xxx", ".x.", ".x."), "far": of(".x.", ".x.", "xxx"),
    "left": of("..x", "xxx", "..x"), "right": of("x..", "xxx", "x.."),
}  # fmt: skip
"""By the side to which its stem points."""
U = {
    "far": of("x.x", "x.x", "xxx"), "me": of("xxx", "x.x", "x.x"),
    "left": of("xxx", "..x", "xxx"), "right": of("xxx", "x..", "xxx"),
}  # fmt: skip
"""By the side to which it is open."""
V = {
    "me": of("x...x", ".x.x.", "..x.."), "far": of("..x..", ".x.x.", "x...x"),
    "right": of("x..", ".x.", "..x", ".x.", "x.."), "left": of("..x", ".x.", "x..", ".x.", "..x"),
}  # fmt: skip
"""By the side to which its point points."""
PLUS = of(".x.", "xxx", ".x.")
RING = of("xxx", "x.x", "xxx")
ACROSS = {"me": "far", "far": "me", "left": "right", "right": "left"}


def of_one_color(figure: Figure, color: str, misses: Sequence[Figure], *also: Figure) -> Meaning:
    """What a figure of one colour means; `also`: others that are right."""
    count = len(figure.cells)
    last = figure.cells[-1]
    broken = figure.draw({c: color if c != last else f"{color}(4,3)" for c in figure.cells})
    same = [miss.plain(color) for miss in misses if len(miss.cells) == count]
    hold = [form.plain(color) for form in (figure, *also)]
    return {"assets": {color: count}, "hold": hold, "miss": [*same, broken, "^".join([color] * min(count, 9))]}


def of_parts(figure: Figure, cells: Mapping[str, Sequence[Cell]]) -> Meaning:
    """What a figure means whose cells have these colours; near misses: two swapped, all turned on, broken."""
    looks = {cell: color for color, some in cells.items() for cell in some}
    colors = list(cells)
    one, other = cells[colors[0]][0], cells[colors[-1]][0]
    swapped = looks | {one: looks[other], other: looks[one]}
    last = figure.cells[-1]
    broken = looks | {last: f"{looks[last]}(4,3)"}
    misses: list[dict[Cell, Any]] = [swapped, broken]
    if len({len(some) for some in cells.values()}) == 1:
        turned = dict(zip(colors, colors[1:] + colors[:1], strict=True))
        misses.append({cell: turned[look] for cell, look in looks.items()})
    counts = {color: len(some) for color, some in cells.items()}
    return {"assets": counts, "hold": [figure.draw(looks)], "miss": [figure.draw(miss) for miss in misses]}
