"""Notes that give an order first: "reverse alphabetical: K, L and M in a row", "biggest number first: 3, 8, 5"."""

from __future__ import annotations

from rpg.language.grammar.clauses.adjuncts import adjuncts
from rpg.language.grammar.core import Parser, Results, rule
from rpg.language.grammar.structures.orders import order
from rpg.language.grammar.things.nouns import noun_phrase
from rpg.language.meaning import Clause, Meaning, OrderBy, Toward

_SORTING = frozenset({
    "reverse", "reversed", "alphabetical", "alphabetic", "backwards", "backward", "numerical", "numeric", "descending",
    "ascending", "abc", "count", "counting", "biggest", "largest", "highest", "smallest", "lowest", "greatest",
})  # fmt: skip
"""What such a note begins with."""


@rule
def ordered(p: Parser, i: int) -> Results[Meaning]:
    """ "reverse alphabetical order for A, B and C in a row", "count down from 5 to 1"."""
    if not p.stands(i, _SORTING):
        return
    for found, j in ((x, p.opt(k, "order")) for x, k in order(p, i) if isinstance(x, OrderBy)):
        if found.by == "run":
            for more, end in adjuncts(p, j):
                yield Clause(verb="arrange", adjuncts=(found, *more), span=p.span(i, end), cost=1), end
        for more, k in adjuncts(p, p.opt(j, ",")) if found.by != "run" else ():
            plain = more and all(isinstance(x, OrderBy | Toward) and not getattr(x, "items", ()) for x in more)
            colon = p.any_of(p.opt(k, ","), (":", "for", "of", "with")) if plain else 0
            for theme, end in noun_phrase(p, colon) if colon else ():
                said = Clause(verb="arrange", theme=theme, adjuncts=(found, *more), span=p.span(i, end), cost=1)
                yield said, end
        lead = p.any_of(j, ("for", "of", "with", ":", "with the", "for the", "of the", ",")) if found.by != "run" else 0
        for theme, k in noun_phrase(p, lead) if lead else ():
            for more, end in (*adjuncts(p, k), *(adjuncts(p, k + 1) if p.stands(k, (",",)) else ())):
                said = Clause(verb="arrange", theme=theme, adjuncts=(found, *more), span=p.span(i, end), cost=1)
                yield said, end
