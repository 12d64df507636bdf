"""Lists that say along which way they go: "from bottom to top brown, orange, yellow"."""

from __future__ import annotations

from rpg.language.grammar.core import Parser, Results, rule
from rpg.language.grammar.places.sides import toward
from rpg.language.grammar.things.lists import listed
from rpg.language.meaning import OrderBy, Toward

_LED = (":", "of", "with", ", with", "there are", "are", "it is", "is", "it has", "you see", "put")


@rule
def listed_along(p: Parser, i: int) -> Results[OrderBy]:
    """Behind a line: "from left to right of purple, gray and red", ": from bottom to top brown, orange, yellow"."""
    for way, j in toward(p, p.opt(i, ":", ",")):
        if not isinstance(way, Toward) or way.first is None:
            continue
        for items, end in listed(p, p.opt(p.any_of(j, _LED) or j, ",")):
            yield OrderBy(by="named", items=items, first=way.first, span=p.span(i, end)), end
