"""Figures told by their corners: "three blocks at the corners of a triangle", one at each."""

from __future__ import annotations

from rpg.language.grammar.core import Parser, Results, choice
from rpg.language.grammar.things.nouns import simple
from rpg.language.meaning import Amount, Into, Size, Structure, replace

_AT = tuple(
    f"{at} the {many}{corners} of"
    for at in ("at", "on", "in")
    for many in ("", "three ", "four ")
    for corners in ("corners", "vertices")
)
_CORNERS = {"triangle": 3, "square": 4, "rectangle": 4}


@choice
def at_corners(p: Parser, i: int) -> Results[Into]:
    """The outline with as many blocks as it has corners."""
    j = p.any_of(i, _AT)
    for target, k in simple(p, j) if j else ():
        many = _CORNERS.get(target.kind, 0) if isinstance(target, Structure) and target.members is None else 0
        if many and isinstance(target, Structure) and not (target.plural or target.sizes):
            size = Size(what="corners", amount=Amount(many, many), span=p.span(i, k))
            yield Into(structure=replace(target, sizes=(size,)), span=p.span(i, k)), k
