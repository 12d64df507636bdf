"""What comes about by an arrangement: "so that a true equation is obtained", "so that the word CAT can be read"."""

from __future__ import annotations

from rpg.language.grammar.core import Parser, Results
from rpg.language.grammar.talk.slots import Patterns
from rpg.language.grammar.things.nouns import simple
from rpg.language.meaning import Into, Structure

_SO_THAT = Patterns(",? so_that|such_that|in_such_a_way_that")
_ARISES = Patterns(
    "is|are|gets formed|obtained|produced|created|made|spelled|shown|displayed|completed",
    "results|arises|emerges|comes_about|appears",
    "can_be|is|becomes read|seen|made_out|legible|readable",
)


def arising(p: Parser, i: int) -> Results[Into]:
    """The structure that blocks are put into, told as what there is then."""
    for j in _SO_THAT.matches(p, i):
        for shape, k in simple(p, j):
            ends = _ARISES.matches(p, k) if isinstance(shape, Structure) and shape.members is None else ()
            yield from ((Into(structure=shape, span=p.span(i, end)), end) for end in ends)
