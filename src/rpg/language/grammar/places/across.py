"""A block that lies on two others at once: "across both white blocks", "bridging the two"."""

from __future__ import annotations

from rpg.language.grammar.core import Parser, Results
from rpg.language.grammar.things.nouns import noun_phrase
from rpg.language.meaning import Amount, Coord, Loc, Meaning, Noun, Pronoun

_LEADS = ("across the top of", "across the tops of", "across", "bridging", "spanning", "straddling")
_PAIR = frozenset({"both", "both of them", "them", "the two", "the two of them"})


def across(p: Parser, i: int) -> Results[Loc]:
    """What lies on both of two blocks."""
    j = p.any_of(i, _LEADS)
    for mark, k in noun_phrase(p, j) if j else ():
        if _two(mark):
            yield Loc(rel="on", landmark=mark, mods=("across",), span=p.span(i, k), cost=1), k


def _two(mark: Meaning) -> bool:
    """ "both white blocks", "red and blue", "them"."""
    if isinstance(mark, Pronoun):
        return mark.word in _PAIR
    if isinstance(mark, Coord):
        return mark.op == "and" and len(mark.items) == 2 and all(map(_single, mark.items))
    return isinstance(mark, Noun) and mark.head != "patch" and mark.amount == Amount(2, 2)


def _single(mark: Meaning) -> bool:
    return isinstance(mark, Noun) and mark.head != "patch" and not mark.plural
