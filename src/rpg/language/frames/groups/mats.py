"""Blocks on patches: those of each patch told by themselves, or each on the patch of its colour."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import replace
from itertools import pairwise

from rpg.language.frames.groups.mat_words import PATTERNS
from rpg.language.frames.groups.shared import Gathered, belongs, check_clauses, gathered, listed, said_of, settled
from rpg.language.frames.groups.shared_words import START
from rpg.language.frames.lots import Lot, counted, lot_of, one
from rpg.language.frames.pieces import Piece, Unclear

__all__ = ["PATTERNS", "told"]

_EVERY = re.compile("each|every|all")
_SOME = re.compile(r"\b(?:only|just|exactly|(?:one|\d+) of)\b")
"""So it is told of blocks beside which there are others."""


def told(pieces: Sequence[Piece]) -> str:
    """Which blocks lie on which patches, in plain sentences.

    Raises:
        Unclear: blocks of which it is not told where they belong, or how many there are.
    """
    check_clauses(pieces)
    if pieces[0].words in ("is", "are", "there are", "there is"):
        ends = [n for n, piece in enumerate(pieces) if piece.words in (".", "!", ":", ";")]
        if pieces[0].words in ("is", "are") or not ends:
            raise Unclear
    if any(piece.kind in ("lot", "glyphs", "class") and _SOME.search(piece.words) for piece in pieces):
        raise Unclear
    if any(det.words in ("a", "an") and of.kind == "class" for det, of in pairwise(pieces)):
        raise Unclear  # "a vowel" is one of them
    if any(piece.words == "line up" for piece in pieces):
        raise Unclear  # a row, and not only on a patch
    pieces = _named(_matched(pieces))
    kinds = [piece.kind for piece in pieces]
    found, total = gathered(pieces), one(pieces, "total")
    each = {piece.value for piece in pieces if piece.kind == "each"}
    lots = [lot for here in (found.lots, *(here for _, here in found.places)) for lot in here.values()]
    if each and any({lot.count} != each for lot in lots):
        raise Unclear  # "from two red and two blue ones, one of each colour": so many of those
    plain = not {"basis", "class", "each", "total", "everything"} & set(kinds)
    plain = plain and all(len(piece.value) == 1 for piece in pieces if piece.kind == "glyphs")
    if "matched" in kinds or (plain and not found.lots):
        raise Unclear  # which block is where, told of each by itself, is a matter of relations
    patches = {piece.value for piece in pieces if piece.kind == "patch"}
    if "slot" in kinds and "basis" not in kinds:
        places = _places(found, total.value if total else None)
        if found.lots and any(piece.kind == "everything" and _EVERY.match(piece.words) for piece in pieces):
            raise Unclear
    elif "basis" in kinds and "slot" not in kinds:
        places = _by_color(found, total.value if total else None)
    else:
        raise Unclear
    told_patches = {slot for slot, _ in places}
    count = one(pieces, "patches")
    if (patches and patches != told_patches) or (count and count.value not in (None, len(told_patches))):
        raise Unclear
    text = " ".join(f"Put {_said_of(lots)} on the {slot}." for slot, lots in places)
    return text + (f" {START}" if "start" in kinds else "")


def _matched(pieces: Sequence[Piece]) -> list[Piece]:
    """ "By colour" is told of patches where they are named."""
    named = any(piece.kind in ("patch", "basis") for piece in pieces)
    return [
        replace(piece, kind="basis", value="color") if piece.kind == "matched" and named else piece for piece in pieces
    ]


def _named(pieces: Sequence[Piece]) -> list[Piece]:
    """ "The others on the blue" is told of a patch where another is named as one.

    Raises:
        Unclear: none is: "red on blue".
    """
    told_of = {piece.value.split()[-2] for piece in pieces if piece.kind in ("slot", "patch")}
    for piece in pieces:
        one_of_them = piece.words.endswith(" one") and told_of
        if piece.kind == "bare slot" and piece.value.split()[0] not in told_of and not one_of_them:
            raise Unclear
    looks = {lot_of(piece).look for piece in pieces if piece.kind == "lot"}
    for n, piece in enumerate(pieces):
        color = piece.value.split()[0] if piece.kind == "bare slot" else ""
        if color in looks and not (n and pieces[n - 1].kind == "lot" and lot_of(pieces[n - 1]).look == color):
            raise Unclear  # "the red ones on the blue", where there are blue blocks
    return [replace(piece, kind="slot") if piece.kind == "bare slot" else piece for piece in pieces]


def _places(found: Gathered, total: int | None) -> list[tuple[str, list[Lot]]]:
    """Each patch with its blocks.

    Raises:
        Unclear: a patch is told twice, or a number of blocks is open.
    """
    for name in [look for look in found.lots if look[:1] == "<"]:
        del found.lots[name]  # "these digits: 1, 2, 3"
    places = settled(found, belongs)
    lots = [lot for _, here in places for lot in here]
    if any(lot.count is None for lot in lots) or len({slot for slot, _ in places}) < len(places):
        raise Unclear
    if total not in (None, sum(lot.count or 0 for lot in lots)):
        raise Unclear
    return places


def _by_color(found: Gathered, total: int | None) -> list[tuple[str, list[Lot]]]:
    """Each lot on the patch of its colour.

    Raises:
        Unclear: a number of blocks is open, or blocks have no colour.
    """
    lots = counted(list(found.lots.values()), total, evenly=True)
    if not lots or found.places or any(lot.count is None or len(lot.look) == 1 or lot.look[:1] == "<" for lot in lots):
        raise Unclear
    colors = dict.fromkeys(lot.look.split()[-1] for lot in lots)
    return [(f"{color} patch", [lot for lot in lots if lot.look.split()[-1] == color]) for color in colors]


def _said_of(lots: Sequence[Lot]) -> str:
    """The blocks of a patch; of a lot in colours, all that there are of it lie there."""
    plain = [f"the {lot.blocks if (lot.count or 0) > 1 else f'{lot.look} block'}" for lot in lots if len(lot.look) > 1]
    shown = [lot for lot in lots if len(lot.look) == 1]
    return listed([*plain, *([said_of(shown)] if shown else [])])
