""" "Between the red and the blue patch, closer to the red one": between them, and nearer to one end."""

from __future__ import annotations

from rpg.language.grammar.core import Parser, Results, choice
from rpg.language.grammar.things.nouns import simple
from rpg.language.meaning import Coord, Loc, Noun

_CLOSER = tuple(
    f"{but}{a_bit}{closer} to"
    for but in (", ", "", "but ", ", but ", "and ", ", and ")
    for a_bit in ("", "a bit ", "a little ", "slightly ")
    for closer in ("closer", "nearer")
)


@choice
def nearer_one(p: Parser, i: int, begin: int, between: Loc) -> Results[Coord]:
    """What stands behind a place between two things."""
    lead = p.any_of(i, _CLOSER)
    for end, j in simple(p, lead) if lead else ():
        if not isinstance(end, Noun) or end.plural or p.stands(j, ("than",)):
            continue
        ends = between.landmark.items if isinstance(between.landmark, Coord) else ()
        others = [x for x in ends if isinstance(x, Noun) and x.traits != end.traits]
        if len(ends) == 2 and len(others) == 1:
            closer = Loc(rel="closer", landmark=end, second=others[0], span=p.span(i, j))
            yield Coord(op="and", items=(between, closer), span=p.span(begin, j)), j
