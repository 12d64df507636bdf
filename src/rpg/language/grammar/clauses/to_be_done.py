"""What is to be done to something, said as a state: "the red block shall be placed on the mat"."""

from __future__ import annotations

from collections.abc import Collection
from typing import TypeGuard

from rpg.language.meaning import Clause, Meaning

Readings = list[tuple[Meaning, int]]


def to_be_done(readings: Readings, modals: Collection[str]) -> Readings:
    """The readings of a predicate; behind a modal "placed on the mat" is what is to be done, and no state besides."""
    done = [(end, x.word, x.adjuncts) for x, end in readings if isinstance(x, Clause) and _done(x)]
    if not modals or not done:
        return readings
    return [(x, end) for x, end in readings if not _state(x) or (end, x.word, x.adjuncts) not in done]


def _done(clause: Clause) -> bool:
    return clause.verb == "place" and clause.mode == "goal" and not clause.negated


def _state(meaning: Meaning) -> TypeGuard[Clause]:
    return isinstance(meaning, Clause) and meaning.verb == "be"
