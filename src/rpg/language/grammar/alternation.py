"""Colours that take turns: "alternating red and white", "whose colours alternate", "every other one black"."""

from __future__ import annotations

from rpg.language.grammar.adjectives import color
from rpg.language.grammar.core import Parser, Results, rule
from rpg.language.grammar.lists import listed
from rpg.language.grammar.wishes import Patterns
from rpg.language.meaning import Meaning, Noun, OrderBy, Traits

_TURNS = Patterns(
    "so|so_that|such_that|where|in_which|while|and? the|their|its? color|colors|blocks|cubes "
    "should|must|will|do|does? alternate|alternates|take_turns",
    "whose|with color|colors|blocks should|must|will|do|does? alternate|alternates|alternating",
    "so_that|so|that|which|such_that they|it? should|must|will? alternate|alternates in_color|colors?",
)
"""The colours of the blocks spoken of alternate."""
_BETWEEN = (
    "alternating between", "with alternating colors", "in alternating colors ,", "alternating", "alternately",
    "alternately in", "with alternating", "of alternating", "switching between",
)  # fmt: skip
"""What two colours follow."""
_AFTER = ("alternating", "in alternation", "alternately", "alternate", "taking turns", "take turns")
_WHERE = ("in which", "where", "with", "so that", "such that", "so", ",")
_ONE = ("every other one", "every second one", "every other block", "every second block", "every other cube",
        "every second cube", "every other", "every second")  # fmt: skip
_REST = ("the rest", "the others", "the other ones", "the remaining ones", "the other blocks", "all others")


@rule
def alternation(p: Parser, i: int) -> Results[Meaning]:
    """Colours that alternate, with the two of them where they are named."""
    for j in _TURNS.matches(p, i):
        yield OrderBy(by="alternating", span=p.span(i, j)), j
        if k := p.one(j, "between"):
            yield from _two(p, i, k)
    if j := p.any_of(i, _BETWEEN):
        yield from _two(p, i, j)
    for j in dict.fromkeys((i, p.any_of(i, _WHERE) or i)):
        for items, k in listed(p, j):
            if end := p.any_of(k, _AFTER):
                yield OrderBy(by="alternating", items=items, span=p.span(i, end)), end
        if k := p.any_of(j, _ONE):
            yield from _one_and_rest(p, i, k)


def _two(p: Parser, i: int, j: int) -> Results[Meaning]:
    for items, k in listed(p, j):
        k = p.opt(k, "blocks", "cubes", "ones")
        yield OrderBy(by="alternating", items=items, span=p.span(i, k)), k


def _one_and_rest(p: Parser, i: int, j: int) -> Results[Meaning]:
    """ "every other one (is) black, the rest (are) white"."""
    j = p.any_of(j, ("is", "should be", "must be", "being", "in")) or j
    for one, k in color(p, j):
        rest = p.any_of(p.opt(p.opt(k, ","), "and"), _REST)
        rest = p.any_of(rest, ("is", "are", "should be", "must be", "being", "in")) or rest if rest else 0
        for two, end in color(p, rest) if rest else ():
            items = tuple(Noun(head="any", traits=Traits(colors=(x,)), span=p.span(j, end)) for x in (one, two))
            yield OrderBy(by="alternating", items=items, span=p.span(i, end)), end
