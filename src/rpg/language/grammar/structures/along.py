"""Lists that say along which way they go: "from bottom to top brown, orange, yellow"."""

from __future__ import annotations

from rpg.language import lexicon
from rpg.language.grammar.core import Parser, Results, rule
from rpg.language.grammar.places.sides import toward
from rpg.language.grammar.things.lists import listed
from rpg.language.meaning import Meaning, Noun, OrderBy, Toward

_LED = (":", "of", "with", ", with", "there are", "are", "it is", "is", "it has", "you see", "put")


@rule
def listed_along(p: Parser, i: int) -> Results[OrderBy]:
    """Behind a line: "from left to right of purple, gray and red", ": from bottom to top brown, orange, yellow"."""
    for way, j in toward(p, p.opt(i, ":", ",")):
        if not isinstance(way, Toward) or way.first is None:
            continue
        for items, end in listed(p, p.opt(p.any_of(j, _LED) or j, ",")):
            yield OrderBy(by="named", items=items, first=way.first, span=p.span(i, end)), end


def listed_in_turn(p: Parser, k: int) -> Results[OrderBy]:
    """Behind a line: ": red, yellow, green", in that order."""
    for items, end in listed(p, p.opt(k, ":", ",")):
        if not _mere_lots(p, k, end, items):
            yield OrderBy(by="named", items=items, span=p.span(k, end)), end


def listed_again(p: Parser, k: int, many: int) -> Results[OrderBy]:
    """Behind "a row of five": ": red, white, red, white, red". Looks that come again tell an order; others may tell no
    more than what there is."""
    for order, end in listed_in_turn(p, k) if many and p.stands(k, (":", ",")) else ():
        looks = [x.traits for x in order.items if isinstance(x, Noun) and x.traits.colors[1:] == ()]
        if len(set(looks)) < len(looks) == len(order.items) == many:
            yield order, end


def _mere_lots(p: Parser, k: int, end: int, items: tuple[Meaning, ...]) -> bool:
    """ "(a row,) two red and three green", "(five blocks in a row,) two red, three green": of what it is made, in no
    order."""
    looks = {x.traits: x.amount.low for x in items if isinstance(x, Noun) and x.amount is not None}
    if len(items) != len(looks) or "then" in p.words[k:end]:
        return False
    counts = (p.number(n) for n in range(k) if p.stands(n + 1, lexicon.BLOCK))
    return "and" in p.words[k:end] or sum(looks.values()) in counts
