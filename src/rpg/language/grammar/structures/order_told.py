"""An order that is called one: "the order from left to right should be green, yellow, then the two pinks"."""

from __future__ import annotations

from rpg.language.grammar.core import Parser, Results, rule
from rpg.language.grammar.places.sides import toward
from rpg.language.grammar.talk.slots import Patterns
from rpg.language.grammar.things.lists import listed
from rpg.language.meaning import Amount, Clause, Meaning, OrderBy, Structure, Toward, replace

_CALLED = (
    "the|my? final|desired|required|wanted|right|correct|new? color? order|sequence|arrangement "
    "of_the_blocks|of_the_cubes|of_the_colors|of_colors|of_blocks|of_the_letters|of_letters?"
)
_ORDER = Patterns(_CALLED)
_INSIDE = Patterns(f"{_CALLED} in|of|for the|a|one|this|that|my?")
"""What stands before the line that has the order."""
_COLORS = Patterns("the|its|their block|cube? colors")
_IS = Patterns("is|are|being|reads|goes|should_be|must_be|shall_be|will_be|has_to_be|needs_to_be :?", ":|,")
_IN_THIS = Patterns(",? in this|that|exactly_this|exactly_that|the_given|the_same|precisely_this order|sequence")
_IN_A = Patterns("in|as a|one|the|a_single")
_LINES = {"tower": "stack", "stack": "stack", "row": "row", "line": "line", "column": "column", "pile": "stack"}


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
                yield from _in_a_line(p, i, k, items)
    yield from _of_a_line(p, i)
    for j in _COLORS.matches(p, i):
        for told in sorted(_IS.matches(p, j)):
            for items, k in listed(p, told):
                yield from ((_told(p, i, end, items), end) for end in _IN_THIS.matches(p, k))


def _of_a_line(p: Parser, i: int) -> Results[Clause]:
    """ "The order in the tower should be red, green, blue (from bottom to top)"."""
    for j in _INSIDE.matches(p, i):
        if (kind := p.lex(j, _LINES)) is None:
            continue
        for told in sorted(_IS.matches(p, j + 1)):
            for items, k in listed(p, told):
                yield _built(p, i, k, kind, items), k
                for way, end in ((w, e) for w, e in toward(p, p.opt(k, ",")) if isinstance(w, Toward) and w.first):
                    built = _built(p, i, end, kind, items)
                    yield replace(built, adjuncts=(way, *built.adjuncts)), end


def _in_a_line(p: Parser, i: int, k: int, items: tuple[Meaning, ...]) -> Results[Clause]:
    """ "The order should be red, green, blue", of the line that was built, or "in one tower"."""
    if len(items) > 1:
        yield _told(p, i, k, items), k
    for j in _IN_A.matches(p, p.opt(k, ",")):
        if kind := p.lex(j, _LINES):
            yield _built(p, i, j + 1, kind, items), j + 1


def _told(p: Parser, i: int, end: int, items: tuple[Meaning, ...]) -> Clause:
    given = OrderBy(by="given", items=items, span=p.span(i, end))
    return Clause(verb="part", adjuncts=(given,), mode="goal", span=p.span(i, end), cost=1)


def _built(p: Parser, i: int, end: int, kind: str, items: tuple[Meaning, ...]) -> Clause:
    given = OrderBy(by="given", items=items, span=p.span(i, end))
    line = Structure(kind=kind, amount=Amount(1, 1), span=p.span(i, end))
    return Clause(verb="build", theme=line, adjuncts=(given,), mode="goal", span=p.span(i, end), cost=1)


def _laid(p: Parser, i: int, end: int, way: Meaning, items: tuple[Meaning, ...]) -> Clause:
    given = OrderBy(by="given", items=items, span=p.span(i, end))
    return Clause(verb="arrange", adjuncts=(way, given), mode="goal", span=p.span(i, end), cost=1)
