"""Pieces of a row said in plainer pieces: several places with one lot, and "first ... then ... last" as a list."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import replace
from itertools import pairwise

from rpg.language.frames.lines.places import STOPS
from rpg.language.frames.pieces import Pattern, Piece, Unclear, patterns

_ORDINALS = ("first", "second", "third", "fourth", "fifth", "sixth", "seventh", "eighth", "ninth", "tenth")
_NTH = f"(?:{'|'.join(_ORDINALS)}|last)"
_AND = "(?: ,| and| ,? and| &)"
_NOUN = "(?:blocks?|cubes?|ones?|places?|positions?|spots?|slots?)"
PLACES: list[Pattern] = [
    *patterns("places", None,
        rf"(?:BE )?(?:in |at |as )?(?:the |its )?(?P<nths>{_NTH}(?: {_NOUN})?(?:{_AND}(?: the)? {_NTH}(?: "
        rf"{_NOUN})?)+)"
        rf"(?: in the (?:row|line))?(?: from (?:the )?(?P<side>left|right))?(?: BE)?(?= )",
        rf"(?:BE )?(?:in |at |as )?(?:the )?(?:blocks|cubes|places|positions|spots|slots|numbers) (?P<numbers>\d"
        rf"(?:{_AND} \d)+)(?: from (?:the )?(?P<side>left|right))?(?: BE)?"),
]  # fmt: skip
"""Kind "places": several of them, which the same blocks have."""
BEFORE: list[Pattern] = [
    *patterns("before", "from left to right",
        r"(?:BE )?(?:placed )?(?:(?:to|on) the )?left(?: side)? of(?= (?:all |any |every |each |both )*(?:of "
        r")?(?:the )?(?:NUM )?"
        r"(?:SIZE )?COLOR(?:s)?(?: (?:ones?|BLOCK))? (?:[,.;]|in|$))"),
    *patterns("before", "from right to left",
        r"(?:BE )?(?:placed )?(?:(?:to|on) the )?right(?: side)? of(?= (?:all |any |every |each |both )*(?:of "
        r")?(?:the )?(?:NUM )?"
        r"(?:SIZE )?COLOR(?:s)?(?: (?:ones?|BLOCK))? (?:[,.;]|in|$))"),
]  # fmt: skip
"""Kind "before": the blocks ahead of it are to one side of those behind it; the direction in which they are listed."""
_OF_IT = re.compile(r"(?:left|right)(?: hand)?(?: side)? of|its (?:left|right)")
_BESIDE_IT = re.compile(r"neighbors|(?:next to|beside) it")
_FIRST = re.compile(r"(?:(?:to )?(?:start|begin|open)\w*(?: off)?(?: with)?|first)$")
_LAST = re.compile(r"(?:(?:to )?(?:end|finish|clos)\w*(?: up| off)?(?: with| in| by)?|last)$")


def check_about_middle(pieces: Sequence[Piece], size: int, told: int) -> None:
    """Blocks to the left and right "of it" are beside the block in the middle, and with it all that there are; "its
    neighbors" are those of the block in the middle.

    Raises:
        Unclear: they are not.
    """
    about = any(piece.kind == "place" and _OF_IT.search(piece.words) for piece in pieces)
    if about and (size != told or all(piece.value != ("middle", 0) for piece in pieces)):
        raise Unclear
    places = [piece for piece in pieces if piece.kind == "place"]
    for before, piece in pairwise([Piece("place", ""), *places]):
        if _BESIDE_IT.search(piece.words) and before.value != ("middle", 0):
            raise Unclear


def repeated(pieces: Sequence[Piece], order: list[str] | None, size: int | None) -> list[str] | None:
    """The order of the looks, with a listed pattern as often as it takes for so many blocks.

    Raises:
        Unclear: it is repeated, but it is not told how many blocks there are, or it takes a part of the pattern.
    """
    told = any(piece.kind == "repeated" for piece in pieces)
    if not told and not any(piece.kind == "listed" and "pattern" in piece.words.split() for piece in pieces):
        return order
    numbered = any(piece.kind == "place" or (piece.kind == "lot" and "count" in piece.named) for piece in pieces)
    if not order or not size or size % len(order) or numbered:
        if told:
            raise Unclear
        return order
    return order * (size // len(order))


def of_line(pieces: Sequence[Piece]) -> list[Piece]:
    """The pieces with the line spoken of behind a place, "the leftmost block of the row", where it is told how many
    blocks it has: there may be more than those that have a place."""
    found: list[Piece] = []
    counted = any(piece.kind == "total" or (piece.kind == "rest" and piece.named) for piece in pieces)
    for piece in pieces:
        of = _OF_LINE.search(piece.words) if counted and piece.kind == "place" else None
        found += [piece, *([Piece("mention", of[0], of[1])] if of else [])]
    return found


_OF_LINE = re.compile(r"\bof the (?:whole |entire )?(row|line|column)(?: \w+){0,2}$")


def singly(pieces: Sequence[Piece]) -> list[Piece]:
    """The pieces with each of several places told with blocks of its own.

    Raises:
        Unclear: places without blocks, or with more of them than there are places.
    """
    found: list[Piece] = []
    kept = list(pieces)
    while kept:
        piece = kept.pop(0)
        if piece.kind != "places":
            found.append(piece)
            continue
        while kept and kept[0].kind == "glue":
            kept.pop(0)
        ahead = found and found[-1].kind == "lot"
        if ahead:
            lot = found.pop()
        elif kept and kept[0].kind == "lot":
            lot = kept.pop(0)
        else:
            raise Unclear
        places = _named(piece)
        if lot.named.get("count", str(len(places))) != str(len(places)) or "label" in lot.named:
            raise Unclear
        named = {key: said for key, said in lot.named.items() if key in ("color", "size", "behind")}
        for n, place in enumerate(places):
            found += [Piece("break", ",")] * (n > 0)
            found += [replace(lot, named={**named, "det": "a"}), Piece("place", piece.words, place)]
    return found


def _named(piece: Piece) -> list[tuple[str, int]]:
    """The places that are told.

    Raises:
        Unclear: the same twice.
    """
    side = piece.named.get("side", "first")
    if "numbers" in piece.named:
        found = [(side, int(said)) for said in re.findall(r"\d", piece.named["numbers"])]
    else:
        said = re.findall(rf"\b{_NTH}\b", piece.named["nths"])
        found = [("last", 1) if word == "last" else (side, _ORDINALS.index(word) + 1) for word in said]
    if len(set(found)) < len(found):
        raise Unclear
    return found


def beforehand(pieces: Sequence[Piece]) -> list[Piece]:
    """The pieces with "all red ones left of all blue ones" as a list in a direction, at the end.

    Raises:
        Unclear: these are not all blocks, or their numbers are not told besides.
    """
    found = list(pieces)
    at = [n for n, piece in enumerate(found) if piece.kind == "before"]
    if not at:
        return found
    told = [piece for piece in found if piece.kind == "lot"]
    if len(at) > 1 or len({(piece.named.get("size"), piece.named["color"]) for piece in told}) != 2:
        raise Unclear
    if [piece.kind for piece in found[at[0] - 1 : at[0] + 2]] != ["lot", "before", "lot"]:
        raise Unclear
    ahead, behind = found[at[0] - 1], found[at[0] + 1]
    rest = [piece for n, piece in enumerate(found) if abs(n - at[0]) > 1]
    if not any(piece.kind == "lot" for piece in rest):
        raise Unclear
    return [*rest, Piece("break", "."), Piece("listed", "before"), Piece("direction", "before", found[at[0]].value),
            ahead, Piece("break", ","), behind]  # fmt: skip


def listed(pieces: Sequence[Piece]) -> list[Piece]:
    """The pieces with "first red, then blue, last green" as a list in that order."""
    found = list(pieces)
    begin = 0
    for n, piece in enumerate([*found, Piece("break", ".")]):
        if piece.kind == "break" and piece.words in STOPS:
            found[begin:n] = _one_list(found[begin:n])
            begin = n + 1
    return found


def _one_list(sentence: Sequence[Piece]) -> list[Piece]:
    said = [piece for piece in sentence if piece.kind not in ("glue", "break")]
    kinds = [piece.kind for piece in said]
    places = [n for n, piece in enumerate(said) if piece.kind == "place"]
    now = [n for n, piece in enumerate(said) if piece.value == "now"]
    first = [n for n in places if said[n].value == ("first", 1) and _FIRST.match(said[n].words)]
    last = [n for n in places if said[n].value == ("last", 1) and _LAST.match(said[n].words)]
    if (
        len(first) != 1
        or not now
        or now[0] < first[0]
        or len(places) != len(first) + len(last)
        or "act" in kinds[first[0] :]
    ):
        return list(sentence)
    ends = max(n for n, kind in enumerate(kinds) if kind == "lot")
    if len(last) > 1 or (last and abs(last[0] - ends) != 1) or any(kinds[n + 1 : n + 2] != ["lot"] for n in now):
        return list(sentence)
    if "lot" not in kinds[max(0, first[0] - 1) : first[0] + 2]:
        return list(sentence)
    gone = {id(said[n]) for n in [*first, *last]}
    begins = said[first[0] - 1 if kinds[first[0] - 1 : first[0]] == ["lot"] else first[0] + 1]
    plainer: list[Piece] = []
    for piece in sentence:
        plainer += [Piece("listed", "first")] * (piece is begins)
        plainer += [piece] * (id(piece) not in gone)
    return plainer
