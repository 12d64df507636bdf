"""So many of several: "two of the four red blocks", "none of them", "each of the towers", "of the four, two ..."."""

from __future__ import annotations

from typing import TYPE_CHECKING

from rpg.language.grammar.core import Parser, Results
from rpg.language.grammar.things import amounts
from rpg.language.grammar.things.amounts import Quantity
from rpg.language.grammar.things.joined import more
from rpg.language.grammar.things.of_both import counted_kinds
from rpg.language.grammar.things.of_listed import wholes
from rpg.language.later import later
from rpg.language.meaning import Coord, Meaning, Noun, Pronoun, Structure, replace

if TYPE_CHECKING:
    from rpg.language.grammar.things.nouns import simple
else:
    (simple,) = later(__name__, "rpg.language.grammar.things.nouns", "simple")

_EVERY_ONE = frozenset({"each", "all", "both"})
_THESE = ("them", "these", "those", "the others", "the rest", "others")


def partitive(p: Parser, i: int, j: int, found: Quantity) -> Results[Meaning]:
    """ "two of the four red blocks", "none of them"."""
    for whole, end in wholes(p, j, found.det):
        if isinstance(whole, Noun) and whole.head == "any" and whole.det == "the" and found.det in ("all", "no"):
            whole = replace(whole, plural=whole.plural or bool(whole.traits.colors))
        if isinstance(whole, Noun) and found.det == "not all" and whole.det == "bare":
            whole = replace(whole, det="the", plural=True)  # "not all red blocks", "not every red block"
        known = isinstance(whole, Noun) and whole.det in ("the", "bare", "its", "other", "all")
        if isinstance(whole, Noun) and known and (whole.plural or whole.amount):
            plain = whole.det == "bare" and whole.amount is None
            if plain and found.det != "some":
                continue
            if found.det == "all" and whole.det == "the" and whole.amount is not None and whole.part_of is None:
                yield replace(whole, det="all", span=p.span(i, end)), end
                continue
            span = p.span(i, end)
            part = Noun(head=whole.head, det=found.det, amount=found.amount, plural=True, part_of=whole, span=span)
            yield part, end
            for both, k in more(p, j, (whole,), end, None) if whole.det == "the" else ():
                if counted_kinds(both, found.det):
                    yield replace(part, part_of=both, span=p.span(i, k)), k
        elif isinstance(whole, Structure) and whole.det == "the" and whole.plural and found.det in _EVERY_ONE:
            yield replace(whole, det=found.det, amount=found.amount or whole.amount, span=p.span(i, end)), end
        elif _whole_of(whole):
            span = p.span(i, end)
            yield Noun(head="any", det=found.det, amount=found.amount, plural=True, part_of=whole, span=span), end


def _whole_of(whole: Meaning) -> bool:
    """ "(Two of) these", "of the towers", and of what is listed."""
    if isinstance(whole, Structure):
        return whole.det == "the" and whole.plural
    return isinstance(whole, Coord) or (isinstance(whole, Pronoun) and whole.word in _THESE)


def of_these(p: Parser, i: int, of: int) -> Results[Meaning]:
    """ "of the four red blocks, two ..."."""
    for whole, j in simple(p, of):
        if isinstance(whole, Noun) and (whole.plural or whole.amount):
            for found, k in amounts.amount(p, p.opt(j, ",")):
                yield Noun(head=whole.head, det="some", amount=found, plural=True, part_of=whole, span=p.span(i, k)), k
