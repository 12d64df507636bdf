""" "Against the left side of the blue block": beside it there, and touching it."""

from __future__ import annotations

from rpg.language.grammar.core import Parser, Results, choice
from rpg.language.grammar.things.nouns import noun_phrase
from rpg.language.meaning import Coord, Loc, Meaning, Pronoun

_AGAINST = ("against", "up against", "right against", "right up against", "flush against", "flush with", "touching",
            "tight against", "in contact with", "snug against", "pushed against", "to touch")  # fmt: skip
_SIDES = {"left": "left", "right": "right", "front": "front", "back": "behind", "near": "front", "far": "behind",
          "rear": "behind"}  # fmt: skip
_FACE = ("side", "face", "hand side", "edge")


@choice
def against_side(p: Parser, i: int) -> Results[Coord]:
    j = p.any_of(i, _AGAINST)
    if not j:
        return
    if (end := _side(p, p.one(j, "the"))) and (of := p.one(end, "of")):
        for mark, k in noun_phrase(p, of):
            yield _there(p, i, k, mark, p.words[p.one(j, "the")]), k
    own = p.one(j, "its")
    if own and (end := _side(p, own)):
        yield _there(p, i, end, Pronoun(word="it", span=p.span(j, own)), p.words[own]), end
    for mark, k in noun_phrase(p, j):
        owned = p.one(k, "'s")
        if end := _side(p, owned):
            yield _there(p, i, end, mark, p.words[owned]), end


def _side(p: Parser, at: int) -> int:
    """The position behind "left side"; 0 for none."""
    return p.any_of(at + 1, _FACE) if at and p.words[at] in _SIDES else 0


def _there(p: Parser, i: int, k: int, mark: Meaning, side: str) -> Coord:
    span = p.span(i, k)
    places = (Loc(rel=_SIDES[side], landmark=mark, span=span), Loc(rel="touching", landmark=mark, span=span))
    return Coord(op="and", items=places, span=span)
