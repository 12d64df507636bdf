"""What the colours of all the blocks have in common, told behind a comma: "..., all of different colours"."""

from __future__ import annotations

from collections.abc import Iterator

from rpg.language.grammar.core import Parser
from rpg.language.grammar.talk.slots import Patterns
from rpg.language.meaning import Manner

_ALL = "all|each|every_one|all_of_them|each_of_them|the_blocks|all_blocks"
_DIFFERENT = Patterns(
    f"and? {_ALL} being|are|must_be|should_be|have|having|must_have|should_have? of|in|with? different|distinct colors",
    f"and? {_ALL} being|is|must_be|should_be|has|having|must_have|should_have? of|in|with? a different|another color",
    f"and? {_ALL} being|is|are|must_be|should_be? differently colored",
    "and? no two of_them|of_the_blocks|blocks|cubes? of|in|with|have|having|are|being|sharing|may_have|should_have? "
    "the? same color",
)
_SAME = Patterns(
    f"and? {_ALL} being|are|must_be|should_be|have|having|must_have? of|in|with? the|one same|single? color",
    f"and? {_ALL} being|are|must_be|should_be? equally|identically colored",
)


def colors_told(p: Parser, i: int) -> Iterator[tuple[Manner, int]]:
    """That they differ, or agree."""
    j = p.one(i, ",")
    for patterns, value in ((_DIFFERENT, "different"), (_SAME, "same")) if j else ():
        for k in patterns.matches(p, j):
            if k >= p.end or p.stands(k, _ENDS):
                yield Manner(kind="colors", value=value, span=p.span(i, k), cost=2), k


_ENDS = frozenset({",", ";", "."})
