""" "Cover the red block with the blue one", "top both towers with an A each": what goes on top is named last."""

from __future__ import annotations

from rpg.language.grammar.core import Parser, Results, rule
from rpg.language.grammar.things.nouns import simple
from rpg.language.meaning import Clause, Loc, Noun, Pronoun, Structure, replace

_COVER = frozenset({"cover", "crown", "cap", "load", "top"})


@rule
def covered(p: Parser, i: int) -> Results[Clause]:
    """Something is covered with a block."""
    j = p.one(i, _COVER)
    for under, k in simple(p, j) if j else ():
        lead = p.one(k, "with")
        for over, end in simple(p, lead) if lead and isinstance(under, Noun | Pronoun | Structure) else ():
            each = p.one(end, "each") if isinstance(under, Noun) and under.plural else 0
            if isinstance(over, Noun) and over.head != "patch":
                if each and isinstance(under, Noun):
                    whole = replace(under, det="the") if under.det == "both" else under
                    under, end = Noun(head="any", det="each", plural=True, part_of=whole, span=under.span), each
                on = Loc(rel="on", landmark=under, span=p.span(i, k))
                word = p.span(i, j)
                yield Clause(verb="place", lemma="put", theme=over, adjuncts=(on,), span=p.span(i, end), word=word), end
