"""Statements about blocks and patches, and how a stretch of pieces is looked at."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

from rpg.language.frames.pieces import Piece
from rpg.language.frames.relations.words import Relation

NAMES = frozenset({"thing", "part", "rest", "it", "they"})
"""Kinds of pieces that name what a statement is about."""


@dataclass(frozen=True)
class Statement:
    """What is said of `subjects`. `how`: its kind, as the piece that tells it; `what` it tells; `denied`: "not" or
    "never"; `ahead`: it is told before them; `beside`: on which side it is besides; `stacked`: they are stacked."""

    subjects: tuple[Piece, ...]
    how: str
    what: Relation | str = ""
    objects: tuple[Piece, ...] = ()
    denied: str = ""
    ahead: bool = False
    beside: str = ""
    stacked: bool = False


Parse = tuple[tuple[Statement, ...], int]


def known_now(named: tuple[Piece, ...]) -> tuple[Piece, ...]:
    """Names as those of things that are known by now: "a red block" is the red block."""
    return tuple(
        replace(piece, named={**piece.named, "det": "the"}) if piece.named.get("det") in ("a", "an", "one") else piece
        for piece in named
    )


def behind_verbs(pieces: Sequence[Piece], at: int) -> int:
    """The end of verbs that tell of no relation themselves."""
    while at < len(pieces) and pieces[at].kind == "be":
        at += 1
    return at


def kind_at(pieces: Sequence[Piece], at: int) -> str:
    """The kind of the piece at a place, "" behind the last."""
    return pieces[at].kind if at < len(pieces) else ""


def words_at(pieces: Sequence[Piece], at: int) -> str:
    """The words of the piece at a place, "" behind the last."""
    return pieces[at].words if at < len(pieces) else ""


def lists(pieces: Sequence[Piece], at: int) -> Iterator[tuple[tuple[Piece, ...], int]]:
    """Names from a place on: one, "A and B", "A, B and C"."""
    if kind_at(pieces, at) not in NAMES:
        return
    named, end = [pieces[at]], at + 1
    yield (pieces[at],), end
    while kind_at(pieces, end) == "comma" and kind_at(pieces, end + 1) in NAMES:
        named.append(pieces[end + 1])
        end += 2
    end += kind_at(pieces, end) == "comma" and len(named) > 1
    listing = words_at(pieces, end) in ("and", "plus", "as well as")
    if listing and kind_at(pieces, end + 1) in NAMES:
        yield (*named, pieces[end + 1]), end + 2
