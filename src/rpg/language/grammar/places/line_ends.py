"""Places in a line by the order in which it is read: "to the end of the row", "to the beginning", "the first"."""

from __future__ import annotations

from rpg.language import lexicon
from rpg.language.grammar.core import Parser, Results, rule
from rpg.language.grammar.talk.slots import Patterns
from rpg.language.meaning import At, Meaning

_LINE = "row|line|word|sequence|lineup|series"
_LAST = Patterns(
    "to the very? end", f"to|at the very? end of the|its|that {_LINE}",
)  # fmt: skip
_FIRST = Patterns(
    "to the very? beginning|start", f"to|at the very? beginning|start of the|its|that {_LINE}",
)  # fmt: skip
"""Ends of what is read from its beginning on."""
_INTO = ("to", "to the", "into", "into the")
_SPOT = frozenset({"place", "position", "spot"})
_OF_IT = Patterns(f"one|block|cube|letter|digit of|in the|that {_LINE}", f"of|in the|that {_LINE}",
                  "one|block|cube|letter|digit")  # fmt: skip


_WHO = "me|us|you|the_robot|the_viewer|the_camera|the_person|the_operator"
_NEAR_END = Patterns(f"at|on|to the end that_is|which_is? closest|nearest|near|nearer|close|next to? {_WHO}")
_FAR_END = Patterns(f"at|on|to the end that_is|which_is? farthest|furthest|far|farther away? from {_WHO}")
"""The ends of a column."""


@rule
def line_end(p: Parser, i: int) -> Results[Meaning]:
    """ "To the end", "at the beginning of the row": behind all others, or before them."""
    if into := p.any_of(i, _INTO):
        index = -1 if p.one(into, "last") else p.lex(into, lexicon.ORDINAL)
        if index and (j := p.one(into + 1, _SPOT)):
            yield At(side="first", index=index, span=p.span(i, j)), j
    for side, ends in (("front", _NEAR_END), ("back", _FAR_END)):
        for j in ends.matches(p, i):
            yield At(side=side, span=p.span(i, j)), j
    for index, ends in ((-1, _LAST), (1, _FIRST)):
        for j in list(ends.matches(p, i))[-1:]:
            yield At(side="first", index=index, span=p.span(i, j)), j


@rule
def as_counted(p: Parser, i: int) -> Results[At]:
    """ "the first (one of the row)", "last", "the third": the place that something gets in a line."""
    j = p.opt(i, "the")
    index = -1 if p.one(j, "last") else p.lex(j, lexicon.ORDINAL)
    if index:
        k = max(_OF_IT.matches(p, p.reach(j + 1)), default=j + 1)
        yield At(side="first", index=index, span=p.span(i, k)), k
