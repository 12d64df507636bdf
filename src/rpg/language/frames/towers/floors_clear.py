"""What leaves a tower open that is told floor by floor: blocks that are not told with it, an end that is not, "it"."""

from __future__ import annotations

import re
from collections.abc import Sequence

from rpg.language import lexicon
from rpg.language.frames.pieces import Piece, Unclear
from rpg.language.frames.towers.floor_words import T

_REFERS = re.compile(r"\b(?:them|the (?:blocks|cubes|bricks|boxes))\b")
"""Ahead of the floors these may be more blocks than those that are told there."""
_KNOWN = re.compile(rf"\bthe (?:{'|'.join(lexicon.COLORS)}) {T}\b")
"""A tower that is there, of which it is not told what it is made of."""
_STRICTLY = re.compile(r"\b(?:directly|immediately|right(?= (?:in front|behind|next))|straight|exactly)\b")
_PUT_IT = re.compile(r"\b(?:put|place|move|set) it\b")


def check_clear(pieces: Sequence[Piece]) -> None:
    """Raise Unclear where one tower is to be "directly" in front of another one, which is told of no tower here."""
    if any(_STRICTLY.search(piece.words) for piece in pieces if piece.kind in ("rel", "relation", "side")):
        raise Unclear


def check_one_tower(pieces: Sequence[Piece]) -> None:
    """Raise Unclear where the tower may have other blocks, or others at its ends, or is not what is put somewhere."""
    kinds = [piece.kind for piece in pieces]
    words = " ".join(piece.words for piece in pieces)
    ahead = " ".join(piece.words for piece in pieces[: kinds.index("item") if "item" in kinds else None])
    if _REFERS.search(ahead) or _KNOWN.search(words) or _of_its_end(pieces) or _goes_on(pieces):
        raise Unclear
    if "where" in kinds and _PUT_IT.search(words):
        raise Unclear  # the tower, or the block on top of it?
    if "way" in kinds and {"over", "below"} & {*kinds}:
        raise Unclear  # "red on blue on green from bottom to top"


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
