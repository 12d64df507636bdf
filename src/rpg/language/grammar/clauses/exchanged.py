""" "Swap the top two", "swap the two ends of the row": two blocks by one place that is told of both."""

from __future__ import annotations

from rpg.core.diagnostics import Span
from rpg.language import lexicon
from rpg.language.grammar.clauses.adjuncts import adjuncts
from rpg.language.grammar.core import Parser, Results
from rpg.language.grammar.structures.structures import structure
from rpg.language.grammar.things.in_line import OF_LINE
from rpg.language.meaning import Amount, Clause, Coord, Meaning, Noun, Structure, Traits, replace

_SECOND = {"top": "top", "upper": "top", "bottom": "bottom", "lower": "bottom", "last": "last", "left": "left",
           "leftmost": "left", "right": "right", "rightmost": "right"}  # fmt: skip
_NEXT = {
    **{word: (side, f"2 {side}") for word, side in _SECOND.items()}, "first": ("1", "2"),
    **dict.fromkeys(("outer", "outermost", "end"), ("1", "last")),
}  # fmt: skip
"""The places of two blocks of which one is told."""
_ENDS = (
    "the two ends", "the ends", "both ends", "its ends", "its two ends",
    *(f"{those} {at} {ends}" for those in ("the two", "the ones", "the two blocks", "the blocks", "those", "the cubes")
      for at in ("at", "on") for ends in ("the ends", "its ends", "the two ends", "both ends", "either end")),
)  # fmt: skip
_THE = frozenset({"the", "its", "their"})
_UPRIGHT = frozenset({"top", "bottom"})


def exchanged(p: Parser, i: int, j: int) -> Results[Clause]:
    """What follows "swap" where it tells two blocks by one place."""
    for ranks, k in _two(p, j):
        for whole, end in _of_what(p, k, ranks):
            items = tuple(
                Noun(head="block", det="the", traits=Traits(rank=rank), part_of=whole, span=p.span(j, end))
                for rank in ranks
            )
            both = Coord(op="and", items=items, span=p.span(j, end))
            for found, last in adjuncts(p, end):
                span, word = p.span(i, last), p.span(i, i + 1)
                told = Clause(verb="swap", lemma="swap", theme=both, adjuncts=found, span=span, word=word)
                yield told, last
                if ranks[0] in _UPRIGHT and whole is None:
                    yield replace(told, theme=_of_each(ranks[0], p.span(j, end)), cost=1), last


def _of_each(rank: str, span: Span) -> Noun:
    """ "The two upper ones" of two towers: one of each."""
    return Noun(head="block", det="the", amount=Amount(2, 2), plural=True, traits=Traits(rank=rank), span=span)


def _two(p: Parser, j: int) -> Results[tuple[str, ...]]:
    """ "the top two (blocks)", "the two top ones", "the end cubes", "both ends"."""
    if k := p.any_of(j, _ENDS):
        yield _NEXT["end"], k
    start = p.one(j, _THE) or j
    two = p.number(start) == 2
    ranks = p.lex(start + two, _NEXT)
    k = start + two + 1
    if ranks is None:
        return
    if not two and p.stands(k, _TWO):
        two, k = True, p.reach(k + 1)
    noun = p.one(k, _ONES)
    if two or (noun and p.stands(start, ("end", "outer", "outermost"))):
        yield ranks, noun or k


_TWO = frozenset({"two", "2"})
_ONES = frozenset({"ones", *(word for word, several in lexicon.BLOCK.items() if several), "letters", "digits"})


def _of_what(p: Parser, k: int, ranks: tuple[str, ...]) -> Results[Meaning | None]:
    yield None, p.any_of(k, OF_LINE) or k
    of = p.one(k, ("of", "in")) if not _UPRIGHT.isdisjoint(ranks) else 0
    for whole, end in structure(p, of) if of else ():
        if isinstance(whole, Structure) and whole.kind == "stack" and whole.det == "the" and not whole.plural:
            yield whole, end
