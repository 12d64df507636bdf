"""How wide something must not be: "(the gap) should not be larger than 2 cm", "must not exceed 2 cm"."""

from __future__ import annotations

from rpg.language.grammar.core import Parser, Results
from rpg.language.grammar.places.measures import bounds
from rpg.language.grammar.talk.slots import Patterns
from rpg.language.grammar.things.amounts import length

_MUST = "must|should|shall|may|can|does|do|has_to|ought_to|is_to|will"
_NOT_BE = Patterns(f"{_MUST} not be|measure|become|get")
_EXCEED = Patterns(f"{_MUST} not exceed|go_over|go_beyond")
_FALL_BELOW = Patterns(f"{_MUST} not fall_below|go_below|drop_below|go_under")


def denied_bounds(p: Parser, i: int) -> Results[tuple[float | None, float | None]]:
    """The other way round than what is denied; of a range with two ends nothing is told by denying it."""
    for k in _NOT_BE.matches(p, i):
        for (low, high), end in bounds(p, k):
            if low is None or high is None:
                yield (high, low), end
    for pattern, below in ((_EXCEED, True), (_FALL_BELOW, False)):
        for k in pattern.matches(p, i):
            yield from (((None, metres) if below else (metres, None), end) for metres, end in length(p, k))
