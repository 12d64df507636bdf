"""Several blocks at one end of a line: "the top two blocks (of the tower)", "the first three letters of the row"; the
one at the end of each line: "the top blocks of the two towers"."""

from __future__ import annotations

from typing import TYPE_CHECKING

from rpg.language.grammar.core import Parser, Results
from rpg.language.grammar.talk.slots import Patterns
from rpg.language.grammar.things.in_line import OF_LINE
from rpg.language.later import later
from rpg.language.lexicon import BLOCK
from rpg.language.meaning import Amount, Noun, Structure, Traits, replace

if TYPE_CHECKING:
    from rpg.language.grammar.structures.structures import structure
else:
    (structure,) = later(__name__, "rpg.language.grammar.structures.structures", "structure")

_THE = frozenset({"the", "its", "their"})
_ENDS = {
    "top": "top", "upper": "top", "topmost": "top", "uppermost": "top", "bottom": "bottom", "lower": "bottom",
    "bottommost": "bottom", "lowest": "bottom", "left": "left", "leftmost": "left", "right": "right",
    "rightmost": "right", "first": "1", "last": "last", "front": "front", "back": "back",
    "middle": "middle", "central": "middle", "inner": "middle", "outer": "outer", "outermost": "outer",
}  # fmt: skip
_TIPS = {"tops": "top", "bottoms": "bottom"}
_ONES = frozenset({"ones", *(word for word, several in BLOCK.items() if several), "letters", "digits"})
_BEHIND = frozenset({"off", "on", "onto", "and", "down", "away", "apart", "to", "must", "should", "are", "next", "in",
                     "into", ",", "side", "beside", "go", "stay", "move", "come", "leave", "swap", "trade",
                     "change"})  # fmt: skip
"""What stands behind "the top two" where no blocks are named."""
_OF_EACH = Patterns("of|in the|both|all|these|those two|2|three|3|four|4? towers|stacks|piles|rows|lines|columns",
                    "of|in both|each|each_of_the|every of_the? towers|tower|stacks|stack|rows|row")  # fmt: skip
_LINES = ("stack", "row", "line", "column")


def at_an_end(p: Parser, i: int) -> Results[Noun]:
    """So many blocks from an end on."""
    j = p.one(i, _THE)
    ahead = p.number(j) if j else None  # "the two top blocks"
    rank = p.lex(j + (ahead is not None), _ENDS) if j else None
    if j and (top := p.lex(j, _TIPS)) is not None and (j + 1 == p.end or p.stands(j + 1, _BEHIND | {"of"})):
        end = max(_OF_EACH.matches(p, j + 1), default=j + 1)
        yield Noun(head="block", det="the", plural=True, traits=Traits(rank=top), span=p.span(i, end), cost=1), end
    if rank is None:
        return
    if ahead is None:
        yield from _of_each(p, i, j + 1, rank)
    many = p.number(j + 1) if ahead is None else ahead
    if many is None or many < 2:
        return
    k = p.one(j + 2, _ONES) or j + 2
    noun = Noun(head="block", det="the", amount=Amount(many, many), plural=True, traits=Traits(rank=rank),
                span=p.span(i, k), cost=1)  # fmt: skip
    if ahead is None and (k > j + 2 or k == p.end or p.stands(k, _BEHIND)):
        yield noun, k
    if end := p.any_of(k, OF_LINE):
        yield replace(noun, span=p.span(i, end)), end
    for whole, end in structure(p, of) if (of := p.one(k, "of")) else ():
        if isinstance(whole, Structure) and whole.kind in _LINES and whole.det == "the" and not whole.plural:
            yield replace(noun, part_of=whole, span=p.span(i, end)), end


def _of_each(p: Parser, i: int, j: int, rank: str) -> Results[Noun]:
    """ "the top blocks of the two towers": the one that is there of each."""
    ones = p.one(j, _ONES)
    for end in _OF_EACH.matches(p, ones) if ones else ():
        yield Noun(head="block", det="the", plural=True, traits=Traits(rank=rank), span=p.span(i, end), cost=1), end
