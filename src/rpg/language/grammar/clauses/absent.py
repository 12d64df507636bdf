""" "Do not put anything on it", "there must never be anything on the mat": nothing is there."""

from __future__ import annotations

from dataclasses import replace

from rpg.language.grammar.clauses.adjuncts import adjuncts
from rpg.language.grammar.clauses.verbs import ever
from rpg.language.grammar.core import Parser, Results
from rpg.language.grammar.talk.slots import Patterns
from rpg.language.grammar.things.nouns import noun_phrase
from rpg.language.meaning import Clause, Loc, Pronoun, TableTop


def nothing_at_all(found: Clause) -> Clause:
    """ "do not put anything on it": nothing is put there."""
    theme = found.theme
    if not found.negated or not isinstance(theme, Pronoun) or theme.word not in ("anything", "anything else"):
        return found
    if found.verb == "stack" and not found.adjuncts and theme.word == "anything":  # "do not stack anything"
        table = Loc(rel="on", landmark=TableTop(span=found.span), span=found.span)
        all_ = Pronoun(word="everything", span=theme.span)
        return Clause(verb="be", theme=all_, adjuncts=(table,), mode="goal", span=found.span)
    nothing = Pronoun(word="nothing else" if theme.word.endswith("else") else "nothing", span=theme.span)
    return replace(found, theme=nothing, negated=False, verb="be", lemma="")


_NEVER_THERE = Patterns(
    "there must|may|should|can|shall|will|is_to never|not|at_no_time ever? be",
    "there must|may|should|can|shall|will be at no time|point|moment",
    "there must|may|should|can|shall|will be never",
    "at|in no time|point|moment|case may|must|should|can|shall there be",
)


def never_there(p: Parser, i: int) -> Results[Clause]:
    """ "there must never be anything on the green block": nothing is there."""
    j = max(_NEVER_THERE.matches(p, i), default=0)
    for theme, k in noun_phrase(p, j) if j else ():
        if not isinstance(theme, Pronoun) or theme.word not in ("anything", "anything else"):
            continue
        never = not {"never", "ever", "no"}.isdisjoint(p.words[i:j])
        for found, end in adjuncts(p, k):
            denied = Clause(verb="exist", theme=theme, adjuncts=found, negated=True, mode="goal", span=p.span(i, end))
            if found:
                yield ever(nothing_at_all(denied), never), end
