"""Strangers in groups: "with exactly one wrong block in each group", "each group has one odd one out"."""

from __future__ import annotations

from rpg.language.grammar.core import Parser, Results, rule
from rpg.language.grammar.talk.slots import Patterns
from rpg.language.grammar.things import amounts
from rpg.language.meaning import Amount, Clause, Manner

STRANGERS = frozenset({"outlier", "outliers", "stranger", "strangers", "misfit", "misfits", "intruder", "intruders"})
_STRANGER = Patterns(
    "|".join(sorted(STRANGERS)),
    "odd_one_out|odd_ones_out|odd_one|odd_ones",
    "wrong|foreign|mismatched|wrongly|odd|differently|mis colored|color? block|blocks|cube|cubes|one|ones",
    "block|cube|blocks|cubes|one|ones of|in|with the|another|a|some wrong|other|another|different "
    "color|kind|group|colors",
    "block|blocks|cube|cubes|one|ones that|which is|are of? wrong|wrongly_colored|the_wrong_color|another_color",
    "block|cube that|which does_not_belong there|to_it?",
    "of the|another|a|some wrong|other|another|different color|kind|group",
)
_GROUPS = "group|pile|heap|bunch|cluster|set|one|of_them|of_these"
_OF_THE = "each|every_one of the|these|both|them two|three|four|five|six? groups|piles|heaps|bunches|clusters|sets?"
_IN_EACH = Patterns(
    f"in|inside|into|for each|every {_GROUPS}?",
    f"in|inside|into|for {_OF_THE}",
    "per group|pile|heap|bunch|cluster",
    "each|apiece",
    "in both groups|piles|heaps?",
    "is|are|be|must_be|should_be|shall_be|has_to_be|is_to_be|may_be|lies|belongs|goes|sits|hides|hidden "
    f"in|inside|into|among each|every {_GROUPS}?",
    "is|are|be|must_be|should_be|shall_be|has_to_be|is_to_be|may_be|lies|belongs|goes|sits|hides|hidden "
    f"in|inside|into|among {_OF_THE}",
    "is|be|must_be|should_be|has_to_be in both groups|piles|heaps?",
)
_HAS = "has|have|contains|contain|gets|get|includes|include|holds|hold"
_EACH_HAS = Patterns(
    f"each|every {_GROUPS}? should|must|shall|will|has_to|is_to? {_HAS}",
    f"{_OF_THE} should|must|shall|will|has_to|is_to? {_HAS}",
    f"in|inside each|every {_GROUPS}? ,? there_is|there_should_be|there_must_be|there_has_to_be|has_to_be|is|should_be|"
    "must_be|sits|lies|belongs|there_shall_be|there_are?",
)
_OF_WRONG = Patterns(
    "is|are|be|must_be|should_be|shall_be|has_to_be|is_to_be|being "
    "of|in the|another|a|some wrong|other|another|different color|kind",
    "is|are|be|must_be|should_be|shall_be|has_to_be|is_to_be of|in? another_color|a_wrong_color|the_wrong_color|"
    "the_other_color|a_different_color|wrong|different|odd|a_stranger|an_outlier|an_intruder|a_misfit",
)
"""What a block is that is told by the group that it is in."""
_LEADS = (
    "with", "but with", "and with", "each with", "but", "so that each has", "so each has", "but leave", "leaving",
    "but keep", "keeping", "and leave", "each group with", "each pile with", "each one with", "and let", "but let",
    "let", "both with", "each bunch with", "each cluster with", "and each with", "but each with", "where each has",
    "such that each has", "including", "each having", "each containing", "and",
)  # fmt: skip
_THAT = ("so that", "such that", "so", "where", "in such a way that", "but", "and", "only", "let", "but let",
         "and let")  # fmt: skip
_ASKED = ("there is", "there should be", "there must be", "leave", "keep", "put", "have", "place", "add", "allow")


@rule
def strangers(p: Parser, i: int) -> Results[Manner]:
    """As an adjunct: "but with exactly one wrong block in each group", "so that each pile has one outlier"."""
    comma = p.opt(i, ",", ":")
    if j := p.any_of(comma, _LEADS):
        yield from _so_many(p, i, j)
    that = p.any_of(comma, _THAT)
    yield from _each_has(p, i, that or comma)
    if that:
        yield from _so_many(p, i, p.any_of(that, _ASKED) or that)


@rule
def strangers_told(p: Parser, i: int) -> Results[Clause]:
    """In a clause of its own: "in each group there is exactly one stranger", "exactly one wrong block per group"."""
    if not p.rarely(_WORDS):
        return
    for found, j in [*_each_has(p, i, p.one(i, "let") or i), *_so_many(p, i, p.any_of(i, _ASKED) or i)]:
        yield Clause(verb="part", adjuncts=(found,), mode="goal", span=p.span(i, j)), j


_WORDS = STRANGERS | {"odd", "wrong", "foreign", "mismatched", "wrongly", "different", "another", "other", "belong"}


def _so_many(p: Parser, i: int, j: int) -> Results[Manner]:
    """ "exactly one stranger in each group"."""
    one = [(Amount(1, 1), j + 1)] if p.stands(j, ("a", "an")) else []
    for many, k in [*amounts.amount(p, j), *one]:
        for end in _STRANGER.matches(p, k) if many.low == many.high else ():
            if last := max(_IN_EACH.matches(p, end), default=end if "each" in p.words[i:j] else 0):
                yield Manner(kind="outliers", value=float(many.low), span=p.span(i, last)), last
        block = p.opt(k, "block", "cube", "blocks", "cubes", "one")
        for there in _IN_EACH.matches(p, block) if many.low == many.high else ():
            for end in _OF_WRONG.matches(p, there):
                yield Manner(kind="outliers", value=float(many.low), span=p.span(i, end)), end


def _each_has(p: Parser, i: int, at: int) -> Results[Manner]:
    """ "each group has exactly one stranger"."""
    for j in _EACH_HAS.matches(p, at):
        for many, k in amounts.amount(p, j):
            for end in _STRANGER.matches(p, k) if many.low == many.high else ():
                yield Manner(kind="outliers", value=float(many.low), span=p.span(i, end)), end
