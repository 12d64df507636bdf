""" "The odd positions", "every even place": each other place of a line, counted from its beginning."""

from __future__ import annotations

from rpg.language.grammar.core import Parser, Results
from rpg.language.meaning import Places

_ODD = ("odd", "even")
_PLACES = ("positions", "places", "spots", "position", "place", "spot", "slots", "slot")
_NUMBERED = tuple(
    f"{lead}{place}" for lead in ("", "numbered ", "number ", "- numbered ") for place in _PLACES
)  # fmt: skip


def every_other(p: Parser, i: int, j: int) -> Results[Places]:
    """Those with an odd number, or those with an even one."""
    if not p.stands(j, _ODD):
        return
    if end := p.any_of(j + 1, _NUMBERED):
        side = p.words[j]
        yield Places(side=side, unit="block", span=p.span(i, end)), end
