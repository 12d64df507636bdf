"""One tower or several that are told floor by floor, in plain sentences."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import replace
from itertools import pairwise

from rpg.language.frames.lots import one
from rpg.language.frames.pieces import Piece, Unclear
from rpg.language.frames.towers.floor_words import PATTERNS, T
from rpg.language.frames.towers.floors_clear import check_clear, check_one_tower
from rpg.language.frames.towers.floors_listed import looks_of
from rpg.language.frames.towers.floors_of_several import towers_told

__all__ = ["PATTERNS", "told"]

_WANTED = re.compile(r"\b(?:must|should|shall|needs?|(?:has|have|is|are) to|to be)\b")
_STACKED = re.compile(rf"\b(?:{T}|stacked|vertically|on top of (?:each other|one another|the other))\b")
_FLOORS = 2
"""So many floors are those of a tower."""
_ITS_BLOCK = re.compile(r"the .*\b(?:one|block|cube)s?$")
_IS_THERE = re.compile("the |this ")
_OF_SEVERAL = frozenset({"size", "side", "rel", "relation", "near", "line", "across", "same", "reversed"})
"""What is only told of towers that are several."""


def told(pieces: Sequence[Piece]) -> str:
    """The tower, or the towers, in plain sentences.

    Raises:
        Unclear: it is not told of each floor which block it is.
    """
    kinds = [piece.kind for piece in pieces]
    sides = [piece for piece in pieces if piece.kind == "side" and _STACKED.search(piece.words)]
    check_clear(pieces)
    if "towers" in kinds or kinds.count("slot") > 1 or len(sides) > 1:
        return towers_told(pieces)
    pieces = [replace(piece, kind="figure") if piece.kind == "slot" else piece for piece in pieces]
    kinds = [piece.kind for piece in pieces]
    check_one_tower(pieces)
    floor = [piece for piece in pieces if piece.kind == "nth" and "floor" in piece.named]
    stacked = any(_STACKED.search(piece.words) for piece in pieces)
    wanted = _WANTED.search(" ".join(piece.words for piece in pieces))
    several = any(piece.named.get("count") not in (None, "", "a", "an", "one", "1") for piece in pieces)
    if not stacked and len(floor) < _FLOORS and (several or not {"part", "upon"} <= {*kinds}):
        raise Unclear
    if "figure" not in kinds and any(piece.kind == "part" and _ITS_BLOCK.match(piece.words) for piece in pieces):
        raise Unclear  # "the bottom one is black": of a tower that is told elsewhere
    if "figure" in kinds and _IS_THERE.match(pieces[kinds.index("figure")].words) and not wanted:
        raise Unclear  # "the stack is ..." tells of the start
    if not _OF_SEVERAL.isdisjoint(kinds) or any(two == ("total", "part") for two in pairwise(kinds)):
        raise Unclear  # "three blocks in between that are white": so many are there
    where = one(pieces, "where")
    looks = looks_of(pieces, one(pieces, "way"))
    return f"Build a tower, from bottom to top: {', '.join(map(_named, looks))}." + (
        f" The tower is {where.value}." if where else ""
    )


def _named(look: str) -> str:
    return look if len(look) == 1 else f"{'an' if look[0] in 'aeiou' else 'a'} {look} block"
