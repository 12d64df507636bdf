"""Distances as things: "a gap of 6 cm between ..."."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any, cast

from rpg.language.grammar.core import Parser, Results, rule
from rpg.language.grammar.places.measures import bounds, measured_so, room, their_ends
from rpg.language.grammar.places.sides import at
from rpg.language.grammar.things.nouns import noun_phrase, simple
from rpg.language.meaning import At, Chain, Clause, Coord, Loc, Meaning, Noun, Pronoun, That, Traits, replace

_GAPS = tuple(
    (noun, measure, (noun, f"of {noun}", f"wide {noun}", f"of free {noun}", f"of empty {noun}"),
     (f"{noun} from", f"{noun} of"))
    for noun, measure in (("gap", "faces"), ("space", "faces"), ("distance", "centres"), ("spacing", "centres"),
                          ("separation", "centres"))
)  # fmt: skip
"""Words for a distance, what it is measured between, what of them follows a length, and what precedes two blocks."""
_LEAVE = (
    "leave", "keep", "have", "put", "make", "maintain", "there should be", "there must be", "there is",
    "there has to be", "there needs to be", "there shall be", "there will be", "leaving",
)  # fmt: skip


_IS = (
    "is", "be", "comes to", "amounts to", "measures",
    *(f"{must} {be}" for must in ("should", "must", "has to", "shall", "ought to", "needs to", "is to", "will")
      for be in ("be", "come to", "amount to", "measure")),
)  # fmt: skip
_ENDS_OF = {
    f"{the}{end} of": measure
    for the in ("the ", "")
    for ends, measure in ((("center", "middle", "midpoint"), "centres"), (("edge", "side", "face"), "faces"))
    for end in ends
}
"""What of a block a distance is measured from."""
_LIES = ("is", "should be", "must be", "has to be", "shall be", "is to be", "lies", "needs to be", "being", "sits")
_ARE = ("are", "should be", "must be", "have to be", "are to be", "shall be", "lie", "stay", "being")


@rule
def gap(p: Parser, i: int) -> Results[Clause]:
    """ "leave a gap of 6 cm between the red and the green block", "the distance between A and B should be 12 cm"."""
    for measure, j in their_ends(p, i):
        them = Pronoun(word="them", span=p.span(i, j))
        are = p.any_of(j, _ARE)
        for (low, high), k in bounds(p, are) if are else ():
            if end := p.any_of(k, ("apart", "from each other", "apart from each other", "away from each other")):
                yield _far_apart(p, i, end, them, low, high, measure), end
    for one, measure, j in _end_of(p, i):
        at_ = p.any_of(j, _LIES)
        for (low, high), k in bounds(p, at_) if at_ else ():
            away = p.any_of(k, ("from", "away from", "apart from"))
            for two, same, end in _end_of(p, away) if away else ():
                both = Coord(op="and", items=(one, two), span=p.span(i, end))
                if same == measure:
                    yield _far_apart(p, i, end, both, low, high, measure), end
    yield from _left_between(p, i)


def _end_of(p: Parser, i: int) -> Iterator[tuple[Noun, str, int]]:
    """ "the middle of the red block", "the edge of A": a block, and what of it a distance is measured from."""
    for phrase, j in p.standing(i, _ENDS_OF):
        for block, k in simple(p, j):
            if isinstance(block, Noun) and block.head != "patch":
                yield block, _ENDS_OF[phrase], k


def _left_between(p: Parser, i: int) -> Results[Clause]:
    """ "leave a gap of 6 cm between the red and the green block": the distance comes first."""
    j = p.any_of(i, _LEAVE) or i
    j = p.opt(j, "a", "an", "the")
    spans: list[tuple[Any, int, str]] = []
    wide = bounds(p, j)
    for noun, measure, behind, _ in _GAPS:
        if (k := p.one(j, noun)) and (k := p.one(k, "of")):
            spans += [(b, e, measure) for b, e in bounds(p, k)]
        spans += [(b, e, measure) for b, k in wide if (e := p.any_of(k, behind))]
        if (k := p.one(j, noun)) and (k := p.any_of(k, ("between the faces of", "between", "of"))):
            measure = "faces" if p.words[k - 2] == "faces" else measure
            for theme, end in noun_phrase(p, k):
                made = end if p.words[i] in ("make", "keep") else 0
                end = p.any_of(end, _IS) or made
                wide_ = [*bounds(p, end), *(room(p, end) if measure == "faces" else ())] if end else []
                for (low, high), last in wide_:
                    last = p.opt(last, "wide")
                    yield _far_apart(p, i, last, theme, low, high, measure), last
    for _, measure, _, before in _GAPS:
        yield from _from_to(p, i, p.any_of(j, before), measure)
    spans += [(b, e, "faces") for b, e in wide]
    if k := p.any_of(j, ("room for", "space for", "gap of", "space of", "enough room for", "enough space for")):
        spans += [(b, e, "faces") for b, e in room(p, k)]
    for (low, high), k, _ in spans:
        for one, measure, m in _end_of(p, k + 1) if p.one(k, "from") else ():
            for two, same, end in _end_of(p, m + 1) if p.one(m, "to") else ():
                if same == measure:
                    both = Coord(op="and", items=(one, two), span=p.span(k, end))
                    yield _far_apart(p, i, end, both, low, high, measure), end
    for (low, high), k, measure in spans:
        if m := p.one(k, "between"):
            if centres := p.any_of(m, ("the centers of", "centers of", "the middles of")):
                m, measure = centres, "centres"
            if faces := p.any_of(m, ("the faces of", "faces of", "the sides of")):
                m, measure = faces, "faces"
            for ends, end in their_ends(p, m):
                yield _far_apart(p, i, end, Pronoun(word="them", span=p.span(m, end)), low, high, ends), end
            for told, end in noun_phrase(p, m):
                theme = _its_own(told) if p.words[i] == "leaving" else told
                apart = _far_apart(p, i, end, theme, low, high, measure)
                for far, last in measured_so(p, cast(Loc, apart.adjuncts[0]), i, end):
                    yield replace(apart, adjuncts=(far,), span=p.span(i, last)), last
                yield from _with_side(p, i, end, apart)


def _its_own(told: Meaning) -> Meaning:
    """ "(spell DOG,) leaving 2 cm between the letters": between those just spoken of."""
    plain = isinstance(told, Noun) and told.head == "block" and told.det == "the" and told.plural
    if (
        isinstance(told, Noun)
        and plain
        and told == Noun(head="block", det="the", plural=True, traits=Traits(kind=told.traits.kind), span=told.span)
    ):
        return Pronoun(word="them", span=told.span)
    return told


def _from_to(p: Parser, i: int, j: int, measure: str) -> Results[Clause]:
    """ "the distance from the red to the blue block must be less than 8 cm"."""
    for one, k in simple(p, j) if j else ():
        for two, end in simple(p, p.one(k, "to")) if p.one(k, "to") else ():
            both = isinstance(one, Noun) and isinstance(two, Noun)
            told = p.any_of(end, _IS) or (p.one(end, ":") if both else 0)
            for (low, high), last in bounds(p, told) if both and told else ():
                theme = Coord(op="and", items=(one, two), span=p.span(j, end))
                yield _far_apart(p, i, last, theme, low, high, measure), last


def _with_side(p: Parser, i: int, at_: int, apart: Clause) -> Results[Clause]:
    """ "a gap of 4 cm between yellow and green, yellow on the left": of the two, one is on a side of the other."""
    pair = apart.theme.items if isinstance(apart.theme, Coord) and apart.theme.op == "and" else ()
    start = p.any_of(at_, (", with", "with", ",")) if len(pair) == 2 else 0
    for one, j in noun_phrase(p, start) if start else ():
        for side, end in at(p, j):
            name = {"back": "behind"}.get(side.side, side.side) if isinstance(side, At) and side.index is None else ""
            other = [x for x in pair if isinstance(x, Noun) and isinstance(one, Noun) and not _same_look(x, one)]
            if name in ("left", "right", "front", "behind") and len(other) == 1:
                place = Loc(rel=name, landmark=replace(other[0], det="the", amount=None), span=p.span(j, end))
                span = p.span(start, end)
                told = Clause(verb="be", theme=one, adjuncts=(place,), mode="goal", span=span)
                that = That(kind="so", clauses=Chain(clauses=(told,), links=("and",), span=span), span=span)
                yield replace(apart, adjuncts=(*apart.adjuncts, that), span=p.span(i, end)), end


def _same_look(one: Noun, two: Noun) -> bool:
    return (one.traits.colors, one.traits.labels) == (two.traits.colors, two.traits.labels)


def _far_apart(
    p: Parser, i: int, end: int, theme: Meaning, low: float | None, high: float | None, measure: str
) -> Clause:
    span = p.span(i, end)
    far = Loc(
        rel="distance", landmark=Pronoun(word="each other", span=span), low=low, high=high, measure=measure, span=span
    )
    return Clause(verb="be", theme=theme, adjuncts=(far,), span=span)
