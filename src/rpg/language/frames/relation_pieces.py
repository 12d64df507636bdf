"""Pieces of statements put more plainly, before sentences are made of them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from rpg.language.frames.pieces import Piece
from rpg.language.frames.relation_clauses import NAMES

_ONE = frozenset({"a", "an", "one", "another"})


def plainer(pieces: Sequence[Piece]) -> list[Piece]:
    """The pieces without colons in "red: on the mat", with names for "it" and for one and another."""
    colons = {
        n
        for n in range(1, len(pieces) - 1)
        if pieces[n].words == ":" and pieces[n - 1].kind in NAMES and pieces[n + 1].kind in ("rel", "place", "mutual")
    }
    return _one_and_other(_taken([piece for n, piece in enumerate(pieces) if n not in colons]))


def _taken(pieces: list[Piece]) -> list[Piece]:
    """ "Take the red block off the blue one and put it on the mat": it is what was taken."""
    found: list[Piece] = []
    taken: Piece | None = None
    for n, piece in enumerate(pieces):
        if piece.kind in ("stop", "then"):
            taken = None
        if piece.kind == "take":
            taken = pieces[n + 1] if n + 1 < len(pieces) and pieces[n + 1].kind == "thing" else None
        it = piece.kind == "it" and n and pieces[n - 1].value in ("make", "stack")
        if it and taken and taken.named.get("count") is None and "many" not in taken.named:
            piece = replace(taken, named={**taken.named, "det": "the"})
        found.append(piece)
    return found


def _one_and_other(pieces: list[Piece]) -> list[Piece]:
    """ "One red block on A and another red block on B", in one sentence: one of two, and the other."""
    found = list(pieces)
    for color in {piece.named["color"] for piece in pieces if piece.value == "block" and piece.kind == "thing"}:
        same = [n for n, p in enumerate(pieces) if p.named.get("color") == color and p.value != "patch"]
        if len(same) != 2 or any(p.kind in ("stop", "then", "there", "part", "rest") for p in pieces[: same[1]]):
            continue
        one, other = (pieces[n] for n in same)
        if all(_is_one(p) and "size" not in p.named for p in (one, other)):
            found[same[0]] = Piece("part", one.words, None, {"part": "1", "count": "2", "color": color})
            found[same[1]] = Piece("rest", other.words, None, {"color": color, "count": "1"})
    return found


def _is_one(piece: Piece) -> bool:
    """Whether it is one block, which was not told of before."""
    named = piece.named
    return piece.kind == "thing" and "many" not in named and (named.get("det") or named.get("count", "")) in _ONE
