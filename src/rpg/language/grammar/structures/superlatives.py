"""Structures told by how they compare. Those that are to be as large as they can be, "the tallest tower you can build
from five blocks", are made of all the blocks that are named, or of as many as any other such structure; "the taller of
the two towers" is one of those that there are."""

from __future__ import annotations

from collections.abc import Iterator

from rpg.language import lexicon
from rpg.language.grammar.core import Parser
from rpg.language.grammar.structures.shapes import noun
from rpg.language.grammar.structures.sizes import OF_WHAT
from rpg.language.grammar.talk.slots import Patterns
from rpg.language.meaning import Amount, Noun, Structure, Traits

_MOST = {"stack": frozenset({"tallest", "highest", "biggest", "largest"}),
         **dict.fromkeys(("row", "line"), frozenset({"longest", "biggest", "largest"}))}  # fmt: skip
_MARKS = frozenset().union(*_MOST.values())
_CAN = Patterns(
    "possible",
    "that|which? you|we|it can possibly? build|make|manage|create|construct|be|get?",
    "that|which is possible",
)
_OF_ALL = Patterns(
    "with|from|out_of|using|of what|whatever|everything|all|all_that that? "
    "is|you_have|we_have|there_is|is_there|i_have there|here|available|on_the_table|got?",
)
"""That it is to be made of all that is there, which goes without saying where nothing else is said."""
_MADE = frozenset({"build", "make", "create", "construct"})
_MADE_OF = frozenset({"with", "from", "out", "using"})


def largest(p: Parser, i: int) -> Iterator[tuple[Structure, int]]:
    """Such a structure, before it is told what it is made of."""
    if not p.anywhere(_MARKS):
        return
    j = p.opt(i, "the", "a", "my", "your")
    if not p.stands(j, _MARKS):
        return
    most = j
    j = possible = p.opt(j + 1, "possible")
    for (kind, plural), k in noun(p, j):
        if plural or p.words[most] not in _MOST.get(kind, ()):
            continue
        end = max(_CAN.matches(p, k), default=k)
        told = end > k or possible > most + 1
        if last := max(_OF_ALL.matches(p, end), default=end if told and end >= p.end else 0):
            blocks = Noun(head="block", det="all", plural=True, span=p.span(i, last))
            yield Structure(kind=kind, det="a", amount=Amount(1, 1), members=blocks, span=p.span(i, last)), last
        elif p.all.isdisjoint(OF_WHAT):
            continue
        if end > k or possible > most + 1 or (p.follows(i, _MADE) and p.stands(end, _MADE_OF)):
            yield Structure(kind=kind, det="a", amount=Amount(1, 1), span=p.span(i, end)), end


RANKS = {
    "left": "left", "right": "right", "front": "front", "back": "back", "middle": "middle", "last": "last",
    "near": "front", "far": "back",
    **dict.fromkeys(("taller", "tallest", "higher", "highest", "longer", "longest"), "most"),
    **dict.fromkeys(("shorter", "shortest"), "least"), **{word: str(n) for word, n in lexicon.ORDINAL.items()},
}  # fmt: skip
"""Which of several structures is meant."""


def one_of_several(p: Parser, i: int) -> Iterator[tuple[Structure, int]]:
    """ "the taller of the two towers", "the left one of the rows"; "the left of" them alone is where something is."""
    rank = p.peek(j, RANKS) if (j := p.one(i, "the")) else None
    if rank is None:
        return
    one = p.one(j + 1, ("one", "tower", "stack", "row", "line", "column"))
    of = p.any_of(one or j + 1, ("of the", "of these", "of those"))
    if not of or not (one or rank in ("most", "least") or rank.isdigit()):
        return
    for (kind, plural), k in noun(p, of + 1 if p.number(of) else of):
        if plural:
            many = p.number(of)
            told = Amount(many, many) if many else None
            yield Structure(kind=kind, det="the", traits=Traits(rank=rank), amount=told, span=p.span(i, k)), k
