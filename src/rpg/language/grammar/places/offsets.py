"""How well blocks are centred on each other: "centred to within 5 mm", "the offset may be at most 5 mm"."""

from __future__ import annotations

from rpg.language.grammar.core import Parser, Results, rule
from rpg.language.grammar.places.measures import bounds
from rpg.language.grammar.things.amounts import length
from rpg.language.grammar.things.nouns import simple
from rpg.language.meaning import Clause, Loc, Noun, PartOf, replace

_CENTERED = ("centered", "well centered", "aligned", "lined up", "concentric", "with its center aligned", "flush")
_WITHIN = (
    "to within", "within", "to", "up to", "with a tolerance of", "with tolerance", "tolerance", ", tolerance", "by",
    "with an accuracy of", "with a precision of", "to an accuracy of", "to a precision of", "with an error of", "+ / -",
    "within a tolerance of",
)  # fmt: skip
_TOLERANCE = (
    *(f"{within} {what} of"
      for within in ("within", "with", "to")
      for what in ("a tolerance", "a precision", "an accuracy", "a margin", "an error", "a position tolerance")),
    *(f"{what}{of}" for what in ("tolerance", "precision", "accuracy") for of in ("", " of", " :", " is")),
    "with tolerance", "with tolerance of", "accurate to", "accurate to within", "exact to", "exact to within",
    "precise to", "precise to within", "plus or minus",
)  # fmt: skip
_OFFSET = ("offset", "misalignment", "displacement", "deviation")
_SIDEWAYS = ("horizontal", "lateral", "sideways", "center")
_MOST = frozenset({"maximal", "maximum", "largest"})
_NAMED = frozenset({"the", "a", "each", "every", *_MOST, *_SIDEWAYS, *_OFFSET})
_OFF_CENTER = ("off center", "off the center", "off its center", "out of center", "off centre", "out of line")
_BELOW = (
    "the one below it", "the one below", "the block below it", "the block below", "the one under it", "the next one",
    "the cube below it", "the cube below", "the next", "its neighbor below", "the one underneath", "the one beneath it",
    "the block under it", "the one beneath", "the one underneath it",
)  # fmt: skip
_OFF = ("off", *(f"off {of}{below}" for of in ("", "from ", "of ") for below in _BELOW))
_EACH = (
    *(f"{each}{may}"
      for each in ("each", "each one", "each block", "each cube", "every block", "every cube", "every one")
      for may in ("", " may be", " is", " being", " must be", " should be", " can be")),
)  # fmt: skip
"""Of which blocks an offset is said: of all that lie on others."""
_OF_WHAT = (
    *(f"{of} {below}" for of in ("from", "to", "with respect to", "relative to") for below in _BELOW),
    "of the centers", "of their centers", "between the centers", "between their centers", "between them",
    "between the blocks", "between the two", "between the two blocks", "of the blocks", "of the two blocks",
    "between neighbors", "of the upper block", "of the top block", "from the center",
)  # fmt: skip
_CLOSED = frozenset({",", ";", "and", "but"})
_MAY_BE = (
    "may be", "must be", "should be", "is", "can be", "has to be", "is to be", "shall be", "must stay",
    "must not exceed", "should not exceed", "may not exceed", "does not exceed", "has to stay", "should stay", "stays",
    ":", "of",
)  # fmt: skip
_EACH_ON_THE_NEXT = tuple(
    f"{each} {must} centered on {below}"
    for each in ("every block", "each block", "every cube", "each cube", "each one", "each", "every one", "they", "all")
    for must in ("must be", "should be", "is", "is to be", "has to be", "being", "are", "")
    for below in (*_BELOW, "each other")
)  # fmt: skip
_MEET = ("line up", "be aligned", "coincide", "match", "agree", "be lined up", "are aligned", "lie above each other")
_MUST = ("must", "should", "have to", "shall", "are to", "need to")
_DIFFER = ("may differ by", "must not differ by", "should not differ by", "differ by", "may be off by", "are off by")


_MIDDLES = frozenset({"centers", "middles"})
_CENTERS = tuple(
    f"{the}{centers}{of}"
    for the in ("the ", "their ", "both ", "the two ", "its ", "")
    for centers in ("centers", "block centers", "middles")
    for of in ("", " of the blocks", " of the two blocks", " of both", " of both blocks")
)
_NEAR = (
    *(f"{be}{off} by"
      for be in ("", "being ", "are ", "may be ", "should be ", "must be ")
      for off in ("off", "differing", "apart", "shifted", "misaligned", "offset", "displaced", "deviating", "out")),
    "differ by", "may differ by", "should differ by", "deviate by", "may deviate by", "are", "being", "must be",
    "should be", "may be", "lie", "lying", "stay", "within", "are within", "to within", "stay within", "lie within",
    "must be within", "should be within", "aligned within", "aligned to within", "lined up within",
    "lined up to within", "aligned to",
)  # fmt: skip
_APART = ("apart", "of each other", "from each other", "off", "off each other", "away from each other")
_ACROSS = ("horizontally", "sideways", "laterally")
_SO = ("so that", "such that", "so", "where", "and")


@rule
def offset(p: Parser, i: int) -> Results[Loc]:
    """ "centred to within 5 mm", "with at most 5 mm offset", "offset by at most 5 mm": of what lies on what."""
    start = p.opt(i, "and")
    start = p.any_of(start, _EACH) or start
    if j := p.any_of(start, _CENTERED):
        yield from _limit(p, i, p.any_of(j, _WITHIN) or j)
    if j := p.any_of(start, _TOLERANCE):
        yield from _limit(p, i, j)
    lead = p.any_of(start, ("with", "at", "having"))
    lead = 0 if lead and p.words[start + 1] in ("most", "least") else lead
    j = p.opt(lead or start, "a", "an", "any")
    for far, k in _most(p, j):
        k = p.opt(p.opt(k, "of"), *_SIDEWAYS)
        if end := p.any_of(k, _OFFSET) or p.any_of(k, _OFF_CENTER):
            yield _loc(p, i, p.any_of(end, _OF_WHAT) or end, far)
        elif (end := p.any_of(k, _OFF)) and (end >= p.end or p.words[end] in _CLOSED):
            yield _loc(p, i, end, far)
    if end := p.any_of(j, _OFFSET) if start > i else 0:  # "each offset at most 3 mm from the one below"
        yield from (_loc(p, i, p.any_of(k, _OF_WHAT) or k, far) for far, k in _most(p, p.opt(end, "by")))
    yield from _centers(p, i, lead or p.any_of(i, _SO) or i) if p.rarely(_MIDDLES) else ()
    if end := p.any_of(j, ("off by", "off center by")):
        yield from (_loc(p, i, p.any_of(k, _OF_WHAT) or k, far) for far, k in _most(p, end))
    j = p.opt(j, "the")
    most = p.one(j, _MOST)
    k = p.opt(most or j, *_SIDEWAYS)
    if named := p.any_of(k, _OFFSET) or p.any_of(k, _OFF_CENTER):
        yield from _said(p, i, p.any_of(named, _OF_WHAT) or named, bool(most))


def _centers(p: Parser, i: int, at: int) -> Results[Loc]:
    """ "(with) their centers at most 5 mm apart", "the centers off by at most 5 mm"."""
    j = p.any_of(at, _CENTERS)
    end = p.any_of(j, _NEAR) or j if j else 0
    apart = [*_most(p, end), *(length(p, end) if p.words[end - 1] == "within" else ())] if end else []
    ends = ((far, p.any_of(k, _APART) or k) for far, k in apart)
    yield from (_loc(p, i, p.opt(end, *_ACROSS), far) for far, end in ends)


def _said(p: Parser, i: int, j: int, most: bool) -> Results[Loc]:
    """ "(the offset) may be at most 5 mm", "(offset) by no more than 5 mm"."""
    k = p.any_of(j, _MAY_BE) or p.opt(j, "by")
    if most or p.words[k - 1] == "exceed":
        yield from (_loc(p, i, end, far) for far, end in length(p, k))
    yield from (_loc(p, i, end, far) for far, end in _most(p, k))


def _most(p: Parser, i: int) -> Results[float]:
    """A length that is no more than so much."""
    yield from ((high, k) for (low, high), k in bounds(p, i) if low is None and high is not None)


def _limit(p: Parser, i: int, j: int) -> Results[Loc]:
    """What a centring is good to: "5 mm", "at most 5 mm"."""
    said = p.words[j - 1] not in _CENTERED and p.words[j - 1] not in ("aligned", "up")
    for far, k in [*(length(p, j) if said else ()), *_most(p, j)]:
        yield _loc(p, i, k, far)


def _loc(p: Parser, i: int, end: int, far: float) -> tuple[Loc, int]:
    return Loc(rel="offset", high=far, span=p.span(i, end)), end


_ON = ("on", "on top of", "over", "upon", "atop", "onto", "with respect to")


@rule
def centred_on(p: Parser, i: int) -> Results[Loc]:
    """ "centred on the blue block to within 5 mm", "in the middle of the mat": what lies how well on what."""
    start = p.one(p.opt(i, "well", "exactly", "precisely", "nicely"), ("centered", "aligned", "center"))
    on = p.any_of(start, _ON) if start else 0
    for mark, j in simple(p, on) if on else ():
        if isinstance(mark, Noun) and mark.head == "patch":
            mark = PartOf(part="middle", whole=mark, span=mark.span)
            yield Loc(rel="on", landmark=mark, span=p.span(i, j)), j
        lead = p.any_of(p.opt(j, ","), _WITHIN)
        found = [*_most(p, p.opt(j, ",")), *(_most(p, p.any_of(p.opt(j, ","), ("with", "within", "by")) or j))]
        found += length(p, lead) if lead else ()
        for far, end in dict.fromkeys(found):
            yield Loc(rel="on", landmark=mark, high=far, span=p.span(i, end)), end


@rule
def centering(p: Parser, i: int) -> Results[Clause]:
    """ "the horizontal offset may be at most 5 mm", "each block must be centred on the one below it within 1 cm"."""
    found = [*(offset(p, i) if p.stands(i, _NAMED) else ())]
    if j := p.any_of(i, _EACH_ON_THE_NEXT):
        found += _limit(p, i, p.any_of(j, _WITHIN) or j)
    if j := p.any_of(i, ("their centers", "the centers", "the centers of the blocks", "the block centers")):
        meet = p.any_of(p.any_of(j, _MUST) or j, _MEET)
        met = [*(_limit(p, i, p.any_of(meet, _WITHIN) or meet) if meet else ())]
        differ = p.any_of(j, _DIFFER)
        met += [_loc(p, i, end, far) for far, end in _most(p, differ)] if differ else []
        found += [(replace(far, mods=("all",)), end) for far, end in met]
    for far, end in found:
        yield Clause(verb="offset", adjuncts=(far,), mode="goal", span=p.span(i, end)), end
