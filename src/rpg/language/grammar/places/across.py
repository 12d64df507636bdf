"""A block that lies on two or four others at once: "across both white blocks", "bridging the two", "on all four",
"centred on top of them"."""

from __future__ import annotations

from rpg.language.grammar.core import Parser, Results
from rpg.language.grammar.things.nouns import noun_phrase
from rpg.language.meaning import Amount, Coord, Loc, Meaning, Noun, Pronoun, Traits

_LEADS = ("across the top of", "across the tops of", "across", "bridging", "spanning", "straddling")
_PAIR = frozenset({"both", "both of them", "them", "the two", "the two of them"})
_CENTERED = tuple(
    f"{centered} {on}"
    for centered in ("centered", "centrally", "placed centrally", "in the center", "in the middle",
                     "exactly in the middle")
    for on in ("on", "on top of", "over", "upon", "atop")
)  # fmt: skip
_ON = ("on", "on top of", "upon", "atop", "over")
_ALL_FOUR = ("all four of them", "all four of these", "all four", "all the four", "all of the four")
_THE_FOUR = (*_ALL_FOUR, "the four", "the four of them", "these four", "those four", "them")


def across(p: Parser, i: int) -> Results[Loc]:
    """What lies on both of two blocks, or on all of four."""
    j = p.any_of(i, _LEADS) or p.any_of(i, _CENTERED)
    for mark, k in noun_phrase(p, j) if j else ():
        if _two(mark) or _four(mark):
            yield _over(p, i, k, mark), k
    on = 0 if j else p.any_of(i, _ON)
    for mark, k in noun_phrase(p, on) if on and p.stands(on, ("all",)) else ():
        if _four(mark):
            yield _over(p, i, k, mark), k
    begin = j or on
    if k := p.any_of(begin, _THE_FOUR if j else _ALL_FOUR) if begin else 0:
        yield _over(p, i, k, Pronoun(word="them", span=p.span(begin, k))), k


def _over(p: Parser, i: int, k: int, mark: Meaning) -> Loc:
    return Loc(rel="on", landmark=mark, mods=("across",), span=p.span(i, k), cost=1)


def _four(mark: Meaning) -> bool:
    """ "(all) four blue blocks"."""
    told = isinstance(mark, Noun) and (mark.head == "block" or mark.traits != Traits())
    return told and isinstance(mark, Noun) and mark.head != "patch" and mark.amount == Amount(4, 4)


def _two(mark: Meaning) -> bool:
    """ "both white blocks", "red and blue", "them"."""
    if isinstance(mark, Pronoun):
        return mark.word in _PAIR
    if isinstance(mark, Coord):
        return mark.op == "and" and len(mark.items) == 2 and all(map(_single, mark.items))
    return isinstance(mark, Noun) and mark.head != "patch" and mark.amount == Amount(2, 2)


def _single(mark: Meaning) -> bool:
    return isinstance(mark, Noun) and mark.head != "patch" and not mark.plural
