"""How far a relation to a side goes: "by at least 8 cm", or "no matter how far back", or which one is nearer."""

from __future__ import annotations

from rpg.language.grammar.core import Parser, Results
from rpg.language.grammar.places.measures import bounds
from rpg.language.grammar.talk.slots import Patterns
from rpg.language.meaning import Loc, replace

_SIDES = ("left", "right", "front", "behind")
_LEAD = ",? no_matter|regardless_of|irrespective_of|it_does_not_matter|does_not_matter|i_do_not_care|i_do_not_mind"
_WHO = "it|they|any_of_them|each_of_them|either_of_them|one_of_them|these|the_blocks|the_cubes|either|both"
_IS = "is|are|stands|stand|lies|lie|sits|sit|may_be|might_be|end_up|ends_up"
_DEPTHS = "forward|back|backward|forwards|backwards|forward_or_back|back_or_forward|forward_or_backward|" \
          "forwards_or_backwards|near_or_far|away_from_me|to_the_front_or_back|in_front_or_behind"  # fmt: skip
_WIDTHS = "left|right|left_or_right|right_or_left|to_the_left_or_right|to_the_right_or_left|to_the_side|sideways"
_NEARER = "nearer|closer|farther|further|farther_away|further_away|in_front|behind|farther_back|further_back|nearest"
_LEFTER = (
    "to_the_left|to_the_right|on_the_left|on_the_right|farther_left|further_left|farther_right|further_right|left|right"
)
_ACROSS = {
    sides: Patterns(
        f"{_LEAD} how far|much {where}",
        f"{_LEAD} how far|much {where} {_WHO} {_IS}",
        f",? however far {where}",
        f",? however far {where} {_WHO} {_IS}",
        f"{_LEAD} which one|block|cube|of_them|of_the_two|of_these? {_IS} {which} to_me|to_us|to_the_robot?",
    )
    for sides, where, which in ((("left", "right"), _DEPTHS, _NEARER), (("front", "behind"), _WIDTHS, _LEFTER))
}
"""What leaves open how far something is to the other sides of it."""


def how_far(p: Parser, i: int, j: int, placed: Loc) -> Results[Loc]:
    """A relation to a side at i..j, with how far it goes; nothing where that is not told."""
    comma = p.opt(j, ",")
    by = p.opt(comma, "by") if placed.rel in _SIDES and p.stands(j, (",", "by")) else 0
    for (low, high), k in bounds(p, by) if by else ():
        if by > comma or k >= p.end or p.stands(k, (",", ";", "and")):
            yield replace(placed, low=low, high=high, span=p.span(i, k)), k
    for sides, told in _ACROSS.items() if placed.mods in ((), ("somewhere",)) else ():
        for k in told.matches(p, j) if placed.rel in sides else ():
            yield replace(placed, mods=("somewhere",), span=p.span(i, k)), k
