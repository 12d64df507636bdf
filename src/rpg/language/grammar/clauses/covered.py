""" "Cover the red block with the blue one", "build from four blue cubes a tower": what it is about is named last."""

from __future__ import annotations

from rpg.language.grammar.clauses.emptied import emptied
from rpg.language.grammar.core import Parser, Results, rule
from rpg.language.grammar.things.nouns import noun_phrase, simple
from rpg.language.meaning import Amount, Clause, Loc, Meaning, Noun, Pronoun, Structure, Using, replace

_COVER = frozenset({"cover", "crown", "cap", "load", "top"})
_ALONE = frozenset({"cover"})
"""Behind this it need not be said with what."""
_BARE = frozenset({"uncover", "unload"})


_FILL = frozenset({"fill", "occupy"})
"""Of patches with one block each: how many fill one is not said."""


@rule
def covered(p: Parser, i: int) -> Results[Clause]:
    """Something is covered with a block."""
    j = p.one(i, _COVER) or p.one(i, _FILL)
    yield from (*_with_anything(p, i), *emptied(p, i))
    for under, k in simple(p, j) if j else ():
        lead = p.one(k, "with")
        for over, end in simple(p, lead) if lead and isinstance(under, Noun | Pronoun | Structure) else ():
            if p.words[i] in _FILL and not _one_there(under, over):
                continue
            each = p.one(end, "each") if isinstance(under, Noun) and under.plural else 0
            if isinstance(over, Noun) and over.head != "patch":
                if each and isinstance(under, Noun):
                    whole = replace(under, det="the") if under.det == "both" else under
                    under, end = Noun(head="any", det="each", plural=True, part_of=whole, span=under.span), each
                on = Loc(rel="on", landmark=under, span=p.span(i, k))
                word = p.span(i, j)
                yield Clause(verb="place", lemma="put", theme=over, adjuncts=(on,), span=p.span(i, end), word=word), end


def _with_anything(p: Parser, i: int) -> Results[Clause]:
    """ "Cover the red block": some block goes on it. "Uncover the red block": the block that is on it is taken off."""
    j = p.one(i, _ALONE) or p.one(i, _BARE)
    for under, k in simple(p, j) if j else ():
        single = isinstance(under, Noun) and under.head != "patch" and not under.plural and under.det in ("the", "a")
        if single and (k >= p.end or p.stands(k, _CLOSED)):
            block = Noun(head="block", det="a", amount=Amount(1, 1), span=p.span(i, j))
            over = p.words[i] in _ALONE
            place = Loc(rel="on" if over else "off", landmark=under, span=p.span(i, k))
            verb, lemma = ("place", "put") if over else ("use", "take")
            span, word = p.span(i, k), p.span(i, j)
            yield Clause(verb=verb, lemma=lemma, theme=block, adjuncts=(place,), span=span, word=word), k


def _one_there(under: Meaning, over: Meaning) -> bool:
    patch = isinstance(under, Noun) and under.head == "patch"
    return patch and isinstance(over, Noun) and over.amount == Amount(1, 1)


_CLOSED = frozenset({",", ";", "and", "then", "."})


def named_last(p: Parser, i: int, k: int, found: tuple[Meaning, ...], lemma: str) -> Results[Clause]:
    """ "build from four blue cubes a tower": behind what is used for it."""
    for shape, end in noun_phrase(p, k) if len(found) == 1 and isinstance(found[0], Using) else ():
        if isinstance(shape, Structure) and shape.members is None and shape.det in ("a", "bare"):
            word = p.span(i, i + 1)
            yield Clause(verb="build", lemma=lemma, theme=shape, adjuncts=found, span=p.span(i, end), word=word), end
