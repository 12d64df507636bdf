"""Blocks told by the part of the table that they are taken from: "(move) all cubes from the left half (to ...)"."""

from __future__ import annotations

from typing import TYPE_CHECKING

from rpg.language.grammar.core import Parser, Results, choice
from rpg.language.later import later
from rpg.language.meaning import In, Meaning

if TYPE_CHECKING:
    from rpg.language.grammar.places.regions import named_regions
else:
    (named_regions,) = later(__name__, "rpg.language.grammar.places.regions", "named_regions")

_ACROSS = {
    f"the {side} side to the {other} side": side
    for side, other in (("left", "right"), ("right", "left"), ("near", "far"), ("far", "near"))
}
_WAYS = tuple(_ACROSS)
_MOVING = frozenset({"move", "transfer", "bring", "carry", "take", "shift", "push", "haul", "relocate", "slide", "get"})


_LINES = frozenset({"row", "line", "column", "diagonal", "tower", "stack"})


@choice
def out_of_region(p: Parser, i: int) -> Results[tuple[Meaning, ...]]:
    """ "from the left half", "from the left side of the table", and "from the left side" to the other one."""
    j = p.one(i, "from")
    if not j:
        return
    moved = not _MOVING.isdisjoint(p.words[:i])
    for region, k in named_regions(p, p.opt(j, "the")):
        lined = p.stands(k, ("to",)) and not moved and not _LINES.isdisjoint(p.words[:i])
        if lined and not region.endswith("edge"):
            continue  # "a line from the near corner to the far one" goes all that way
        yield (In(region=region, span=p.span(i, k)),), k
    across = p.any_of(j, _WAYS)
    if across and moved:
        side = next(x for told, x in _ACROSS.items() if told.split() == p.words[j:across])
        yield (In(region=f"{side}_half", span=p.span(i, j + 3)),), j + 3
