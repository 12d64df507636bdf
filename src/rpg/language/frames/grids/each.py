"""What is said of each line or each colour of a grid, wall, pyramid or cube, and lists of numbers, made plain."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from rpg.language.frames.pieces import Piece, Unclear, number

_OF = {"row": "columns", "column": "rows", "layer": "layer"}
"""By an axis: how many blocks each of its lines has."""


def plain(pieces: Sequence[Piece], kind: str) -> list[Piece]:
    """The pieces, with "each" told of a line or of a colour, and numbers in a list told as symbols, or as "counts" of
    the layers of a pyramid.

    Raises:
        Unclear: it is not clear of what each is told.
    """
    found: list[Piece] = []
    every = [piece for piece in pieces if piece.kind == "every"]
    if [piece.kind for piece in pieces].count("one color") != len(every) or len(every) > 1:
        raise Unclear
    for piece in _with_base(pieces) if kind == "pyramid" else _any_lines(pieces):
        if found and found[-1].kind == "some" and " of " in found[-1].words and piece.kind == "lot":
            named = {**piece.named, "count": found.pop().named["count"]}  # "five of them black"
            found.append(replace(piece, named=named))
        elif found and found[-1].kind == "total" and piece.kind == "lot" and not {"count", "det"} & piece.named.keys():
            named = {**piece.named, "count": found.pop().named["count"]}  # "three cubes green"
            found.append(replace(piece, named=named))
        elif piece.kind == "lot" and len(found) > 1 and found[-1].words in ("(", ":") and _axes(found[-2]):
            found += [Piece("lines", found[-1].words, _axes(found[-2])), piece]  # "three columns: red, white, blue"
        elif piece.kind == "one color":
            found.append(replace(every[0], kind="each"))
        elif piece.kind == "digits" and kind == "pyramid":
            found.append(replace(piece, kind="counts", value=[*_lowest(found), *piece.value]))
        elif piece.kind == "digits":
            found.append(replace(piece, kind="labels"))
        elif found and found[-1].kind == "counts" and piece.kind == "place" and piece.value.side == "top":
            continue  # "and one on top"
        elif piece.kind == "each" and piece.value is None:
            found.append(replace(piece, value=_axis(found)))
        elif piece.kind == "apiece":
            _apiece(found, pieces)
        else:
            found.append(piece)
    return found


def _lowest(told: Sequence[Piece]) -> list[str]:
    """The number of blocks in the base, where it is told ahead of those of the other layers."""
    sizes = [piece.value for piece in told if piece.kind == "size"]
    return [str(size) for value in sizes for name, size in value.items() if name in ("base", "line")]


def _with_base(pieces: Sequence[Piece]) -> Sequence[Piece]:
    """A pyramid "with a base of three red blocks", of which no other blocks are told, is red."""
    at = [n for n, piece in enumerate(pieces) if piece.kind == "lot"]
    places = [n for n, piece in enumerate(pieces) if piece.kind == "place"]
    if len(at) != 1 or len(places) != 1 or places[0] != at[0] - 1 or " of" not in pieces[places[0]].words:
        return pieces
    lot = pieces[at[0]]
    if "count" not in lot.named:
        return pieces
    named = {name: said for name, said in lot.named.items() if name != "count"}
    size = Piece("size", lot.words, {"base": number(lot.named["count"])})
    return [*pieces[: places[0]], size, replace(lot, named={**named, "noun": "blocks"}), *pieces[at[0] + 1 :]]


def _any_lines(pieces: Sequence[Piece]) -> Sequence[Piece]:
    """ "One row red, the other blue": each row has a colour, and it is left open which."""
    lines = [piece for piece in pieces if piece.kind == "any line"]
    if not lines:
        return pieces
    found = []
    for piece in pieces:
        if piece.kind == "place" and piece.value.side == "other" and piece.value.many == 1:
            continue
        if piece.kind == "place" or piece.kind in ("each", "lines", "direction"):
            raise Unclear
        if piece.kind == "any line":
            found += [replace(piece, kind="each")] if piece is lines[0] else []
        elif piece.kind == "lot":
            named = {name: said for name, said in piece.named.items() if name != "det"}
            found.append(replace(piece, named={**named, "noun": "blocks"}))
        else:
            found.append(piece)
    return found


def _axis(told: Sequence[Piece]) -> str:
    """The axis that was spoken of last.

    Raises:
        Unclear: none was.
    """
    for piece in reversed(told):
        if piece.kind in ("lines", "each") and piece.value:
            return str(piece.value)
        if piece.kind == "place" and piece.value.axis:
            return str(piece.value.axis)
        if axis := _axes(piece):
            return axis
    raise Unclear


def _axes(piece: Piece) -> str:
    """The axis whose lines a piece counts; empty for any other piece."""
    return next((axis for axis in _OF if piece.kind == "size" and f"{axis}s" in piece.value), "")


def _apiece(found: list[Piece], pieces: Sequence[Piece]) -> None:
    """Takes "each" to the number ahead of it: how many are in each line, or of each colour."""
    last = next((n for n in range(len(found) - 1, -1, -1) if found[n].kind != "glue"), None)
    if last is None:
        raise Unclear
    piece, lots = found[last], [p for p in pieces if p.kind == "lot"]
    ahead = [p for p in found[:last] if p.kind not in ("glue", "break")]
    if piece.kind == "size" and len(piece.value) > 1:
        return
    if piece.kind == "lot" and ahead and ahead[-1].kind == "size" and len(ahead[-1].value) > 1:
        return
    count = number(piece.named["count"]) if "count" in piece.named else 0
    lines = any(p.kind == "place" and p.value.kind == "line" for p in pieces)
    if (
        piece.kind in ("some", "total")
        and len(lots) > 1
        and not lines
        and not any("count" in lot.named for lot in lots)
    ):
        found[last] = replace(piece, kind="lot each", value=count)
    elif count and (piece.kind in ("some", "total") or (piece.kind == "lot" and len(lots) == 1)):
        named = {name: said for name, said in piece.named.items() if name != "count"}
        found[last:] = [Piece("size", piece.words, {_OF[_axis(found[:last])]: count})]
        found += [replace(piece, named={**named, "noun": "blocks"})] if piece.kind == "lot" else []
    else:
        raise Unclear
