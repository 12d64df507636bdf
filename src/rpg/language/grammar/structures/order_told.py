"""An order that is called one: "the order from left to right should be green, yellow, then the two pinks"."""

from __future__ import annotations

from rpg.language.grammar.core import Parser, Results, rule
from rpg.language.grammar.places.sides import toward
from rpg.language.grammar.talk.slots import Patterns
from rpg.language.grammar.things.lists import listed
from rpg.language.meaning import Clause, Meaning, OrderBy, Toward

_ORDER = Patterns(
    "the|my? final|desired|required|wanted|right|correct|new? color? order|sequence|arrangement "
    "of_the_blocks|of_the_cubes|of_the_colors|of_colors|of_blocks?",
)
_IS = Patterns("is|are|being|reads|goes|should_be|must_be|shall_be|will_be|has_to_be|needs_to_be :?", ":|,")


@rule
def order_told(p: Parser, i: int) -> Results[Clause]:
    """Which blocks come one after the other, from where on."""
    for j in _ORDER.matches(p, i):
        for way, k in toward(p, p.opt(j, ",")):
            for told in sorted(_IS.matches(p, k)) if isinstance(way, Toward) and way.first else ():
                for items, end in listed(p, told):
                    yield _laid(p, i, end, way, items), end
        for told in sorted(_IS.matches(p, j)):
            for items, k in listed(p, told):
                for way, end in ((w, e) for w, e in toward(p, p.opt(k, ",")) if isinstance(w, Toward) and w.first):
                    yield _laid(p, i, end, way, items), end


def _laid(p: Parser, i: int, end: int, way: Meaning, items: tuple[Meaning, ...]) -> Clause:
    given = OrderBy(by="given", items=items, span=p.span(i, end))
    return Clause(verb="arrange", adjuncts=(way, given), mode="goal", span=p.span(i, end), cost=1)
