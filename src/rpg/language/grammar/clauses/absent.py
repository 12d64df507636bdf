""" "Do not put anything on it", "there must never be anything on the mat": nothing is there."""

from __future__ import annotations

from rpg.language.grammar.clauses.adjuncts import adjuncts
from rpg.language.grammar.clauses.verbs import ever
from rpg.language.grammar.core import Parser, Results
from rpg.language.grammar.talk.slots import Patterns
from rpg.language.grammar.things.nouns import noun_phrase
from rpg.language.meaning import Amount, Clause, Loc, Manner, Meaning, Noun, Pronoun, TableTop, replace


def nothing_at_all(found: Clause) -> Clause:
    """ "do not put anything on it": nothing is put there; "none stacked": they are not stacked."""
    theme = found.theme
    if (all_ := none_stacked(found)) is not None:
        return _on_the_table(found, all_)
    if not found.negated or not isinstance(theme, Pronoun) or theme.word not in ("anything", "anything else"):
        return found
    if found.verb == "stack" and not found.adjuncts and theme.word == "anything":  # "do not stack anything"
        return _on_the_table(found, Pronoun(word="everything", span=theme.span))
    nothing = Pronoun(word="nothing else" if theme.word.endswith("else") else "nothing", span=theme.span)
    return replace(found, theme=nothing, negated=False, verb="be", lemma="")


def _on_the_table(found: Clause, all_: Meaning) -> Clause:
    """Blocks none of which is on another."""
    table = Loc(rel="on", landmark=TableTop(span=found.span), span=found.span)
    return Clause(verb="be", theme=all_, adjuncts=(table,), mode="goal", span=found.span, cost=found.cost)


def none_stacked(found: Clause) -> Meaning | None:
    """ "None of them is stacked.", "nothing stacked": which blocks are on no other."""
    theme, more = found.theme, [a for a in found.adjuncts if not (isinstance(a, Manner) and a.kind == "allowed")]
    if found.verb != "stack" or more or found.negated or found.mode == "start":
        return None
    if isinstance(theme, Pronoun):
        whole = {"none of them": "them", "neither of them": "them", "nothing": "everything"}.get(theme.word)
        return Pronoun(word=whole, span=theme.span) if whole else None
    if isinstance(theme, Noun) and theme.det == "no" and theme.head != "patch":
        return theme.part_of or replace(theme, det="all", plural=True)
    return None


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
        none = _none_of_them(theme)
        anything = isinstance(theme, Pronoun) and theme.word in ("anything", "anything else")
        if none is None and not anything:
            continue
        never = not {"never", "ever", "no"}.isdisjoint(p.words[i:j])
        for found, end in adjuncts(p, k):
            denied = Clause(verb="exist", theme=none or theme, adjuncts=found, mode="goal", span=p.span(i, end))
            denied = replace(denied, negated=none is None)
            if found:
                yield ever(nothing_at_all(denied), never), end


def _none_of_them(theme: Meaning) -> Noun | None:
    """ "(There must not be) a block", "any red blocks": none that looks so."""
    one = isinstance(theme, Noun) and theme.det in ("a", "any") and theme.amount in (None, Amount(1, 1))
    if not one or not isinstance(theme, Noun) or theme.head != "block" or theme.part_of is not None:
        return None
    return replace(theme, det="no", amount=None)
