"""Where an edit puts things: spots in a line, and the relations of the instruction language."""

from __future__ import annotations

from dataclasses import replace

from rpg.steer.requests.language import Parser, Results, lexicon, loc, longest, m, noun_phrase, phrases, rule, simple
from rpg.steer.requests.requests import Place, Spot

_ENDS = {
    "on top": "top", "on the top": "top", "at the top": "top", "to the top": "top", "on the very top": "top",
    "at the very top": "top", "to the very top": "top", "as the top": "top", "up top": "top", "above": "top",
    "at the bottom": "bottom", "on the bottom": "bottom", "to the bottom": "bottom", "underneath": "bottom",
    "below": "bottom", "beneath": "bottom", "under": "bottom", "as the base": "bottom", "at the base": "bottom",
    "to the base": "bottom", "at the very bottom": "bottom", "as a base": "bottom", "as the bottom": "bottom",
    "in the end": "end",
    "at the end": "end", "to the end": "end", "on the end": "end", "at the very end": "end", "last": "end",
    "at the beginning": "begin", "to the beginning": "begin", "at the start": "begin", "to the start": "begin",
    "first": "begin",
    "at the left end": "left", "on the left end": "left", "to the left end": "left", "at the far left": "left",
    "on the far left": "left", "to the far left": "left", "at the left": "left", "on the left": "left",
    "to the left": "left", "at the right end": "right",
    "on the right end": "right", "to the right end": "right", "at the far right": "right",
    "on the far right": "right", "to the far right": "right", "at the right": "right",
    "on the right": "right",
    "to the right": "right", "leftmost": "left", "rightmost": "right",
    "in front": "front", "at the front": "front", "to the front": "front", "at the back": "back", "to the back": "back",
    "behind": "back", "at the front end": "front", "at the back end": "back",
    "in the middle": "middle", "to the middle": "middle", "in the center": "middle", "in the centre": "middle",
    "to the center": "middle", "to the centre": "middle",
    "in between": "middle", "in between them": "middle", "between them": "middle", "between the two": "middle",
    "next to it": "beside", "beside it": "beside", "next to them": "beside", "beside them": "beside",
    "alongside": "beside", "alongside it": "beside", "next to that": "beside",
    **{f"as {a} {nth} group".replace("  ", " "): "group" for a in ("a", "another", "their own", "an") for nth in (
        "", "new", "separate", "extra", "further",
    )},
    **{f"{lead} {nth} group": f"group {n}" for lead in (
        "as a", "as the", "in a", "forming a", "to form a", "which form a", ", they form a", ", forming a",
        "that form a", ", which form a", ", to form a", ", as a", ". they form a",
    ) for nth, n in (
        ("second", 2), ("third", 3), ("fourth", 4), ("fifth", 5), ("sixth", 6),
    )},
    "in a group of their own": "group", "in another group": "group", "in a new group": "group",
    "in their own group": "group", "in a group by themselves": "group",
}  # fmt: skip
_SIDES_OF = {
    "on the top of": "top", "at the top of": "top", "to the top of": "top", "on top of": "top",
    "at the bottom of": "bottom", "on the bottom of": "bottom",
    "to the bottom of": "bottom", "at the base of": "bottom",
    "at the end of": "end", "to the end of": "end", "at the left end of": "left", "to the left end of": "left",
    "on the left end of": "left", "at the right end of": "right", "to the right end of": "right",
    "on the right end of": "right", "in the middle of": "middle", "in the center of": "middle",
    "at the beginning of": "begin", "at the start of": "begin", "at the front of": "front", "at the back of": "back",
}  # fmt: skip
_INTO = ("to", "into", "in", "onto", "for")


_PATCHES = frozenset(lexicon.PATCH_NOUNS.split()) - {"circle", "square", "rectangle", "ring"}
_THAT = phrases(
    "that is | which is | that must be | that should be | that has to be | which must be | that goes | sitting | "
    "placed | standing | directly | right | also"
)
_NOT_TO_BE = tuple(
    f"{that} {must}"
    for that in ("that", "which")
    for must in (
        "must not be",
        "may not be",
        "should not be",
        "must not lie",
        "must not touch",
        "can not be",
        "cannot be",
    )
)


@rule
def places(p: Parser, i: int) -> Results[tuple[Place, ...]]:
    """Nothing, one place, or two ("on top of the red block, to the left of the patch"); the longest first."""
    for first, j in place(p, i):
        k = p.opt(j, ",", "and")
        for second, end in place(p, k):
            if not isinstance(second, Spot):
                yield (first, second), end
        yield (first,), j
    yield (), i


@rule
def place(p: Parser, i: int) -> Results[Place]:
    """One place."""
    start = (
        longest(
            p,
            i,
            _THAT,
        )
        or i
    )
    for at in {i: None, start: None}:
        for phrase, side in _SIDES_OF.items():
            if j := p.seq(at, phrase):
                for whole, k in simple(p, j):
                    if isinstance(whole, m.Structure | m.Pronoun):
                        yield Spot(side=side, whole=whole), k
                if k := longest(p, j, "the word | the text | the name"):
                    yield Spot(side=side, whole=m.Structure(kind="word", det="the", span=p.span(j, k))), k
        for phrase, side in _ENDS.items():
            if j := p.seq(at, phrase):
                yield Spot(side=side), j
        if j := longest(p, at, _INTO):
            for whole, k in simple(p, j):
                if isinstance(whole, m.Structure) and whole.det in ("the", "its", "all", "each"):
                    yield Spot(side="any", whole=whole), k
        for found, j in loc(p, at):
            if not _a_figure(p, at, j, found):
                yield _of_none(found), j
        if k := longest(p, i, _NOT_TO_BE):
            for found, j in loc(p, k):
                if isinstance(found, m.Loc | m.In) and not found.negated:
                    yield replace(found, negated=True), j
        for word in ("after", "before"):
            for landmark, k in noun_phrase(p, at + 1) if p.one(at, word) else ():
                yield m.Loc(rel=word, landmark=landmark, span=p.span(at, k)), k


def _a_figure(p: Parser, i: int, j: int, found: m.Meaning) -> bool:
    """Phrases such as "in a circle": what blocks form, and no patch of that shape."""
    mark = getattr(found, "landmark", None)
    shaped = isinstance(mark, m.Noun) and mark.head == "patch" and mark.traits == m.Traits(shape=mark.traits.shape)
    return shaped and _PATCHES.isdisjoint(p.words[i:j])


def _of_none(found: m.Meaning) -> m.Meaning:
    """Phrases such as "on neither patch": not on any of them."""
    lost = found.landmark if isinstance(found, m.Loc) else None
    if not isinstance(found, m.Loc) or not isinstance(lost, m.Noun) or lost.det != "no" or found.negated:
        return found
    return replace(found, landmark=replace(lost, det="all", plural=True), negated=True)


def given_up(p: Parser, i: int) -> int:
    """The position after a place that is given up: "instead of to the left of it", ", not on the blue one"."""
    j = longest(p, i, ", instead of | instead of | rather than | , rather than | , and not | and not | , not | not")
    ends = [k for _, k in place(p, j)] + [k for _, k in noun_phrase(p, j)] if j else []
    return max(ends, default=i)
