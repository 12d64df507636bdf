"""One tower or several that are told floor by floor, in plain sentences."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import replace

from rpg.language import lexicon
from rpg.language.frames.lots import one
from rpg.language.frames.pieces import Piece, Unclear
from rpg.language.frames.towers.floor_words import PATTERNS, T
from rpg.language.frames.towers.floors_listed import looks_of
from rpg.language.frames.towers.floors_of_several import towers_told

__all__ = ["PATTERNS", "told"]

_WANTED = re.compile(r"\b(?:must|should|shall|needs?|(?:has|have|is|are) to|to be)\b")
_STACKED = re.compile(rf"\b(?:{T}|stacked|vertically|on top of (?:each other|one another|the other))\b")
_FLOORS = 2
"""So many floors are those of a tower."""
_IS_THERE = re.compile("the |this ")
_REFERS = re.compile(r"\b(?:them|the (?:blocks|cubes|bricks|boxes))\b")
"""Ahead of the floors these may be more blocks than those that are told there."""
_KNOWN = re.compile(rf"\bthe (?:{'|'.join(lexicon.COLORS)}) {T}\b")
"""A tower that is there, of which it is not told what it is made of."""
_STRICTLY = re.compile(r"\b(?:directly|immediately|right(?= (?:in front|behind|next))|straight|exactly)\b")
_PUT_IT = re.compile(r"\b(?:put|place|move|set) it\b")
_OF_SEVERAL = frozenset({"size", "side", "rel", "relation", "near", "line", "across", "same", "reversed"})
"""What is only told of towers that are several."""


def told(pieces: Sequence[Piece]) -> str:
    """The tower, or the towers, in plain sentences.

    Raises:
        Unclear: it is not told of each floor which block it is.
    """
    kinds = [piece.kind for piece in pieces]
    sides = [piece for piece in pieces if piece.kind == "side" and _STACKED.search(piece.words)]
    if any(_STRICTLY.search(piece.words) for piece in pieces if piece.kind in ("rel", "relation", "side")):
        raise Unclear  # "directly in front of it" is told of no tower there
    if "towers" in kinds or kinds.count("slot") > 1 or len(sides) > 1:
        return towers_told(pieces)
    pieces = [replace(piece, kind="figure") if piece.kind == "slot" else piece for piece in pieces]
    kinds = [piece.kind for piece in pieces]
    words = " ".join(piece.words for piece in pieces)
    ahead = " ".join(piece.words for piece in pieces[: kinds.index("item") if "item" in kinds else None])
    if _REFERS.search(ahead) or _KNOWN.search(words) or _of_its_end(pieces) or _goes_on(pieces):
        raise Unclear
    if "where" in kinds and _PUT_IT.search(words):
        raise Unclear  # the tower, or the block on top of it?
    if "way" in kinds and {"over", "below"} & {*kinds}:  # "red on blue on green from bottom to top"
        raise Unclear
    floor = [piece for piece in pieces if piece.kind == "nth" and "floor" in piece.named]
    stacked = any(_STACKED.search(piece.words) for piece in pieces)
    wanted = _WANTED.search(words)
    several = any(piece.named.get("count") not in (None, "", "a", "an", "one", "1") for piece in pieces)
    if not stacked and len(floor) < _FLOORS and (several or not {"part", "upon"} <= {*kinds}):
        raise Unclear
    if "figure" in kinds and _IS_THERE.match(pieces[kinds.index("figure")].words) and not wanted:
        raise Unclear  # "the stack is ..." tells of the start
    if not _OF_SEVERAL.isdisjoint(kinds):
        raise Unclear
    where = one(pieces, "where")
    looks = looks_of(pieces, one(pieces, "way"))
    return f"Build a tower, from bottom to top: {', '.join(map(_named, looks))}." + (
        f" The tower is {where.value}." if where else ""
    )


def _named(look: str) -> str:
    return look if len(look) == 1 else f"{'an' if look[0] in 'aeiou' else 'a'} {look} block"


def _of_its_end(pieces: Sequence[Piece]) -> bool:
    """ "Red on top, then two blue ones": down from there, or up to there? It is clear where the other end is told."""
    parts = [piece.value[0] for piece in pieces if piece.kind == "part"]
    follows = any(piece.kind == "then" for piece in pieces)
    return follows and "top" in parts and "bottom" not in parts and not any(piece.kind == "way" for piece in pieces)


def _goes_on(pieces: Sequence[Piece]) -> bool:
    """ "A tower with red on top. Blue is below it": and what below that? It is clear where the foot is told, or how
    many blocks there are."""
    told = [n for n, piece in enumerate(pieces) if piece.kind == "item"]
    between = pieces[told[0] : told[-1]] if told else []
    parts = [piece.value[0] for piece in pieces if piece.kind == "part"]
    closed = "bottom" in parts or any(piece.kind in ("way", "total", "count", "nth") for piece in pieces)
    return "top" in parts and not closed and any(piece.words in (".", ";", "!") for piece in between)
