"""What is between the two ends of a line that were told before it: "blue at the bottom, orange on top, green and yellow
in between"."""

from __future__ import annotations

from rpg.language.grammar.core import Parser, Results
from rpg.language.grammar.things.nouns import noun_phrase
from rpg.language.meaning import Absolute, At, Coord, Meaning, Noun

_OPPOSITE = frozenset(map(frozenset, (("left", "right"), ("top", "bottom"), ("front", "back"))))
_BETWEEN = ("in between", "between them", "in between them", "between", "between these", "between the two")
_CLOSED = ("", ",", ";", ".", "and")


def amid(p: Parser, i: int, had: tuple[Meaning, ...]) -> Results[Absolute]:
    """Several looks that are in the middle; one by itself may be a block between two others of any line."""
    places = [part.adjuncts[0] for part in had[-2:] if isinstance(part, Absolute)]
    if frozenset(place.side for place in places if isinstance(place, At)) not in _OPPOSITE:
        return
    for theme, k in noun_phrase(p, i):
        end = p.any_of(p.opt(k, "is", "are"), _BETWEEN) if several(theme) else 0
        if end and p.words[end] in _CLOSED:
            yield Absolute(theme=theme, adjuncts=(At(side="middle", span=p.span(k, end)),), span=p.span(i, end)), end


def several(theme: Meaning) -> bool:
    """Several looks without a number."""
    return len(theme.traits.colors + theme.traits.labels) > 1 if isinstance(theme, Noun) else isinstance(theme, Coord)
