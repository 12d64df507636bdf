"""The looks of blocks that were counted, told behind a colon: "a row of four with 2 cm gaps: red, red, blue, blue"."""

from __future__ import annotations

from rpg.language import lexicon
from rpg.language.grammar.clauses.adjuncts import adjuncts
from rpg.language.grammar.core import Parser, Results, rule
from rpg.language.grammar.things.lists import listed
from rpg.language.meaning import Clause, Coord, Noun, Toward, Traits


@rule
def looks_told(p: Parser, i: int) -> Results[Clause]:
    """A list of colours and no more, with the direction in which it is read."""
    if p.lex(i, lexicon.COLOR) is None:
        return
    for items, j in listed(p, i):
        if not all(
            isinstance(x, Noun) and x.head == "any" and x.traits == Traits(colors=x.traits.colors) for x in items
        ):
            continue
        for ways, k in adjuncts(p, j):
            if k >= p.end and all(isinstance(x, Toward) for x in ways):
                whole = Coord(op="and", items=items, span=p.span(i, j))
                yield Clause(verb="be", lemma="listed", theme=whole, adjuncts=ways, mode="goal",
                             span=p.span(i, k), cost=3), k  # fmt: skip
