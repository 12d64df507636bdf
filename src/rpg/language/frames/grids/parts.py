"""What is said of the blocks of a grid, wall, pyramid or cube: which of them are where."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from math import prod

from rpg.language.frames.grids.words import Place
from rpg.language.frames.pieces import Piece, Unclear, number

_SINGLE = frozenset({"block", "cube", "piece", "element", "tile", "one"})
_STRONG = (".", ";", "!", "?")


@dataclass(frozen=True)
class Blocks:
    """Blocks as they are named. `look`: empty where none is told; `count`: None where that is left open; `bare`: a
    colour alone; `label`: the look is a symbol; `base`: they were told as "3x3";
    `half`: they are half of all."""

    look: str
    count: int | None = None
    bare: bool = False
    label: bool = False
    base: tuple[int, ...] | None = None
    half: bool = False


@dataclass
class Said:
    """`free`: blocks without a place; `placed`: places and the blocks there; `listed`: colours of one line after
    another along `axis` from `start`; `each`: every line of that axis has one colour; `in_lines`: blocks in a line are
    told from left to right; `alternating`: two colours are told of the lines by turns; `based`: the lowest layer is
    told as the base."""

    free: list[Blocks] = field(default_factory=list)
    placed: list[tuple[list[Place], list[Blocks]]] = field(default_factory=list)
    listed: list[Blocks] = field(default_factory=list)
    axis: str | None = None
    start: str | None = None
    each: str | None = None
    in_lines: bool = False
    alternating: bool = False
    based: bool = False

    @property
    def all(self) -> list[Blocks]:
        """All blocks, with a place or without."""
        return [*self.free, *(item for _, items in self.placed for item in items)]


def by_turns(pieces: Sequence[Piece]) -> bool:
    """Whether colours are told to take turns, by themselves or of rows: "with alternating rows of red and white"."""
    return any(piece.kind == "alternating" or "alternating" in piece.words.split() for piece in pieces)


def blocks_of(piece: Piece) -> list[Blocks]:
    """The blocks that a piece names, in their order."""
    if piece.kind == "labels":
        return [Blocks(label, 1, bare=True, label=True) for label in piece.value]
    if piece.kind == "dims":
        return [Blocks("", prod(piece.value), base=piece.value)]
    named = piece.named
    look = f"{named.get('size') or named.get('behind', '')} {named.get('color', '')}".strip()
    count = number(named["count"]) if "count" in named else None
    if count is None and named.get("noun") in _SINGLE and "many" not in named and named.get("det") != "all":
        count = 1
    return [Blocks(look, count, bare=not {"count", "noun", "size", "half"} & set(named), half="half" in named)]


def _rest_of(piece: Piece) -> list[Place]:
    """ "The other two blue": a place of blocks that are named with it."""
    named = piece.named
    if piece.kind != "lot" or named.get("det") != "the other":
        return []
    single = "many" not in named and named.get("noun") in _SINGLE
    return [Place("rest", "", None, number(named["count"]) if "count" in named else int(single))]


def said(pieces: Sequence[Piece], *, dims_are_blocks: bool) -> Said:
    """What the pieces say, part by part between breaks.

    Raises:
        Unclear: blocks or places that belong to nothing beside them.
    """
    return _Reader(dims_are_blocks).read(pieces)


class _Reader:
    """Takes one part after another. `_waiting`: places whose blocks are not told yet; `_row`: the blocks of the place
    that was told last, where more of them may follow; `_listing`: colours that follow are those of line after line."""

    def __init__(self, dims_are_blocks: bool) -> None:
        self._kinds = {"lot", "some", "total", "labels", "place", "lines", "each", "direction"}
        self._kinds |= {"dims"} if dims_are_blocks else set()
        self._said = Said()
        self._waiting: list[Place] = []
        self._row: list[Blocks] | None = None
        self._listing = False
        self._last = ""
        self._bare = False

    def read(self, pieces: Sequence[Piece]) -> Said:
        part: list[Piece] = []
        cut = "."
        self._said.alternating = by_turns(pieces)
        for piece in [*pieces, Piece("break", ".")]:
            if piece.kind in self._kinds:
                part.append(piece)
            elif piece.kind == "figure":
                if part and part[-1].kind != "place":  # "the near row of the grid is black"
                    self._part(part, cut)
                    part, cut = [], ""
            elif piece.kind in ("break", "then", "except") and not (
                piece.words == ":" and part and part[-1].kind == "place"
            ):
                if part:
                    self._part(part, cut)
                if piece.words in _STRONG:
                    self._end()
                joined = cut in (",", *_STRONG) and not part and piece.words not in (",", *_STRONG)
                cut, part = piece.words if part or joined or piece.words in _STRONG else cut, []
        this = self._said
        kinds = {piece.kind for piece in pieces}
        if "free order" in kinds and not this.each:
            raise Unclear
        if this.start in ("right", "near", "front", "bottom") and not (this.listed or this.placed or this.free):
            raise Unclear  # "a pyramid. From front to back": nothing is listed that way
        if this.alternating and this.axis and not this.listed and len(this.free) == 2:
            this.listed = [item for item in this.free if item.bare and item.look]
            this.free = [item for item in this.free if item not in this.listed]
        if this.start and not this.listed and (this.axis or this.start in ("top", "bottom")):
            this.axis = this.axis or "layer"
            this.listed = [item for item in this.free if item.bare and item.look]
            this.free = [item for item in this.free if item not in this.listed]
        if this.each and ("free order" in kinds or (this.start is None and not all(item.bare for item in this.listed))):
            this.free += this.listed  # "two red and two blue blocks": which line has which colour is left open
            this.listed = []
        if (
            this.start in ("right", "near", "front", "bottom")
            and not (this.listed or this.placed)
            and len(this.free) > 1
        ):
            raise Unclear  # "a 3x3 grid of the numbers 1 to 9 from right to left"
        for piece in pieces:
            if piece.kind == "lot each":
                this.free = [replace(item, count=piece.value) for item in this.free if item.look]
        return this

    def _end(self) -> None:
        if self._waiting:
            raise Unclear
        self._row, self._listing, self._last = None, False, ""

    def _part(self, part: list[Piece], cut: str) -> None:
        items: list[Blocks | Place] = []
        kinds = [piece.kind for piece in part[:2]]
        if kinds in (["total", "lot"], ["total", "labels"], ["some", "labels"]):
            self._part(part[:1], cut)
            part, cut = part[1:], ""
        for piece in part:
            if piece.kind == "place":
                items.append(piece.value)
            elif piece.kind in ("lines", "each", "direction"):
                if piece.kind == "lines" and items and part[0].kind == "lot":
                    self._ahead(piece, part)
                    continue
                self._along(piece, bool(items) or self._listing or bool(self._said.listed))
            else:
                items += [*_rest_of(piece), *blocks_of(piece)]
        letters = "".join("P" if isinstance(item, Place) else "B" for item in items)
        blocks = [item for item in items if isinstance(item, Blocks)]
        joined, self._bare = self._bare and cut == "and", letters == "B" and blocks[0].bare and bool(blocks[0].look)
        places = [item for item in items if isinstance(item, Place)]
        if not letters:
            return
        if not places:
            self._blocks(blocks, cut)
        elif not blocks and len(places) == 1 and places[0].blocks:
            self._pairs(places, [[Blocks("", places[0].blocks)]])  # "top 1"
        elif not blocks:
            self._places(places, cut)
        elif letters == "PB" * len(places) or (letters.startswith("PB") and len(places) == 1):
            self._pairs(places, [blocks] if len(places) == 1 else [[one] for one in blocks])
            self._last, self._listing = "PB", False
        elif letters == "BP" * len(places) or (letters.endswith("BP") and all(one.label for one in blocks)):
            if self._waiting or (len(places) > 1 and len(blocks) != len(places)):
                raise Unclear
            if joined:
                raise Unclear  # "red and blue in front"
            self._pairs(places, [blocks] if len(places) == 1 else [[one] for one in blocks])
            self._last, self._row, self._listing = "BP", None, False
        else:
            raise Unclear

    def _ahead(self, piece: Piece, part: list[Piece]) -> None:
        """ "Red, white and blue layers": the colours of the lines are told ahead, and behind them where they begin.

        Raises:
            Unclear: "two red rows".
        """
        if self._said.axis not in (None, piece.value) or any("count" in p.named for p in part if p.kind == "lot"):
            raise Unclear
        self._said.axis = piece.value

    def _pairs(self, places: list[Place], blocks: list[list[Blocks]]) -> None:
        self._said.placed += [
            ([*(self._waiting if not n else []), place], [*those])
            for n, (place, those) in enumerate(zip(places, blocks, strict=True))
        ]
        self._row, self._waiting = self._said.placed[-1][1], []

    def _blocks(self, blocks: list[Blocks], cut: str) -> None:
        if len(blocks) > 1 and not all(one.label for one in blocks) and self._row is None and not self._listing:
            raise Unclear
        if self._waiting:
            if cut != ",":
                raise Unclear
            self._said.placed.append((self._waiting, [*blocks]))
            self._waiting, self._row, self._last = [], None, "PB"
        elif cut == "then" and self._row is not None and (self._row[-1].count or blocks[-1].count):
            self._said.placed.append(([Place("line", "next")], [*blocks]))
            self._row = self._said.placed[-1][1]
        elif self._row is not None and all(one.look for one in blocks):
            self._row += blocks
        elif self._listing:
            self._said.listed += blocks
        elif cut == "then":
            self._said.placed.append(([Place("line", "next")], [*blocks]))
        else:
            self._said.free += blocks

    def _places(self, places: list[Place], cut: str) -> None:
        if len(places) > 1:
            raise Unclear
        if self._last == "BP" and cut == "and":
            self._said.placed[-1][0].extend(places)
        else:
            self._waiting += places
            self._row, self._listing = None, False

    def _along(self, piece: Piece, behind: bool) -> None:
        """A word for all lines of an axis, or for their order; `behind`: the colours were told ahead of it."""
        this = self._said
        if piece.kind == "direction":
            if piece.value == ("column", "left") and this.placed and not self._listing:
                this.in_lines, self._last = True, ""
                return
            if this.start not in (None, piece.value[1]):
                raise Unclear
            this.start = piece.value[1]
            self._listing = self._listing or not behind
            self._row = None if self._listing else self._row
            return
        if this.axis not in (None, piece.value):
            raise Unclear
        this.axis = piece.value
        this.each = piece.value if piece.kind == "each" else this.each
        self._listing, self._row = True, None
