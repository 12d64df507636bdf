"""The colours of all places in a grid, wall, pyramid or cube, as they follow from what is said of some."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable
from dataclasses import replace

from rpg.language.frames.grids.parts import Blocks, Said
from rpg.language.frames.grids.sizes import Figure
from rpg.language.frames.grids.words import Place
from rpg.language.frames.pieces import Unclear

Cell = tuple[int, int]
_ENDS = {
    "row": {"far": 0, "top": 0, "near": -1, "bottom": -1},
    "column": {"left": 0, "right": -1},
    "layer": {"top": 0, "bottom": -1},
}
"""Which line of an axis is at a side: the first or the last."""
_BETWEEN = Place("rest", "between")
"""Between other lines, or blocks."""


class Filling:
    """A figure whose places are filled. `looks`: what is told for places, "" where only their number is."""

    def __init__(self, figure: Figure, told: Said) -> None:
        self.figure = figure
        self.looks: dict[Cell, str] = {}
        self._told = told
        self._axis = told.axis or next((p.axis for ps, _ in told.placed for p in ps if p.axis), None)
        self._line = len(figure.widths) - 1 if told.based else None
        self._step = -1
        self._rests: list[tuple[Place, list[Blocks]]] = []
        for places, blocks in told.placed:
            self._place(places, blocks)
        if told.listed:
            self._list()
        for place, blocks in self._rests:
            rest = [cell for cell in figure.cells if cell not in self.looks]
            blocks = _repeated(blocks)
            lines = self._left_lines(self._axis) if self._axis and place.many else []
            if place.many not in (0, len(rest), len(lines)) or not self.looks:
                raise Unclear
            self._put(rest, blocks)

    def _place(self, places: list[Place], blocks: list[Blocks]) -> None:
        if places == [_BETWEEN] and any(p.kind == "line" for ps, _ in self._told.placed for p in ps):
            places = [_BETWEEN._replace(kind="line", side="middle", many=1)]
        if any(place.kind == "rest" for place in places):
            if len(places) > 1:
                raise Unclear
            self._rests.append((places[0], blocks))
            return
        found = [cell for place in places for cell in self._cells(place)]
        if len(set(found)) < len(found) or any(place.blocks not in (0, len(found)) for place in places):
            raise Unclear
        if any(place.kind == "cells" and place.many for place in places) and blocks[0].count == 1:
            blocks = [replace(blocks[0], count=None)]  # "one in each corner"
        if all(place.kind == "cells" for place in places) and len(found) > 1:
            blocks = _repeated(blocks)
        self._put(found, blocks)

    def _left_lines(self, axis: str) -> list[int]:
        """The lines of an axis of which nothing is told yet."""
        lines = self.lines("layer" if axis == "row" and not self.figure.flat else axis)
        return [n for n, line in enumerate(lines) if not any(cell in self.looks for cell in line)]

    def _put(self, cells: list[Cell], blocks: list[Blocks]) -> None:
        if len(blocks) == 1:
            looks = [blocks[0].look] * len(cells)
            if blocks[0].count not in (None, len(cells)):
                raise Unclear
        else:  # one behind the other in their line
            looks = [one.look for one in blocks for _ in range(one.count or 1)]
            if len({line for line, _ in cells}) > 1 or not (
                self._told.in_lines or all(one.label for one in blocks) or _again(blocks)
            ):
                raise Unclear  # in which order?
        if len(looks) != len(cells) or not cells:
            raise Unclear
        for cell, look in zip(cells, looks, strict=True):
            if look and self.looks.get(cell):
                raise Unclear
            self.looks[cell] = look or self.looks.get(cell, "")

    def _list(self) -> None:
        axis, start, listed = self._told.axis or self.figure.axis, self._told.start, self._told.listed
        axis = "layer" if axis == "row" and not self.figure.flat else axis
        start = start or {"row": "far", "column": "left"}.get(axis)  # as one reads
        lines = self.lines(axis)
        if self._told.alternating and len(listed) == 2 and len(lines) > 1:
            listed = [listed[n % 2] for n in range(len(lines))]
        if start is None or start not in _ENDS[axis] or len(lines) != len(listed) or self.looks:
            raise Unclear
        for line, one in zip(lines if _ENDS[axis][start] == 0 else lines[::-1], listed, strict=True):
            self._put(line, [one])

    def lines(self, axis: str) -> list[list[Cell]]:
        """The cells of each line of an axis."""
        if axis == self.figure.axis:
            return [[(n, k) for k in range(width)] for n, width in enumerate(self.figure.widths)]
        if axis != "column" or not self.figure.columns:
            raise Unclear
        return [[(n, k) for n in range(len(self.figure.widths))] for k in range(self.figure.widths[0])]

    def _cells(self, place: Place) -> list[Cell]:
        if place.kind == "cells":
            return self._single(place.side)
        if place.side == "middle" and place.axis is None and self._central():
            return self._single("center")
        if place.side == "middle" and place.axis is None and place.blocks == 4 and self._even():
            return self._single("inside")
        axis = self._axis_of(place)
        lines = self.lines(axis)
        numbers = self._numbers(place, axis, lines)
        if not numbers or not 0 <= min(numbers) <= max(numbers) < len(lines):
            raise Unclear
        if axis == self.figure.axis:
            self._step = 1 if (self._line is None and numbers[0] == 0) else self._step
            self._line = numbers[0]
        return [cell for n in numbers for cell in lines[n]]

    def _central(self) -> bool:
        """Whether "the middle" is a block: no other lines are told."""
        others = [p for ps, _ in self._told.placed for p in ps if p.kind == "line" and p.side != "middle"]
        odd = len(self.figure.widths) % 2 == self.figure.widths[0] % 2 == 1
        return self.figure.flat and odd and not others and self._axis is None

    def _even(self) -> bool:
        """Whether the four blocks in the middle are all those inside: "the middle four" of a 4x4 grid."""
        return self.figure.flat and len(self.figure.widths) == self.figure.widths[0] == 4

    def _axis_of(self, place: Place) -> str:
        axis = place.axis
        if axis == "row" and not self.figure.flat:
            if place.side.isdigit() or place.side == "last":
                raise Unclear  # counted from below or from above?
            return "layer"
        if axis is None and place.side in ("left", "right"):
            axis = "column"
        elif axis is None and place.side in ("far", "near"):
            axis = "row"
        elif axis is None and place.side in ("top", "bottom", "above", "above it", "below", "next"):
            axis = "layer"
        elif axis is None:
            axis = self._axis if self._axis != "row" or self.figure.flat else "layer"
            if axis is None and any(p.side in ("left", "right") for ps, _ in self._told.placed for p in ps):
                axis = "column"
        high, wide = len(self.figure.widths), self.figure.widths[0]
        if axis is None and place.side == "middle" and self.figure.flat and high % 2 == 0 and wide % 2:
            axis = "column"
        axis = axis or self.figure.axis
        if axis == "layer" and self.figure.flat:
            raise Unclear
        return axis

    def _numbers(self, place: Place, axis: str, lines: list[list[Cell]]) -> list[int]:
        """Which lines of an axis are meant."""
        side, count = place.side, len(lines)
        many = (place.many or 1) if place.many >= 0 else count // 2 if count % 2 == 0 else count
        if side in _ENDS[axis]:
            if many >= count:
                raise Unclear
            return list(range(many)) if _ENDS[axis][side] == 0 else list(range(count - many, count))
        if side == "middle" and (count - many) % 2 == 0 and 0 < many < count:
            return list(range((count - many) // 2, (count + many) // 2))
        if side == "outer" and many == 2 and count > 2:
            return [0, count - 1]
        if side.isdigit() or side == "last":
            first = int(side) - 1 if side.isdigit() else count - 1
            backwards = _ENDS[axis].get(self._told.start or "", -1 if axis == "layer" else 0) != 0
            first = count - 1 - first if backwards else first
            if many > 1 and side not in ("1", "last"):
                raise Unclear
            last = first + (many - 1) * (1 if (side == "1") != backwards else -1)
            return list(range(min(first, last), max(first, last) + 1))
        if side == "other":
            left = self._left_lines(axis)
            if len(left) != many:
                raise Unclear
            return left
        return [self._beside(side, count)]

    def _beside(self, side: str, count: int) -> int:
        """A line told by the one before."""
        if any(p.side in ("middle", "between") for ps, _ in self._told.placed for p in ps) and side in (
            "above",
            "below",
        ):
            return 0 if side == "above" else count - 1
        if (side == "above it" and self.figure.columns) or side == "middle":
            raise Unclear
        if self._line is None:
            if side == "next" or (side != "below" and count != 2):
                raise Unclear
            return count - 1 if side == "below" else 0
        return self._line + {"below": 1, "next": self._step}.get(side, -1)

    def _single(self, side: str) -> list[Cell]:
        """The cells of a place that is no line."""
        high, wide = len(self.figure.widths), self.figure.widths[0]
        if not self.figure.columns:
            raise Unclear
        corners = [(0, 0), (0, wide - 1), (high - 1, 0), (high - 1, wide - 1)]
        if side == "corners":
            return corners
        if side == "center" and high % 2 and wide % 2 and self.figure.flat:
            return [(high // 2, wide // 2)]
        border = [(n, k) for n, k in self.figure.cells if n in (0, high - 1) or k in (0, wide - 1)]
        if side == "border" and min(high, wide) > 2:
            return border
        if side == "inside":
            return [cell for cell in self.figure.cells if cell not in border]
        if side == "edges" and min(high, wide) > 2:
            named = any(place.side == "corners" for places, _ in self._told.placed for place in places)
            return [cell for cell in border if not named or cell not in corners]
        if "diagonal" in side and high == wide and self.figure.flat:
            falling, rising = [(n, n) for n in range(high)], [(n, high - 1 - n) for n in range(high)]
            return {"diagonal left": falling, "diagonal right": rising}.get(side, list(dict.fromkeys(falling + rising)))
        line, _, column = side.partition(" ")
        if not column or line not in _ENDS[self.figure.axis]:
            raise Unclear
        return [corners[(2 if _ENDS[self.figure.axis][line] else 0) + (column == "right")]]


def _repeated(blocks: list[Blocks]) -> list[Blocks]:
    """A symbol at several places is on each of them: "O everywhere else"."""
    return [replace(blocks[0], count=None)] if len(blocks) == 1 and blocks[0].label else blocks


def _again(blocks: list[Blocks]) -> bool:
    """Whether a look is told again ("red, red, blue"), so that the order is told."""
    return len(blocks) > len({one.look for one in blocks})


def completed(filling: Filling, free: Iterable[Blocks], total: int | None) -> dict[str, int] | None:
    """Fills the places that are left, if there is one kind of blocks for them, and checks all numbers. Where nothing is
    told of places: the number of each kind of blocks; None where it is told for each place, or no kind is.

    Raises:
        Unclear: the numbers do not agree, or it does not follow which blocks are where.
    """
    cells, looks = filling.figure.cells, filling.looks
    if total not in (None, len(cells)):
        raise Unclear
    there = {look for look in looks.values() if look}
    new = [one for one in free if one.look not in there]
    names = list(dict.fromkeys(one.look for one in new))
    left = [cell for cell in cells if not looks.get(cell)]
    if len(names) > 1:
        if there:
            raise Unclear
        return _shared(new, names, len(cells))
    if names:
        looks |= dict.fromkeys(left, names[0])
    elif left and there:
        raise Unclear
    counts = Counter(looks.get(cell, "") for cell in cells)
    bare = [one.look for one in free if one.bare]
    if len(set(bare)) < len(bare):
        raise Unclear  # "white, black, white"
    if any(one.count not in (None, counts[one.look]) for one in free) or (names and not left):
        raise Unclear
    return None


def _shared(blocks: list[Blocks], names: list[str], size: int) -> dict[str, int]:
    """The number of each kind, as far as they follow from that of all."""
    counts: dict[str, int | None] = {}
    for name in names:
        told = {one.count for one in blocks if one.look == name} - {None}
        if len(told) > 1:
            raise Unclear
        counts[name] = next(iter(told), None)
    open_ = [name for name in names if counts[name] is None]
    rest = size - sum(count or 0 for count in counts.values())
    if len(open_) == 1 and rest > 0:
        counts[open_[0]], rest = rest, 0
    if rest or any(count is None for count in counts.values()):
        raise Unclear
    return {name: count for name, count in counts.items() if count}
