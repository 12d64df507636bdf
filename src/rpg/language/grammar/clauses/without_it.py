""" "... without them touching", "without red at the bottom", "without anything between them": what is not so."""

from __future__ import annotations

from rpg.language.grammar.core import Parser, Results, choice
from rpg.language.grammar.places.relations import loc
from rpg.language.grammar.places.sides import at
from rpg.language.grammar.things.nouns import noun_phrase
from rpg.language.meaning import At, Chain, Clause, Coord, In, Loc, Meaning, Noun, Pronoun, That, replace

_WITHOUT = ("without", "but without", "and without")
_BEING = ("being", "standing", "lying", "sitting", "ending up", "resting")
_THEY = frozenset({"them", "it", "they", "both", "either", "these", "those"})


@choice
def without_it(p: Parser, i: int) -> Results[That]:
    j = p.any_of(p.opt(i, ","), _WITHOUT)
    for theme, k in noun_phrase(p, j) if j else ():
        nothing = _nothing(theme)
        if nothing is None and not _known(theme):
            continue
        start = p.any_of(k, _BEING) or k
        for place, end in (*loc(p, start), *at(p, start)):
            if isinstance(place, Loc | In | At) and not getattr(place, "negated", False):
                span = p.span(i, end)
                what, denied = nothing or theme, nothing is None
                said = Clause(verb="be", theme=what, adjuncts=(place,), negated=denied, mode="goal", span=span)
                yield That(kind="so", clauses=Chain(clauses=(said,), links=("and",), span=span), span=span), end


def _nothing(theme: Meaning) -> Meaning | None:
    """ "(without) anything (on it)", "(without) any block": nothing, and no block."""
    if isinstance(theme, Pronoun):
        return replace(theme, word="nothing") if theme.word == "anything" else None
    any_ = isinstance(theme, Noun) and theme.det == "any" and theme.head == "block" and theme.part_of is None
    return replace(theme, det="no", amount=None) if any_ and isinstance(theme, Noun) else None


def _known(theme: Meaning) -> bool:
    """What was spoken of, or is named."""
    if isinstance(theme, Coord):
        return theme.op == "and" and all(map(_known, theme.items))
    if isinstance(theme, Pronoun):
        return theme.word in _THEY
    named = isinstance(theme, Noun) and theme.head != "patch" and bool(theme.traits.colors or theme.traits.labels)
    two = isinstance(theme, Noun) and theme.det == "the" and theme.head in ("any", "block") and theme.amount is not None
    return (named and isinstance(theme, Noun) and theme.det in ("the", "bare")) or two
