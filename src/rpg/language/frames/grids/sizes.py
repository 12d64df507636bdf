"""The sizes of grids, walls, pyramids and cubes of blocks: which figures agree with all that is told."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from itertools import product

from rpg.language.frames.pieces import Unclear

MOST = 30
"""The most blocks of a task."""


@dataclass(frozen=True)
class Figure:
    """Blocks line by line: the rows of a flat figure from the far one, the layers of one that stands from the top.

    `widths`: blocks in each line. `told`: the figure in words. `columns`: its lines have blocks over or behind those
    of the next, `flat`: it lies on the table.
    """

    told: str
    widths: tuple[int, ...]
    columns: bool = True
    flat: bool = False
    square: bool = False

    @property
    def axis(self) -> str:
        """What its lines are."""
        return "row" if self.flat else "layer"

    @property
    def cells(self) -> list[tuple[int, int]]:
        """All places, in the order in which they are read."""
        return [(line, n) for line, width in enumerate(self.widths) for n in range(width)]


@dataclass(frozen=True)
class Sizes:
    """All that is told of the size. `each`: numbers by what is counted; `dims`, `base`: "3 by 4", of all or below."""

    each: Mapping[str, int]
    dims: tuple[int, ...] | None = None
    base: tuple[int, ...] | None = None

    def agree(self, **found: int) -> bool:
        """Each number that is told is that of the figure, and it has such a number."""
        return all(found.get(name) == number for name, number in self.each.items())

    @property
    def any(self) -> bool:
        """Something is told."""
        return bool(self.each or self.dims or self.base)


def figures(kind: str, words: str, sizes: Sizes) -> Iterator[Figure]:
    """All figures of a kind that have the sizes told. `words`: the figure as it was called."""
    if kind in ("grid", "board", "rectangle", "square"):
        tall = "layers" in sizes.each or len(sizes.dims or ()) == 3
        yield from _cubes(words, sizes) if tall else _flat(kind, words, sizes)
    elif kind == "wall":
        yield from _walls(sizes)
    elif kind == "cube":
        yield from _cubes(words, sizes)
    else:
        yield from _pyramids(words, sizes)


def _flat(kind: str, words: str, sizes: Sizes) -> Iterator[Figure]:
    filled = {"filled", "solid", "full", "complete"} & set(words.split())
    if kind == "square" and not filled and not sizes.dims and sizes.each != {"side": 2}:
        raise Unclear  # its outline
    for rows, columns in product(range(2, 11), range(2, 11)):
        sides = {"side": rows} if rows == columns else {}
        if rows * columns > MOST or sizes.dims not in (None, (rows, columns)) or sizes.base:
            continue
        if "square" in words.split() and rows != columns:
            continue
        if sizes.agree(rows=rows, deep=rows, columns=columns, wide=columns, **sides):
            told = f"a grid of {rows} rows and {columns} columns"
            turned = kind == "rectangle" and not sizes.each
            yield Figure(f"a filled {rows} by {columns} rectangle" if turned else told, (columns,) * rows, flat=True)


def _walls(sizes: Sizes) -> Iterator[Figure]:
    for wide, high in product(range(2, 13), range(2, 9)):
        if wide * high > MOST or sizes.dims not in (None, (wide, high)) or sizes.base:
            continue
        below = {"columns": wide, "wide": wide, "layer": wide, "base": wide, "line": wide}
        if sizes.agree(**below, rows=high, layers=high, high=high, deep=1):
            yield Figure(f"a wall {wide} blocks wide and {high} blocks high", (wide,) * high)


def _cubes(words: str, sizes: Sizes) -> Iterator[Figure]:
    for rows, columns, layers in product(range(2, 6), range(2, 6), range(2, 6)):
        if rows * columns * layers > MOST or sizes.base:
            continue
        if sizes.dims and sizes.dims != (rows, columns, layers)[: len(sizes.dims)]:
            continue
        even = rows == columns == layers
        if not sizes.any and (not even or "cube" not in words.split()):
            continue
        found = {"rows": rows, "deep": rows, "columns": columns, "wide": columns, "layers": layers, "high": layers}
        if sizes.agree(**found, layer=rows * columns, **({"side": rows} if even else {})):
            told = f"a grid of {rows} rows, {columns} columns and {layers} layers"
            yield Figure(told, (rows * columns,) * layers, columns=False)


def _pyramids(words: str, sizes: Sizes) -> Iterator[Figure]:
    """Those in one line first."""
    called = set(words.split())
    base = sizes.base or sizes.dims
    if base is None and not called & {"square", "based"}:
        for n in range(2, 8):
            if sizes.agree(base=n, line=n, wide=n, layers=n, high=n, rows=n):
                yield Figure(f"a pyramid with a base of {n} blocks", tuple(range(1, n + 1)), columns=False)
    if called & {"flat", "triangular", "dimensional"}:
        return
    for n, m in product(range(2, 5), range(2, 5)):
        if (base or (n, n)) != (n, m) or (base is None and n != m):
            continue
        high = min(n, m)
        widths = tuple((n - k) * (m - k) for k in reversed(range(high)))
        if sum(widths) > MOST:
            continue
        for below in {n * m} | ({n} if called & {"square"} else set()):
            if sizes.agree(base=below, layers=high, high=high, rows=high, **({"wide": n} if base else {})):
                yield Figure(f"a pyramid with a {n}x{m} base", widths, columns=False, square=True)
