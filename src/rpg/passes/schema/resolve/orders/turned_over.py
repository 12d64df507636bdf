"""What comes of turning a line round, so that nothing more is asked for by it."""

from __future__ import annotations

from rpg.language.meaning import At, Chain, Clause, Meaning, Noun, That, Traits

_OTHER = {"top": "bottom", "bottom": "top", "left": "right", "right": "left"}


def comes_of_reversing(that: That) -> bool:
    """ "(Reverse the tower) so that the bottom cube ends up on top": the block that is at one end at the start is at
    the other one then."""
    told = that.clauses.clauses if that.kind == "so" and isinstance(that.clauses, Chain) else ()
    return bool(told) and all(map(_at_the_other_end, told))


def _at_the_other_end(clause: Meaning) -> bool:
    if not isinstance(clause, Clause) or clause.negated or len(clause.adjuncts) != 1:
        return False
    theme, place = clause.theme, clause.adjuncts[0]
    if not isinstance(theme, Noun) or theme.plural or theme.head == "patch" or not isinstance(place, At):
        return False
    rank = theme.traits.rank or ""
    if theme.traits != Traits(rank=rank):
        return False
    if place.side == "first":
        return (rank, place.index) in (("1", -1), ("last", 1))
    return place.index is None and _OTHER.get(rank) == place.side
