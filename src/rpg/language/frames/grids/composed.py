"""A filled rectangle told by what it is put together of: "a frame of twelve brown cubes around a 2x2 block of green
ones"; and a pyramid told by squares on top of each other."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from math import prod

from rpg.language.frames.grids.words import Place
from rpg.language.frames.lots import lot_of
from rpg.language.frames.pieces import Pattern, Piece, Unclear, patterns

_SIZED = r"(?= (?:an?|the) (?:\d+x\d+|\d+ (?:by|x) \d+) )"
_ALL_SIDES = "(?: on all (?:its )?(?:4 )?sides| all (?:a?round|the way a?round))?"
FRAMING: list[Pattern] = [
    *patterns("framing", "last",
        "(?:that |which )?(?:all (?:the way )?)?(?:a?round|surround(?:s|ing)?|enclos(?:es|ing)|encircl(?:es|ing))"
        f"{_SIZED}"),
    *patterns("framing", "first",
        f"(?:that |which )?(?:BE )?(?:surrounded|framed|bordered|enclosed|encircled|ringed){_ALL_SIDES} (?:by|with)"),
    *patterns("glue", None, r"(?<=x\d )(?:layers?|levels?|tiers?|slabs?|sheets?)"),
]  # fmt: skip
"""Kind "framing": whether what is framed is told last, or first."""
_ON_IT = frozenset({"above", "above it", "top", "next"})
_PARTS = frozenset({"glue", "break", "figure", "dims", "base", "lot", "place", "then", "filled", "flat"})


def composed(pieces: Sequence[Piece]) -> list[Piece]:
    """The pieces with the one figure that they are put together to, where they are.

    Raises:
        Unclear: the numbers are not those of such a figure.
    """
    return _terraced(_framed(pieces))


def _framed(pieces: Sequence[Piece]) -> list[Piece]:
    """What is around a rectangle of blocks, as the border of a larger one."""
    at = next((n for n, piece in enumerate(pieces) if piece.kind == "framing"), None)
    if at is None:
        return list(pieces)
    before, behind = pieces[:at], pieces[at + 1 :]
    verb = pieces[at].words == "surround" and all(
        piece.kind != "lot" for piece in before
    )  # "surround a 2x2 square of green cubes with twelve brown ones"
    parted = next((n for n, piece in enumerate(behind) if piece.words in ("with", "by")), len(behind)) if verb else 0
    inner, outer = (before, behind) if pieces[at].value == "first" else (behind, before)
    inner, outer = (behind[:parted], behind[parted:]) if verb else (inner, outer)
    where = [piece for piece in pieces if piece.kind == "where"]
    dims = [piece for piece in inner if piece.kind == "dims"]
    lots = [[piece for piece in side if piece.kind == "lot"] for side in (outer, inner)]
    if [len(dims), *map(len, lots)] != [1, 1, 1] or any(piece.kind == "dims" for piece in outer):
        return [_unframed(piece) for piece in pieces]
    others = [piece for piece in pieces if piece.kind not in _PARTS | {"framing", "where"}]
    border = [piece for piece in pieces if piece.kind == "place"]
    if others or len(dims[0].value) != 2 or any(piece.value != Place("cells", "border") for piece in border):
        raise Unclear
    (around,), (inside,) = lots
    high, wide = dims[0].value
    if lot_of(inside).count not in (None, 1, high * wide):
        raise Unclear
    comma = Piece("break", ",")
    told = [Piece("dims", dims[0].words, (high + 2, wide + 2)), Piece("figure", "grid", "grid"), comma]
    told += [Piece("place", "", Place("cells", "border")), around, comma]
    return [*told, Piece("place", "", Place("cells", "inside")), inside, *(p for one in where for p in (comma, one))]


def _unframed(piece: Piece) -> Piece:
    """What is said of a frame, where it is none around a rectangle."""
    if piece.kind != "framing":
        return piece
    return Piece("glue", piece.words) if piece.value == "first" else Piece("place", "", Place("cells", "border"))


def _terraced(pieces: Sequence[Piece]) -> list[Piece]:
    """Squares on top of each other, each smaller by one, as a pyramid with layers of these colours."""
    squares = [piece for piece in pieces if piece.kind in ("dims", "base")]
    layers = [piece.value for piece in pieces if piece.kind == "size"]
    if len(squares) < 2 or any(p.kind not in _PARTS | {"where", "size"} for p in pieces):
        return list(pieces)
    levels: list[list[Piece]] = [[]]
    for piece in pieces:
        if piece.kind in ("break", "then"):
            levels += [[]] if {p.kind for p in levels[-1]} & {"lot", "dims"} else []
        elif piece.kind in ("dims", "base", "lot", "place"):
            levels[-1].append(replace(piece, kind="dims") if piece.kind == "base" else piece)
    levels = [level for level in levels if level]
    told = [{piece.kind: piece for piece in level} for level in levels]
    if any(len(parts) != len(level) or "lot" not in parts for parts, level in zip(told, levels, strict=True)):
        return list(pieces)
    sizes = [parts["dims"].value if "dims" in parts else (1, 1) for parts in told]
    if sizes != [(n, n) for n in range(len(told), 0, -1)] or layers not in ([], [{"layers": len(told)}]):
        return list(pieces)
    sides = [parts["place"].value.side if "place" in parts else "" for parts in told]
    for n, (parts, size, side) in enumerate(zip(told, sizes, sides, strict=True), 1):
        if side not in (str(n), *(("", "bottom") if n == 1 else _ON_IT)):
            return list(pieces)
        if lot_of(parts["lot"]).count not in ({1} if size == (1, 1) else {None, prod(size)}):
            raise Unclear
    base = Piece("base", told[0]["dims"].words, sizes[0])
    bare = [Piece("lot", lot_of(parts["lot"]).look, None, {"color": lot_of(parts["lot"]).look}) for parts in told]
    listed = [piece for lot in bare for piece in (lot, Piece("break", ","))]
    order = [Piece("lines", "", "layer"), Piece("direction", "", ("layer", "bottom"))]
    where = [piece for piece in pieces if piece.kind == "where"]
    return [Piece("figure", "pyramid", "pyramid"), base, Piece("break", ","), *order, *listed[:-1], *where]
