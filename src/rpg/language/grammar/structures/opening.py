"""Where a figure is open, told behind it: "five blocks in a V, and it opens towards the back"."""

from __future__ import annotations

from rpg.language.grammar.clauses.pointing import whither
from rpg.language.grammar.core import Parser, Results
from rpg.language.grammar.talk.slots import Patterns
from rpg.language.meaning import Manner

_TO = "to|towards|toward|on|at|up_to|up_towards"
_OPENS = Patterns(
    f"it|which opens|opening|is_opening {_TO}?",
    f"it|which is|must_be|should_be|has_to_be|lies open {_TO}",
    f"it must|should|shall|has_to|is_to open {_TO}?",
)
_OPEN_SIDE = Patterns(f"the open|opened side|end is|lies|faces|must_be|should_be|points {_TO}?")


def opens(p: Parser, i: int) -> Results[Manner]:
    """In a clause of its own."""
    for j in (*_OPENS.matches(p, i), *_OPEN_SIDE.matches(p, i)):
        for side, end in whither(p, j):
            yield Manner(kind="pointing:opening", value=side, span=p.span(i, end)), end
