"""Several structures as large as each other: "two rows, the same number of blocks in each", "of the same height"."""

from __future__ import annotations

from rpg.language.grammar.core import Parser, Results, rule
from rpg.language.grammar.talk.slots import Patterns
from rpg.language.meaning import Manner

_LEAD = ",|with|and|having|both|so_that_there_is|such_that_there_is"
_SAME = "the? same|equal|identical number|amount|count of_blocks|of_cubes|of_them|of_bricks?"
_EACH = "each_of_them|each_one|each_row|each_tower|each_column|each_line|each_stack|every_row|every_tower|each|both"
_EQUAL = Patterns(
    f"{_LEAD} {_SAME} in|per|for|on|to {_EACH}",
    f"{_LEAD} with|having? {_SAME} each?",
    f"{_LEAD} in? {_EACH} {_SAME}",
    f"{_LEAD} in? {_EACH} with|having {_SAME}",
    f"{_LEAD} in? each|both equally many blocks|cubes?",
    f"{_LEAD} equally many blocks|cubes? in|per {_EACH}",
    ",|and|both|all? of_the_same|of_equal|the_same|same|equal height|length",
    ",|and both|all? equally|just_as high|tall|long",
    "which|that|both_of_which|and|, both|all|each|should|must|shall|will? have|has|having|be|are the|an? same|equal "
    "height|heights|length|size",
    "which|that are|be|should_be|must_be of the? same|equal height|length|size",
    "that|which both|all? have|are the|of_the|of same|equal|identical height|length",
    "that|which are both|all? equally|just_as high|tall|long",
    "with|having the|an same|equal|identical height|length",
)
_TELLING = frozenset({"same", "equal", "identical", "equally"})


@rule
def as_many_each(p: Parser, i: int) -> Results[Manner]:
    """That they are of the same size, behind what they are."""
    if p.rarely(_TELLING):
        yield from ((Manner(kind="equal", span=p.span(i, j)), j) for j in _EQUAL.matches(p, i))
