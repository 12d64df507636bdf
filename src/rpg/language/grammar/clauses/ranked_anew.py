""" "Make the green one the first", "the last cube becomes the first": a block gets another place in its line."""

from __future__ import annotations

from rpg.language.grammar.core import Parser, Results
from rpg.language.grammar.places.line_ends import as_counted
from rpg.language.grammar.things.nouns import noun_phrase
from rpg.language.meaning import At, Clause, Meaning, Noun, Pronoun, replace

_BECOMES = ("become", "becomes", "be made", "turn into", "turns into", "end up as", "ends up as", "end up", "ends up")


PUT = frozenset({"put", "place", "move", "set"})


def made_first(p: Parser, i: int, j: int, lemma: str) -> Results[Clause]:
    """ "make the green one the first (of the row)", "put it last": a place where this can be no time."""
    for theme, k in noun_phrase(p, j):
        for found, end in _in_its_line(p, i, k, theme):
            ended = end >= p.end or p.stands(end, _CLOSED)
            if lemma == "make" or (ended and p.stands(end - 1, ("first", "last"))):
                yield (found if lemma == "make" else _bare(found)), end


_CLOSED = frozenset({",", "and", ";"})


def _bare(found: Clause) -> Clause:
    """ "Put it last": behind others that were told before, or after other steps."""
    there = found.adjuncts[0]
    return replace(found, adjuncts=(replace(there, own=True),), cost=1) if isinstance(there, At) else found


def becomes_first(p: Parser, i: int, k: int, theme: Meaning) -> Results[Clause]:
    """ "the last cube in the line should become the first", with its subject before k."""
    if j := p.any_of(k, _BECOMES):
        yield from _in_its_line(p, i, j, theme)


def _in_its_line(p: Parser, i: int, k: int, theme: Meaning) -> Results[Clause]:
    it = isinstance(theme, Pronoun) and theme.word == "it"
    if not it and (not isinstance(theme, Noun) or theme.plural or theme.head == "patch"):
        return
    for there, end in as_counted(p, k):
        span = p.span(i, end)
        yield Clause(verb="place", lemma="put", theme=theme, adjuncts=(there,), span=span, word=p.span(i, i + 1)), end
