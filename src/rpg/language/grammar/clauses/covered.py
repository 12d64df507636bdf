""" "Cover the red block with the blue one", "crown the tower with an A": what goes on top is named last."""

from __future__ import annotations

from rpg.language.grammar.core import Parser, Results, rule
from rpg.language.grammar.things.nouns import simple
from rpg.language.meaning import Clause, Loc, Noun, Pronoun, Structure

_COVER = frozenset({"cover", "crown", "cap", "load"})


@rule
def covered(p: Parser, i: int) -> Results[Clause]:
    """Something is covered with a block."""
    j = p.one(i, _COVER)
    for under, k in simple(p, j) if j else ():
        lead = p.one(k, "with")
        for over, end in simple(p, lead) if lead and isinstance(under, Noun | Pronoun | Structure) else ():
            if isinstance(over, Noun) and over.head != "patch":
                on = Loc(rel="on", landmark=under, span=p.span(i, k))
                word = p.span(i, j)
                yield Clause(verb="place", lemma="put", theme=over, adjuncts=(on,), span=p.span(i, end), word=word), end
