""" "The red block must move to the mat", "it leaves the mat and goes on": said of a block as if it went by itself."""

from __future__ import annotations

from rpg.language.grammar.clauses.adjuncts import adjuncts
from rpg.language.grammar.clauses.just_moved import ends_there, of_none
from rpg.language.grammar.core import Parser, Results
from rpg.language.grammar.things.nouns import noun_phrase
from rpg.language.meaning import Clause, Coord, In, Loc, Meaning, Noun, Pronoun, Structure, TableTop

MOVES = frozenset({"move", "moves", "travel", "travels", "wander", "wanders", "hop", "hops", "climb", "climbs", "slide",
                   "slides", "jump", "jumps", "shift", "shifts", "step", "steps", "return", "returns"})  # fmt: skip
_OVER = ("over", "up", "down", "back", "away", "across", "out")
_GOES = frozenset({"move", "moves"})
_GONE = ("leave", "leaves", *(f"{comes} {off}" for comes in ("come", "comes", "go", "goes", "get", "gets")
                               for off in ("off", "down", "away", "down again", "off again")))  # fmt: skip
"""Verbs of what is no longer where it was said to be."""
_LEAVES = ("leave", "leaves")
_MAY = frozenset({"may", "might", "can", "could"})
"""Behind these nothing is asked for."""


def moves(p: Parser, i: int, k: int, theme: Meaning, mode: str, negated: bool) -> Results[Clause]:
    """Clauses from i on whose verb is at k: as much as "must be moved to ...", "must be taken off ..."."""
    if negated or not isinstance(theme, Noun | Coord | Pronoun | Structure):
        return
    if getattr(theme, "head", "") == "patch" or p.follows(k, _MAY):
        return
    if (j := p.one(k, _GOES)) and ends_there(p, j) and not of_none(theme):
        yield Clause(verb="place", lemma="move", theme=theme, mode=mode, span=p.span(i, j), word=p.span(k, j)), j
    if j := p.one(k, MOVES):
        for found, end in [*adjuncts(p, j), *(adjuncts(p, j + 1) if p.stands(j, _OVER) else ())]:
            if any(getattr(x, "rel", "") == "above" for x in found):
                continue  # "jumps over it": and where it is then?
            if any(isinstance(x, Loc | In) or getattr(x, "kind", "") == "stay" for x in found):
                yield Clause(verb="place", lemma="move", theme=theme, adjuncts=found, mode=mode, span=p.span(i, end),
                             word=p.span(k, j)), end  # fmt: skip
    if (gone := p.any_of(k, _GONE)) and ends_there(p, gone) and not of_none(theme):
        there = Pronoun(word="there", span=p.span(k, gone))
        off = Loc(rel="off", landmark=there, span=there.span)
        yield Clause(verb="place", lemma="put", theme=theme, adjuncts=(off,), mode=mode, span=p.span(i, gone),
                     word=p.span(k, gone)), gone  # fmt: skip
    if j := p.one(k, _LEAVES) or (p.one(k, "left") if p.follows(k, ("has", "have")) else 0):
        for mark, end in noun_phrase(p, j):
            if isinstance(mark, TableTop) or not isinstance(mark, Noun | Pronoun):
                continue
            off = Loc(rel="off", landmark=mark, span=p.span(k, end))
            for found, last in adjuncts(p, end):
                yield Clause(verb="place", lemma="take", theme=theme, adjuncts=(off, *found), mode=mode,
                             span=p.span(i, last), word=p.span(k, j)), last  # fmt: skip


def of_the_same(p: Parser, j: int, before: Clause, item: Meaning) -> bool:
    """ "Red should come off blue and move to the mat": no command to move whatever there is."""
    going = isinstance(item, Clause) and (item.verb, item.mode, item.theme) == ("place", "command", None)
    return going and p.stands(j, MOVES) and before.theme is not None
