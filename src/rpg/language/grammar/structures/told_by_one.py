"""Which of several structures is meant, told by one of its blocks: "the stack with the red block is on the left"."""

from __future__ import annotations

from rpg.language import lexicon
from rpg.language.grammar.core import Parser
from rpg.language.grammar.talk.slots import Patterns
from rpg.language.meaning import Meaning, Noun, Structure

_FINITE = frozenset({*lexicon.POSTURE, "must", "should", "shall", "has", "may", "can", "will", "needs"})
_BEFORE = frozenset({"of", "to", "than", "behind", "beside", "by", "from", "near", "beyond", "above", "opposite"})
"""Behind these words of place a structure is a landmark, and what follows it says which one it is."""


def told_by_one(p: Parser, base: Structure, block: Meaning, end: int) -> bool:
    """Whether "with the red block" tells which structure is meant, and not what is to be used, or where it is."""
    if base.det != "the" or base.plural or base.sizes or not isinstance(block, Noun) or block.det != "the":
        return False
    begin = next(n for n, token in enumerate(p.tokens) if token.span[0] == base.span[0])
    closed = end >= p.end or p.stands(end, (",", "and"))
    return p.stands(end, _FINITE) or (closed and p.follows(begin, _BEFORE))


def placed_inside(p: Parser, members: Meaning, end: int) -> bool:
    """Whether "with red and blue (in the front row)" tells of a part, and not what the structure is made of: a single
    block that goes on with "and", or several that have a place in it."""
    single = isinstance(members, Noun) and not members.plural and members.det != "the"
    return (single and p.stands(end, ("and",))) or any(_INSIDE.matches(p, end))


_INSIDE = Patterns(
    "in|on|at the front|back|top|bottom|first|second|third|last|middle|left|right|far|near|upper|lower "
    "row|column|layer|line"
)


def shows_it(p: Parser, i: int, end: int) -> bool:
    """ "(the digits 1 to 4 in a row) with 4 on the left": where digits are told ahead of the line, a number that has a
    place is the block that shows it, and not how many blocks the line has. `i`: of "with", behind the line's noun."""
    kind, _ = lexicon.STRUCTURE.get(p.words[i - 1], ("", False))
    if kind not in _LINES or p.words[i] != "with" or not p.stands(end, _PLACED):
        return False
    if any(word in lexicon.DIGIT for word in p.words[: i - 1]):
        return True
    numbers = [n for n in range(1, i - 1) if p.number(n) is not None]
    return any(
        p.words[n - 1] in _ONE or (p.stands(n - 1, _LISTED) and n - 2 in numbers)
        for n in numbers
        if p.words[n] != "one"
    )


_LINES = frozenset({"row", "line", "column", "stack"})
_PLACED = frozenset({"on", "at", "in", "to", "as", "first", "last", "leftmost", "rightmost", "topmost", "nearest",
                     "closest", "farthest", "furthest", "being"})  # fmt: skip
_LISTED = frozenset({"to", "through", "until", ",", "and"})
_ONE = frozenset({"a", "an"})
_ONE_MORE = frozenset({"a", "an", "another", "one", "two", "three", "the"})


def left_open(p: Parser, k: int, end: int) -> bool:
    """Whether a list of blocks told by commas alone is not over: "a tower of two blocks, a single block and a tower of
    three" are three things, of which the second belongs to none of the others."""
    lead = p.opt(p.opt(end, ","), "and")
    more = lead > end and p.words[lead - 1] == "and" and p.stands(lead, _ONE_MORE)
    whole = more and any(word in lexicon.STRUCTURE for word in p.words[lead : lead + 4])
    return whole and "and" not in p.words[k:end] and any(word in _ONE_MORE for word in p.words[k + 1 : end])
