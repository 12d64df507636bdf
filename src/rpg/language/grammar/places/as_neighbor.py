"""Neighbours: "give every red cube a blue neighbour", "has a blue cube as its neighbour" is one next to it."""

from __future__ import annotations

from rpg.language.grammar.core import Parser, Results, choice
from rpg.language.lexicon import COLOR
from rpg.language.meaning import Loc, Pronoun

_AS = tuple(
    f"{as_} {its}{next_}neighbor{s}"
    for as_ in ("as", "for")
    for its in ("", "a ", "its ", "their ")
    for next_ in ("", "direct ", "next door ")
    for s in ("", "s")
)
_BARE = ("neighbor", "neighbors")


@choice
def as_neighbor(p: Parser, i: int) -> Results[Loc]:
    """Behind what a block has: that it is next to it."""
    j = p.any_of(i, _AS) or (p.one(i, _BARE) if p.follows(i, COLOR) else 0)
    if j:
        it = Pronoun(word="it", span=p.span(i, j))
        yield Loc(rel="beside", landmark=it, span=it.span), j
