"""Distances that change: "a bit more distance between red and green", "make the gap between them smaller"."""

from __future__ import annotations

from collections.abc import Iterator

from rpg.language.grammar.clauses.shifts import OPEN, Told, how_far
from rpg.language.grammar.core import Parser
from rpg.language.grammar.talk.slots import Patterns
from rpg.language.grammar.things.nouns import noun_phrase
from rpg.language.meaning import Clause, Loc, Meaning, Pronoun

_GAP = "distance|gap|space|spacing|separation|room"
_LEAVE = "put|leave|make|create|get|have|there_should_be|there_must_be|i_want|i_would_like|i_need|please"
_CHANGED = {
    "receded": Patterns(
        f"{_LEAVE}? a_bit|a_little|slightly|some|a_little_bit? more {_GAP} between",
        f"increase|widen|enlarge|extend the {_GAP} between",
    ),
    "approached": Patterns(
        f"{_LEAVE}? a_bit|a_little|slightly|a_little_bit? less {_GAP} between",
        f"decrease|reduce|shrink|narrow|shorten|lessen the {_GAP} between",
    ),
}
_MADE = Patterns(f"make the {_GAP} between")
_SO = {
    "receded": Patterns("a_bit|a_little|slightly|a_little_bit? bigger|larger|wider|longer|greater"),
    "approached": Patterns("a_bit|a_little|slightly|a_little_bit? smaller|narrower|shorter|tighter"),
}


def widened(p: Parser, i: int) -> Iterator[tuple[Clause, int]]:
    """The blocks between which something changes are moved closer together, or farther apart."""
    for rel, patterns in _CHANGED.items():
        for j in patterns.matches(p, i):
            for theme, end in noun_phrase(p, j):
                for told, last in ((OPEN, end), *how_far(p, end)):
                    yield _clause(p, i, last, rel, theme, told), last
    for j in _MADE.matches(p, i):
        for theme, k in noun_phrase(p, j):
            for rel, so in _SO.items():
                for end in so.matches(p, k):
                    for told, last in ((OPEN, end), *how_far(p, end)):
                        yield _clause(p, i, last, rel, theme, told), last


def _clause(p: Parser, i: int, end: int, rel: str, theme: Meaning, told: Told) -> Clause:
    low, high, how = told
    each = Pronoun(word="each other", span=p.span(i, end))
    place = Loc(rel=rel, landmark=each, mods=(how,), low=low, high=high, span=p.span(i, end))
    return Clause(verb="place", lemma="move", theme=theme, adjuncts=(place,), span=p.span(i, end))
