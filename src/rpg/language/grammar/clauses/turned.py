"""Letters of a word that are turned: "SUN, but the U is upside down"."""

from __future__ import annotations

from rpg.language.grammar.clauses.manners import manner
from rpg.language.grammar.core import Parser, Results
from rpg.language.grammar.things.nouns import simple
from rpg.language.meaning import Absolute, Clause, Manner, Meaning, Noun, Structure

_BUT = (", but with", "but with", ", with", "with", ", but", "but", ", except that", "except that", ", only", ",")
_IS = ("is", "being", "should be", "must be", "has to be", "shall be", "is to be", "stands", "lies")


def but_turned(p: Parser, i: int, text: str, word: Structure) -> Results[Meaning]:
    """ "SUN, but the U is upside down": a word by itself, and how one of its letters is turned."""
    lead = p.any_of(i + 1, _BUT) if len(text) > 1 and text.isalpha() else 0
    for letter, j in simple(p, lead) if lead else ():
        if not isinstance(letter, Noun) or len(letter.traits.labels) != 1 or letter.traits.labels[0] not in text:
            continue
        for turn, k in manner(p, p.any_of(j, _IS) or j):
            if isinstance(turn, Manner) and turn.kind == "turn":
                part = Absolute(theme=letter, adjuncts=(turn,), span=p.span(lead, k))
                yield Clause(verb="spell", theme=word, adjuncts=(part,), span=p.span(i, k), cost=1), k
