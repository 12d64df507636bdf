""" "Give every cube its own patch": each of them is put on one where no other is."""

from __future__ import annotations

from rpg.language.grammar.core import Parser, Results, choice
from rpg.language.grammar.things.nouns import noun_phrase, simple
from rpg.language.meaning import Clause, Coord, Loc, Noun, Pronoun

_GIVE = ("give", "assign", "allot", "allocate")


@choice
def given_own(p: Parser, i: int) -> Results[Clause]:
    """The blocks, and behind them the patch that is their own."""
    start = p.any_of(i, _GIVE)
    for theme, j in noun_phrase(p, start) if start else ():
        if not isinstance(theme, Noun | Coord | Pronoun) or (isinstance(theme, Noun) and theme.head == "patch"):
            continue
        for patch, end in simple(p, j):
            own = isinstance(patch, Noun) and patch.head == "patch"
            if own and isinstance(patch, Noun) and (patch.det == "its" or patch.traits.scheme == "different"):
                on = Loc(rel="on", landmark=patch, span=p.span(j, end))
                word, span = p.span(i, start), p.span(i, end)
                yield Clause(verb="place", lemma="put", theme=theme, adjuncts=(on,), span=span, word=word), end
