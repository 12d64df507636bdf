"""How many there are, told of blocks just named: "all orange blocks, of which there shall be three"."""

from __future__ import annotations

from rpg.language.grammar.core import Parser, Results, choice
from rpg.language.grammar.talk.slots import Patterns
from rpg.language.grammar.things import amounts
from rpg.language.meaning import Noun, replace

_THERE_ARE = Patterns(",? of which there is|are|shall_be|must_be|should_be|will_be")


@choice
def so_many(p: Parser, i: int, j: int, noun: Noun) -> Results[Noun]:
    """The noun from i on, which ends before j, with the number that follows."""
    for k in _THERE_ARE.matches(p, j) if noun.plural and noun.amount is None else ():
        for many, end in amounts.amount(p, k):
            end = p.any_of(end, ("in all", "in total", "altogether")) or end
            told = replace(noun, amount=many, span=p.span(i, end))
            yield from ((told, last) for last in {end: None, p.opt(end, ","): None})
