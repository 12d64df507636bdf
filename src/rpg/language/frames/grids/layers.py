"""The layers of a pyramid told by their numbers of blocks, from the base to the one block on top, as its size."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from itertools import groupby
from math import isqrt, prod

from rpg.language.frames.pieces import Piece, Unclear, number

_JOINTS = frozenset({"break", "then", "glue", "place"})
_LAYERS = frozenset({"top", "bottom", "middle", "above", "above it", "next", "1", "2", "3", "4", "5", "last"})
"""Sides at which a layer may be."""
_LOW, _HIGH = frozenset({"bottom", "1"}), frozenset({"top", "last", "above", "above it", "next"})


@dataclass
class _Run:
    """Numbers one after the other, and the pieces that tell them. `sides`: where each of them is, as far as told;
    `first`: the place told ahead of the next number; `square`: some are told as "2 by 2"."""

    begin: int
    counts: list[int] = field(default_factory=list)
    sides: list[set[str]] = field(default_factory=list)
    end: int = 0
    square: bool = False


def layered(pieces: Sequence[Piece]) -> list[Piece]:
    """The pieces with one size for numbers that tell all layers; "four as a 2x2" is told once."""
    pieces = _told_once(pieces)
    for begin in range(len(pieces)):
        run = _run(pieces, begin)
        if run is not None:
            told = " ".join(piece.words for piece in pieces[begin : run.end])
            return [*pieces[:begin], _size(run, told), *pieces[run.end :]]
    return pieces


def _told_once(pieces: Sequence[Piece]) -> list[Piece]:
    """Without the "2x2" of "four red ones in a 2x2 at the bottom", which is the base then."""
    found: list[Piece] = []
    for piece in pieces:
        last = next((p for p in reversed(found) if p.kind not in ("glue", "place", "break")), None)
        count = number(last.named["count"]) if last is not None and "count" in last.named else 0
        based = any(p.kind in ("base", "size") for p in pieces)
        if piece.kind == "dims" and count > 1 and count == prod(piece.value) and not based and len(piece.value) == 2:
            found.append(Piece("base", piece.words, piece.value))
        else:
            found.append(piece)
    return found


def _counts(piece: Piece) -> list[int]:
    """The numbers of blocks that a piece tells of layers."""
    if piece.kind in ("some", "total") and not {"total", "all", "altogether", "overall"} & set(piece.words.split()):
        return [number(piece.named["count"])]
    if piece.kind == "digits":
        return [number(said) for said in piece.value]
    if piece.kind in ("dims", "base") and len(piece.value) == 2:
        return [prod(piece.value)]
    if piece.kind == "size" and len(piece.value) == 1 and {"base", "line"} & piece.value.keys():
        return list(piece.value.values())
    return []


def _run(pieces: Sequence[Piece], begin: int) -> _Run | None:
    """The numbers from a place on, where they are those of all layers."""
    run = _Run(begin)
    ahead: set[str] = set()
    parted = True
    if not _counts(pieces[begin]) and pieces[begin].kind != "place":
        return None
    for n, piece in enumerate(pieces[begin:], begin):
        counts = _counts(piece)
        if counts:
            again = run.counts[-1:] == counts and piece.kind in ("dims", "base") and not parted
            if not again:
                run.counts += counts
                run.sides += [ahead if not k else set() for k in range(len(counts))]
            run.square = run.square or piece.kind in ("dims", "base")
            ahead, parted, run.end = set(), False, n + 1
        elif piece.kind == "place":
            side = piece.value.side
            if piece.value.kind != "line" or side not in _LAYERS or piece.value.blocks:
                break
            behind = n + 1 < len(pieces) and bool(_counts(pieces[n + 1]))
            bare = behind and piece.words.split()[0] not in ("in", "on", "at", "along", "as", "for", "over", "above")
            if parted or not run.counts or run.sides[-1] or bare:
                ahead = {side}
            else:
                run.sides[-1] = {side}
                run.end = n + 1
        elif piece.kind not in _JOINTS:
            break
        elif piece.kind != "glue":
            parted = True
    return run if _falls(run) else None


def _falls(run: _Run) -> bool:
    """Whether these are all layers of a pyramid, from below or from above."""
    counts, sides = run.counts, run.sides
    if len(counts) < 2 or min(counts[0], counts[-1]) != 1:
        return False
    if counts[0] == 1:
        counts, sides = counts[::-1], sides[::-1]
    lines, squares = [*range(len(counts), 0, -1)], [n * n for n in range(len(counts), 0, -1)]
    if counts != squares and (counts != lines or run.square):
        return False
    numbered = [(n, int(side)) for n, said in enumerate(sides, 1) for side in said if side.isdigit()]
    if any(n != side for n, side in numbered) and any(n != len(sides) + 1 - side for n, side in numbered):
        return False
    return (
        not (sides[0] & _HIGH - {"last"})
        and not (sides[-1] & _LOW - {"1"})
        and not any(s & {"top"} for s in sides[:-1])
    )


def _size(run: _Run, words: str) -> Piece:
    """The size of the lowest layer."""
    low = max(run.counts)
    if low == len(run.counts):
        return Piece("size", words, {"line": low})
    return Piece("base", words, (isqrt(low), isqrt(low)))


def in_order(pieces: Sequence[Piece], upright: str) -> list[Piece]:
    """The pieces with colours that are listed one after the other told as such: "red "
    "black" of a checkerboard, "starting
    with red", and "red at the bottom, then white, and blue on top" of a figure that is `upright`.

    Raises:
        Unclear: none of two colours is the one it starts with.
    """
    checkered = any(piece.kind in ("checkered", "alternating") or piece.value == "board" for piece in pieces)
    found: list[Piece] = []
    for piece in pieces:
        if checkered and _bare(piece) and found and _bare(found[-1]):
            found.append(Piece("break", "and"))
        found.append(piece)
    found = _begun(found)
    return _listed(found) if upright else found


def merged(pieces: Sequence[Piece]) -> list[Piece]:
    """The pieces with "red red red" told as three red ones."""
    found: list[Piece] = []
    for _, run in groupby(pieces, lambda piece: _bare(piece)):
        same = list(run)
        alike = {piece.named.get("color") for piece in same}
        if len(same) > 1 and len(alike) == 1 and _bare(same[0]) and not any("det" in piece.named for piece in same):
            words = " ".join(piece.words for piece in same)
            found.append(replace(same[0], words=words, named={**same[0].named, "count": str(len(same))}))
        else:
            found += same
    return found


def _bare(piece: Piece) -> bool:
    """Whether it is a colour alone."""
    return piece.kind == "lot" and not {"count", "noun", "size", "behind", "half"} & piece.named.keys()


_AXIS = {"bottom": "layer", "top": "layer", "left": "column", "right": "column", "front": "row", "back": "row"}
_END = {"front": "near", "back": "far"}


def _begun(pieces: list[Piece]) -> list[Piece]:
    """Two colours by turns in the order in which they come."""
    begins = [piece for piece in pieces if piece.kind == "begins"]
    if not begins:
        return pieces
    color, side = begins[0].value
    lots = [n for n, piece in enumerate(pieces) if _bare(piece)]
    lines = any(piece.kind in ("lines", "each") for piece in pieces)
    if len(begins) > 1 or len(lots) != 2 or not lines or color not in [pieces[n].named["color"] for n in lots]:
        raise Unclear
    found = [piece for piece in pieces if piece.kind != "begins"]
    first, second = (n for n, piece in enumerate(found) if _bare(piece))
    if found[first].named["color"] != color:
        found[first], found[second] = found[second], found[first]
    if side:
        found.append(Piece("direction", side, (_AXIS[side], _END.get(side, side))))
    return found


def _listed(pieces: list[Piece]) -> list[Piece]:
    """Colours of all layers from the lowest to the highest, or the other way."""
    lots = [n for n, piece in enumerate(pieces) if piece.kind == "lot"]
    if len(lots) < 3 or not all(_bare(pieces[n]) for n in lots):
        return pieces
    begin, end = lots[0] - 1, lots[-1] + 1
    if begin < 0 or pieces[begin].kind != "place":
        begin += 1
    between = pieces[begin:]
    sides = [piece.value.side for piece in between if piece.kind == "place" and piece.value.kind == "line"]
    places = [piece for piece in pieces if piece.kind == "place"]
    if len(sides) < 2 or len(places) != len(sides):
        return pieces
    first, last, others = sides[0], sides[-1], sides[1:-1]
    ends = [n for n, piece in enumerate(pieces) if piece.kind == "place"]
    apart = max(ends[0], lots[0]) < lots[1] and min(ends[-1], lots[-1]) > lots[-2]
    if {first, last} != {"bottom", "top"} or not {*others} <= {"next", "above", "middle"} or not apart:
        return pieces
    if len(others) == len(lots) - 2:
        return pieces  # each has its place
    end = max(end, ends[-1] + 1)
    told = [piece for piece in pieces[begin:end] if piece.kind != "place"]
    direction = Piece("direction", "", ("layer", first))
    return [*pieces[:begin], Piece("lines", "", "layer"), *told, direction, *pieces[end:]]
