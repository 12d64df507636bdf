"""Letters of a word that are turned: "SUN, but the U is upside down", and those that are not: "..., but not B"."""

from __future__ import annotations

from rpg.language.grammar.clauses.manners import manner
from rpg.language.grammar.core import Parser, Results
from rpg.language.grammar.things.nouns import noun_phrase, simple
from rpg.language.meaning import Absolute, Clause, Coord, Manner, Meaning, Noun, Pronoun, Structure, replace

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


REST = ("the others", "the rest", "others", "the other", "the other one")
"""Whoever was not spoken of."""


def not_turned(p: Parser, i: int, before: Clause) -> Results[Clause]:
    """ "(Turn A and C clockwise), but not B", "and neither B nor C": these are not turned."""
    turned = before.verb == "turn" and not before.negated and all(isinstance(a, Manner) for a in before.adjuncts)
    turned = turned and getattr(before.theme, "det", "") not in ("all", "each")  # of all of them it is an exception
    denied = p.one(i, "not") if turned else 0
    for theme, j in noun_phrase(p, denied or i) if turned else ():
        plain = isinstance(theme, Noun | Coord) or (isinstance(theme, Pronoun) and theme.word in REST)
        none = isinstance(theme, Coord) and theme.op == "nor"
        if plain and bool(denied) != none and (j >= p.end or p.words[j] in (",", ";")):
            lies = tuple(a for a in before.adjuncts if getattr(a, "kind", "") in ("turn", "facing"))
            yield replace(before, theme=theme, adjuncts=lies, negated=not none, span=p.span(i, j), cost=0), j
