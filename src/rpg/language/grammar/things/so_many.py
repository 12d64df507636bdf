"""How many there are, told of blocks just named: "all orange blocks, of which there shall be three", "red ones, three
in number"."""

from __future__ import annotations

from rpg.language.grammar.core import Parser, Results, choice
from rpg.language.grammar.talk.slots import Patterns
from rpg.language.grammar.things import amounts
from rpg.language.meaning import Amount, Noun, replace

_THERE_ARE = Patterns(",? of which there is|are|shall_be|must_be|should_be|will_be also|again|only|exactly|just?",
                      ",? of which there also|again is|are")  # fmt: skip
_IN_NUMBER = ("in number",)


@choice
def so_many(p: Parser, i: int, j: int, noun: Noun) -> Results[Noun]:
    """The noun from i on, which ends before j, with the number that follows."""
    if not noun.plural or noun.amount is not None:
        return
    ends = [(many, p.any_of(end, ("in all", "in total", "altogether")) or end)
            for k in _THERE_ARE.matches(p, j) for many, end in amounts.amount(p, k)]  # fmt: skip
    if comma := p.one(j, ","):
        ends += [(Amount(n, n), k) for n, end in amounts.count(p, comma) if (k := p.any_of(end, _IN_NUMBER))]
    for many, end in ends:
        told = replace(noun, amount=many, span=p.span(i, end))
        yield from ((told, last) for last in {end: None, p.opt(end, ","): None})
