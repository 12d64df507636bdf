"""Where another block was at the start: "where the red block was", "in the old place of A", "to red's position"."""

from __future__ import annotations

from rpg.language.grammar.core import Parser, Results
from rpg.language.grammar.talk.slots import Patterns
from rpg.language.grammar.things.nouns import simple
from rpg.language.meaning import Coord, Loc, Meaning, Noun

_FORMER = "original|old|former|initial|starting|start|first|previous|present|current"
_SPOT = "place|spot|position|location"
_LEADS = Patterns(
    "right|exactly|precisely|just? where",
    f"right|exactly|precisely|just? to|in|into|at|on? the exact|very|same? {_SPOT} where|that|in_which",
)
_WAS = Patterns(
    "was|were|started|began|stood|lay|sat|had_been|used_to_be|came_from standing|lying|sitting|located|placed? "
    "at_the_start|at_the_beginning|initially|originally|before|at_first|in_the_beginning|to_begin_with|first|earlier?",
    "starts|begins|is_at_the_start|are_at_the_start|is_now|are_now|is_right_now|is_at_the_moment|is_currently",
    "initially|originally|first was|were|stood|lay",
)
_PLACE_OF = Patterns(f"exactly|precisely? to|in|into|at|on the exact? {_FORMER}? {_SPOT} of")
_OWN = Patterns(f"{_FORMER}? {_SPOT}")


def where_was(p: Parser, i: int) -> Results[Loc]:
    """The place that a block had when the episode began."""
    for j in _LEADS.matches(p, i):
        for mark, k in simple(p, j):
            yield from ((_place(p, i, end, mark), end) for end in _WAS.matches(p, k) if _blocks(mark))
    for j in _PLACE_OF.matches(p, i):
        yield from ((_place(p, i, k, mark), k) for mark, k in simple(p, j) if _blocks(mark))
    if to := p.any_of(i, ("to", "in", "into", "at")):
        for mark, k in simple(p, to):
            own = p.one(k, "'s") if _blocks(mark) else 0
            yield from ((_place(p, i, end, mark), end) for end in (_OWN.matches(p, own) if own else ()))


def _place(p: Parser, i: int, j: int, mark: Meaning) -> Loc:
    return Loc(rel="where was", landmark=mark, span=p.span(i, j))


def _blocks(mark: Meaning) -> bool:
    """A block, or several; a patch is where it always was."""
    if isinstance(mark, Coord):
        return mark.op == "and" and all(map(_blocks, mark.items))
    return isinstance(mark, Noun) and mark.head != "patch"
