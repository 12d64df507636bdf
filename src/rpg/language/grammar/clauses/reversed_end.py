""" "(End with) the reverse": what was told before, the other way round."""

from __future__ import annotations

from rpg.language.grammar.core import Parser, Results, rule
from rpg.language.grammar.talk.slots import Patterns
from rpg.language.meaning import Clause, Pronoun

_ENDED = frozenset({"with", "as", "be", "is", ":", "up", "finally"})
"""What stands before how it ends."""
_SAME = ("the same tower|stack|row|line|column|blocks|cubes|ones|order|two|three|four|five|six blocks|cubes|ones? ,? "
         "just|but|only|simply?")  # fmt: skip
_REVERSE = Patterns(
    f"{_SAME} in|with the? reversed|reverse|opposite|inverse order",
    f"{_SAME} with_the_order|with_its_order reversed|inverted|flipped|the_other_way_round|the_other_way_around",
    f"{_SAME} the_other_way_round|the_other_way_around|reversed|backwards",
    "the|its|their exact? reverse|opposite|inverse order|sequence?",
    "the reversed|opposite order|sequence|tower|stack|row|line",
    "the|its|their reverse|opposite of_it|of_that|of_this|of_them?",
    "in? reverse|reversed|opposite order?",
    "the order reversed", "everything|all reversed",
)  # fmt: skip
"""What something is the other way round."""
_LINES = ("tower", "stack", "row", "line", "column")
_OF_LINE = "|".join(f"of_{the}_{line}" for the in ("the", "this") for line in _LINES)
_ORDER = f"the|its|their order of_it|of_them|of_the_blocks|of_the_cubes|{_OF_LINE}?"
_TURNED = "reversed|inverted|flipped|the_other_way_round|the_other_way_around"
_ORDER_IS = Patterns(
    f"{_ORDER} should|must|shall|has_to|needs_to be {_TURNED}",
    f"{_ORDER} is to_be {_TURNED}",
    f"{_ORDER} is {_TURNED}",
)  # fmt: skip


@rule
def reverse_of_it(p: Parser, i: int) -> Results[Clause]:
    """ "The reverse (order)", behind "end with"; "the order should be reversed"."""
    told = list(_ORDER_IS.matches(p, i))
    for j in [*told, *_REVERSE.matches(p, i)] if told or p.follows(i, _ENDED) else ():
        if j >= p.end:
            it = Pronoun(word="it", span=p.span(i, j))
            yield Clause(verb="reverse", lemma="reverse", theme=it, span=p.span(i, j), word=p.span(i, j)), j
