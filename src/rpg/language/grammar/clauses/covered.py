""" "Cover the red block with the blue one", "build from four blue cubes a tower": what it is about is named last."""

from __future__ import annotations

from rpg.language.grammar.core import Parser, Results, rule
from rpg.language.grammar.things.nouns import noun_phrase, simple
from rpg.language.meaning import Clause, Loc, Meaning, Noun, Pronoun, Structure, Using, replace

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


def named_last(p: Parser, i: int, k: int, found: tuple[Meaning, ...], lemma: str) -> Results[Clause]:
    """ "build from four blue cubes a tower": behind what is used for it."""
    for shape, end in noun_phrase(p, k) if len(found) == 1 and isinstance(found[0], Using) else ():
        if isinstance(shape, Structure) and shape.members is None and shape.det in ("a", "bare"):
            word = p.span(i, i + 1)
            yield Clause(verb="build", lemma=lemma, theme=shape, adjuncts=found, span=p.span(i, end), word=word), end
