"""Distances as things: "a gap of 6 cm between ..."."""

from __future__ import annotations

from typing import Any

from rpg.language.grammar.core import Parser, Results, rule
from rpg.language.grammar.measures import bounds
from rpg.language.grammar.nouns import noun_phrase
from rpg.language.meaning import Clause, Loc, Meaning, Pronoun

_GAPS = (
    ("gap", "faces"),
    ("space", "faces"),
    ("distance", "centres"),
    ("spacing", "centres"),
    ("separation", "centres"),
)


@rule
def gap(p: Parser, i: int) -> Results[Meaning]:
    """ "leave a gap of 6 cm between the red and the green block", "the distance between A and B should be 12 cm"."""
    j = (
        p.any_of(
            i,
            (
                "leave",
                "keep",
                "have",
                "put",
                "make",
                "maintain",
                "there should be",
                "there must be",
                "there is",
                "there has to be",
                "there needs to be",
                "leaving",
            ),
        )
        or i
    )
    j = p.opt(j, "a", "an", "the")
    spans: list[tuple[Any, int, str]] = []
    for noun, measure in _GAPS:
        if (k := p.one(j, noun)) and (k := p.one(k, "of")):
            spans += [(b, e, measure) for b, e in bounds(p, k)]
        spans += [
            (b, e, measure)
            for b, k in bounds(p, j)
            if (e := p.any_of(k, (noun, f"of {noun}", f"wide {noun}", f"of free {noun}", f"of empty {noun}")))
        ]
        if (k := p.one(j, noun)) and (k := p.any_of(k, ("between the faces of", "between", "of"))):
            measure = "faces" if p.words[k - 2] == "faces" else measure
            for theme, end in noun_phrase(p, k):
                made = end if p.words[i] in ("make", "keep") else 0
                end = p.any_of(end, ("is", "should be", "must be", "has to be", "shall be", "be")) or made
                for (low, high), last in bounds(p, end) if end else ():
                    yield _far_apart(p, i, last, theme, low, high, measure), last
    spans += [(b, e, "faces") for b, e in bounds(p, j)]
    for (low, high), k, measure in spans:
        if m := p.one(k, "between"):
            if centres := p.any_of(m, ("the centers of", "centers of", "the middles of")):
                m, measure = centres, "centres"
            for theme, end in noun_phrase(p, m):
                yield _far_apart(p, i, end, theme, low, high, measure), end


def _far_apart(
    p: Parser, i: int, end: int, theme: Meaning, low: float | None, high: float | None, measure: str
) -> Clause:
    span = p.span(i, end)
    far = Loc(
        rel="distance", landmark=Pronoun(word="each other", span=span), low=low, high=high, measure=measure, span=span
    )
    return Clause(verb="be", theme=theme, adjuncts=(far,), span=span)
