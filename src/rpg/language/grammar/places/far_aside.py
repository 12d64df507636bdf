"""So far away on one side of something: "10 cm to the left of it", "two block widths behind the red one"."""

from __future__ import annotations

from rpg.language.grammar.core import Parser, Results
from rpg.language.grammar.places.prepositions import relation
from rpg.language.grammar.things.nouns import noun_phrase
from rpg.language.meaning import Loc

_SIDES = frozenset({"left", "right", "front", "behind"})


def to_a_side(p: Parser, i: int, j: int, low: float | None, high: float | None) -> Results[Loc]:
    """ "(10 cm) to the left of it", behind the distance that ends at `j`."""
    for (name, mods), k in relation(p, j):
        for landmark, end in noun_phrase(p, k) if name in _SIDES else ():
            yield Loc(rel=name, landmark=landmark, mods=mods, low=low, high=high, span=p.span(i, end)), end
