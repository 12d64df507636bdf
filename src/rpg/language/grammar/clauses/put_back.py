""" "Lift it off the blue one and put it back (on)": where it was told to be at first."""

from __future__ import annotations

from rpg.core.diagnostics import Span
from rpg.language.grammar.core import Parser, Results
from rpg.language.meaning import Clause, Loc, Meaning, Noun, Pronoun, TableTop, replace

WHERE_IT_WAS = "where it was at first"
"""A pronoun for the place that something is put back to."""
_THERE = ("on", "on top", "on again", "on top again", "up", "again", "there", "there again", "in place", "up there")


def put_back(p: Parser, i: int, k: int, theme: Meaning, word: Span) -> Results[Clause]:
    """Behind a theme and "back" before `k`."""
    if p.follows(k, ("back",)) and isinstance(theme, Noun | Pronoun):
        end = p.any_of(k, _THERE) or k
        was = Pronoun(word=WHERE_IT_WAS, span=p.span(k - 1, end))
        place = Loc(rel="on", landmark=was, span=was.span)
        yield Clause(verb="place", lemma="return", theme=theme, adjuncts=(place,), span=p.span(i, end), word=word), end


def lifted_off(said: Clause) -> Clause:
    """ "Lift red off blue" is as much as "take" it off: what is only picked up has no place in the end."""
    off = any(isinstance(x, Loc) and x.rel == "off" and not isinstance(x.landmark, TableTop) for x in said.adjuncts)
    return replace(said, verb="use", lemma="take") if off and said.verb == "pick" else said


def picked_out(p: Parser, j: int, k: int, said: Clause) -> Clause:
    """ "Pull (out) the yellow one (out, and put it on the mat)": as much as to pick it. It stands at j..k."""
    out = p.follows(j, ("out",)) or p.follows(k, ("out",))
    out = out and said.verb == "place" and said.lemma in _PULLED and not said.adjuncts
    return replace(said, verb="pick") if out else lifted_off(said)


_PULLED = frozenset({"pull", "drag", "slide", "get", "shift"})
