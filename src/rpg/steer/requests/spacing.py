"""Requests about tolerances and gaps: how tight, how wide, how even."""

from __future__ import annotations

from collections.abc import Iterator

from rpg.steer.requests import requests as r
from rpg.steer.requests.language import Parser, bounds, length, longest, phrases, simple


def loosening(p: Parser, i: int) -> Iterator[tuple[r.Request, int]]:
    """Phrases such as "tighten the tolerance to 5 mm", "space them further apart", "the gaps should be 2 cm"."""
    yield from _tolerance(p, i)
    yield from _spacing(p, i)


_TIGHTEN = {
    "tighten": 0.5, "loosen": 2.0, "relax": 2.0, "halve": 0.5, "double": 2.0, "reduce": 0.5, "increase": 2.0,
    "widen": 2.0, "narrow": 0.5, "decrease": 0.5, "lower": 0.5, "raise": 2.0, "triple": 3.0, "set": 1.0, "change": 1.0,
    "make": 1.0, "shrink": 0.5, "use": 1.0,
}  # fmt: skip
_TOLERANCE = (
    "the tolerance",
    "the tolerances",
    "tolerance",
    "tolerances",
    "the accuracy",
    "the precision",
    "the position tolerance",
    "a tolerance",
    "its tolerance",
)
_GAP = (
    "the gaps",
    "the gap",
    "gaps",
    "the space",
    "the spaces",
    "the distance",
    "the distances",
    "the gaps between them",
    "the gap between them",
)
_SPACING = ("the spacing", "spacing", "a spacing")


_BETWEEN = (
    "between them", "between neighbors", "between neighbours", "of the row", "between each of them", "in between",
    *(
        " ".join(("between", *which.split(), noun))
        for which in ("", "the", "any two", "two", "neighboring", "neighbouring", "adjacent", "any two adjacent")
        for noun in ("blocks", "cubes", "bricks", "letters", "neighbors", "neighbours")
    ),
)  # fmt: skip
_IS = phrases(
    ": | = | should be | shall be | must be | has to be | is | ought to be | are | should all be | must all be"
)


def _tolerance(p: Parser, i: int) -> Iterator[tuple[r.Request, int]]:
    for word, factor in _TIGHTEN.items():
        j = p.one(i, word)
        if not j:
            continue
        for nouns, what in ((_TOLERANCE, "tolerance"), (_GAP, "gap"), (_SPACING, "spacing")):
            k = longest(p, j, nouns)
            if not k:
                continue
            yield from _valued(p, i, longest(p, k, _BETWEEN) or k, what, factor)
    for nouns, what in ((_TOLERANCE, "tolerance"), (_GAP, "gap"), (_SPACING, "spacing")):
        j = longest(p, i, nouns)
        if k := longest(p, longest(p, j, _BETWEEN) or j, _IS) if j else 0:
            yield from _valued(p, i, k, what, 1.0)
    for word, factor in (("loosen", 2.0), ("relax", 2.0), ("tighten", 0.5)):
        if j := longest(p, i, (f"{word} it", f"{word} it up", f"{word} things", f"{word} things up", f"{word} up")):
            yield (r.Loosen(what="tolerance", factor=factor, span=p.span(i, j), cost=1), j)
    if j := longest(
        p,
        i,
        "be more precise | be stricter | make it stricter | make it more precise | be more "
        "exact | make it tighter | make it harder",
    ):
        yield r.Loosen(what="tolerance", factor=0.5, span=p.span(i, j)), j
    if j := longest(
        p,
        i,
        "be less strict | be more lenient | make it looser | make it less strict | be less "
        "precise | make it more lenient | be more forgiving | make it easier",
    ):
        yield r.Loosen(what="tolerance", factor=2.0, span=p.span(i, j)), j
    if j := longest(
        p,
        i,
        "to within | within | with a tolerance of | allow a tolerance of | with tolerance | allow an error of | allow",
    ):
        for metres, k in length(p, j):
            yield r.Loosen(what="tolerance", value=metres, span=p.span(i, k), cost=1), k


_CHANGES = {
    "smaller": 0.5, "tighter": 0.5, "narrower": 0.5, "larger": 2.0, "bigger": 2.0, "wider": 2.0, "looser": 2.0,
    "twice as wide": 2.0, "twice as large": 2.0, "half as wide": 0.5, "shorter": 0.5, "longer": 2.0, "stricter": 0.5,
}  # fmt: skip
_APART = {
    "further apart": 2.0, "farther apart": 2.0, "closer together": 0.5, "more widely": 2.0, "wider apart": 2.0,
    "more tightly": 0.5, "nearer together": 0.5, "closer": 0.5, "twice as far apart": 2.0,
}  # fmt: skip


def _valued(p: Parser, i: int, k: int, what: str, factor: float) -> Iterator[tuple[r.Request, int]]:
    """A new value, or a factor where none is given."""
    if n := longest(p, k, "to | of | be | at | a"):
        for metres, end in length(p, n):
            yield r.Loosen(what=what, value=metres, bare=True, span=p.span(i, end)), end
    for phrase, change in _CHANGES.items():
        if end := p.seq(k, phrase):
            yield r.Loosen(what=what, factor=change, span=p.span(i, end)), end
    for metres, end in length(p, k):
        yield r.Loosen(what=what, value=metres, bare=True, span=p.span(i, end)), end
    if end := longest(p, k, ("even", "equal", "the same")):
        yield r.Loosen(what="even", span=p.span(i, end)), end
    if factor != 1.0:
        end = longest(p, k, ("a bit", "a little", "slightly")) or k
        yield r.Loosen(what=what, factor=factor, span=p.span(i, end)), end


_BE_SPACED = phrases(
    "they should be | the blocks should be | they must be | with | leave | they are | they should | they must | "
    "they have to | they should all | they must all | they have to be | all of them should | all blocks should | "
    "the blocks should | the blocks must | the blocks have to | the cubes should | the cubes must | all should | "
    "neighbors should | neighbours should | neighbors must | neighbours must"
)


def _spacing(p: Parser, i: int) -> Iterator[tuple[r.Request, int]]:
    starts = [i]
    if j := longest(
        p, i, "space | spread | move | put | place | make | keep | set | bring | push | leave | have | arrange | let"
    ):
        starts += [j, *(k for _, k in simple(p, j))]
    if j := longest(p, i, _BE_SPACED):
        starts.append(j)
    for start in starts:
        if p.words[i] in ("spread", "space") and (k := p.one(start, "out")) and k == p.end:
            yield r.Loosen(what="spacing", factor=2.0, span=p.span(i, k)), k
        start = p.opt(start, "out")
        for phrase, factor in _APART.items():
            if k := p.seq(start, phrase):
                yield r.Loosen(what="spacing", factor=factor, span=p.span(i, k)), k
        if k := longest(
            p,
            start,
            "even gaps | equal gaps | even spacing | equal spacing | with even gaps | with even spacing | "
            "with equal spacing | "
            "evenly | equally | evenly spaced | equally spaced | at equal distances | with equal "
            "gaps | evenly apart | evenly spaced out",
        ):
            yield r.Loosen(what="even", span=p.span(i, k)), k
        if k := longest(
            p,
            start,
            "touch | touch one another | touching one another | no gaps | no gap | no space between them | "
            "no gaps at all | "
            "touching | touching each other | each block touching the next | each touching the next | "
            " without gaps | with no gaps | with no gaps between "
            "them | so that they touch | touch each other",
        ):
            k = longest(p, k, _BETWEEN) or k
            yield r.Loosen(what="touching", span=p.span(i, k)), k
        for low, high, what, k in _apart(p, start):
            yield r.Loosen(what=what, value=high, low=low, span=p.span(i, k)), k


def _apart(p: Parser, i: int) -> Iterator[tuple[float | None, float | None, str, int]]:
    """Phrases such as "6 cm apart", "with gaps of 2 cm"."""
    for (low, high), j in bounds(p, i):
        if k := longest(p, j, "apart | apart from each other | from each other | between centers | between centres"):
            yield low, high, "spacing", k
        if k := longest(
            p,
            j,
            "between neighbors | between each of them | between each block | between one another | of space | "
            "gaps | gap | between them | between the blocks | of space between them | of space | between each",
        ):
            yield low, high, "gap", k
    if j := longest(p, i, "with gaps of | with a gap of | gaps of | a gap of | leaving a gap of"):
        for (low, high), k in bounds(p, j):
            yield (low, high, "gap", longest(p, k, _BETWEEN) or longest(p, k, "between each") or k)
