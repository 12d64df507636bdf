"""Clauses that compare distances: "of red and blue, red is closer to A", "its distance from A is less than that"."""

from __future__ import annotations

from rpg.core.diagnostics import Span
from rpg.language.grammar.core import Parser, Results, rule
from rpg.language.grammar.places.compared import FARTHEST, NEAREST, WORDS, marks
from rpg.language.grammar.places.offsets import centering
from rpg.language.grammar.things.nouns import noun_phrase, simple
from rpg.language.meaning import Clause, Coord, Loc, Meaning, Noun, Pronoun, replace

_BE = (
    "is", "stands", "lies", "is to be", "has to be", "is to stand", "is placed", "should be placed", "must be placed",
    *(f"{modal} {be}" for modal in ("should", "must", "shall", "has to", "needs to") for be in ("be", "stand", "lie")),
)  # fmt: skip
_DISTANCE = ("the distance", "the gap", "its distance")
_SMALLER = ("smaller than", "shorter than", "less than", "lower than")
_GREATER = ("greater than", "larger than", "bigger than", "longer than", "more than")
_EQUAL = ("equal to", "the same as", "as large as", "as great as", "as long as", "as big as", "just as large as",
          "exactly as large as")  # fmt: skip
_CLOSER = ("closer", "nearer")
_FARTHER = ("farther", "further", "farther away", "further away")
_MOST = (("closest", (*NEAREST, *_CLOSER)), ("farthest", (*FARTHEST, *_FARTHER)))


@rule
def measuring(p: Parser, i: int, mode: str) -> Results[Clause]:
    """A statement about distances: how well blocks are centred on each other, or which of two distances is the less."""
    yield from centering(p, i)
    yield from _comparing(p, i, mode) if p.rarely(WORDS) else ()


def _comparing(p: Parser, i: int, mode: str) -> Results[Clause]:
    """A statement that compares two distances or more."""
    if of := p.one(i, ("of", "among", "out")):
        yield from _of_those(p, i, p.opt(of, "of"), mode)
    if j := p.any_of(i, _DISTANCE):
        yield from _distances(p, i, j, mode)


def _of_those(p: Parser, i: int, j: int, mode: str) -> Results[Clause]:
    """ "Of the red and the blue block, the red one is (the) closest to the mat"."""
    for group, k in noun_phrase(p, j):
        if not isinstance(group, Noun | Coord | Pronoun):
            continue
        for theme, m in simple(p, p.opt(k, ",")):
            be = p.any_of(m, _BE)
            the = p.opt(be, "the") if be else 0
            for rel, words in _MOST:
                at = p.any_of(the, words) if the else 0
                for mark, end in marks(p, p.opt(at, "one", "block", "cube")) if at else ():
                    place = Loc(rel=rel, landmark=mark, second=group, span=p.span(be, end))
                    yield _said(theme, place, mode, p.span(i, end)), end


def _distances(p: Parser, i: int, j: int, mode: str) -> Results[Clause]:
    """ "the distance from green to red is smaller than the distance from green to blue"."""
    for one, k in _two_ends(p, j):
        equals = p.one(k, "equals")
        be = equals or p.any_of(k, _BE)
        for rel, words in (("closer", _SMALLER), ("farther", _GREATER), ("as_far", _EQUAL)):
            than = p.any_of(be, words) if be and not equals else equals if rel == "as_far" else 0
            for other, end in _second(p, than, one[0]) if than else ():
                found = _shared(one, other)
                if found is None:
                    continue
                theme, near, far = found
                place = Loc(rel=rel, landmark=near, second=far, span=p.span(be, end))
                yield _said(theme, place, mode, p.span(i, end)), end


def _said(theme: Meaning, place: Loc, mode: str, span: Span) -> Clause:
    return Clause(verb="be", lemma="fact", theme=theme, adjuncts=(place,), mode=mode, span=span)


def _two_ends(p: Parser, i: int) -> list[tuple[tuple[Meaning, Meaning], int]]:
    """ "from A to B", "between A and B"."""
    found: list[tuple[tuple[Meaning, Meaning], int]] = []
    for lead, joins in ((("between",), ("and",)), (("from", "of"), ("to", "from"))):
        for one, k in simple(p, at) if (at := p.one(i, lead)) else ():
            join = p.one(k, joins)
            found += [((one, other), end) for other, end in simple(p, join)] if join else []
    return found


def _second(p: Parser, i: int, first: Meaning) -> list[tuple[tuple[Meaning, Meaning], int]]:
    """The other distance: "the distance from A to C", "that between A and C", "(that) to C"."""
    j = p.any_of(i, ("the distance", "the gap", "that", "the one")) or i
    found = _two_ends(p, j) if j > i else []
    to = p.one(j, "to")
    return found + ([((first, other), end) for other, end in simple(p, to)] if to else [])


def _shared(one: tuple[Meaning, Meaning], other: tuple[Meaning, Meaning]) -> tuple[Meaning, Meaning, Meaning] | None:
    """What both distances have in common, and the further end of each."""
    for n, m in ((0, 0), (0, 1), (1, 0), (1, 1)):
        if _plainly(one[n]) == _plainly(other[m]) and _plainly(one[1 - n]) != _plainly(other[1 - m]):
            return one[n], one[1 - n], other[1 - m]
    return None


def _plainly(mark: Meaning) -> object:
    """A thing by its looks alone."""
    if not isinstance(mark, Noun):
        return replace(mark, span=(0, 0))
    return mark.traits, mark.head == "patch", mark.amount and mark.amount.low, mark.conditions
