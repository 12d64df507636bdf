""" "Close enough to the purple one that they touch", "... to touch it": touching it."""

from __future__ import annotations

from rpg.language.grammar.core import Parser, Results, choice
from rpg.language.grammar.talk.slots import Patterns
from rpg.language.grammar.things.nouns import noun_phrase
from rpg.language.meaning import Loc, Pronoun

_NEAR = ("close enough to", "near enough to", "so close to", "so near to", "sufficiently close to")
_TOUCH = Patterns(
    "that|so_that|so they|the_two|both|it just? touch|touches|are_touching|are_in_contact it|each_other|one_another?",
    "to be|come? just? touch|touching it|each_other|one_another?",
    "for them|it|the_two to touch it|each_other|one_another?",
)


_CLOSE_BY = ("close", "near", "close by", "very close", "quite close", "really close")
_UNTOUCHED = frozenset({"but", "without", "yet", "though", "not"})


@choice
def close_by(p: Parser, i: int) -> Results[Loc]:
    """ "(in front of the red one,) close but not touching": near what is spoken of there."""
    j = p.any_of(i, _CLOSE_BY)
    if j and p.stands(p.opt(j, ","), _UNTOUCHED):
        yield Loc(rel="near", landmark=Pronoun(word="each other", span=p.span(i, j)), span=p.span(i, j)), j


@choice
def near_enough(p: Parser, i: int) -> Results[Loc]:
    j = p.any_of(i, _NEAR)
    for mark, k in noun_phrase(p, j) if j else ():
        for end in sorted(_TOUCH.matches(p, p.opt(k, ","))):
            yield Loc(rel="touching", landmark=mark, span=p.span(i, end)), end
