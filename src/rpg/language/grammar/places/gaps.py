"""Distances as things: "a gap of 6 cm between ..."."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any, cast

from rpg.language.grammar.core import Parser, Results, rule
from rpg.language.grammar.places.absolutes import absolute
from rpg.language.grammar.places.denied_bounds import denied_bounds
from rpg.language.grammar.places.free_room import behind_room
from rpg.language.grammar.places.measures import AMONG, MEASURED_BETWEEN, NEXT, bounds, measured_so, room
from rpg.language.grammar.places.sides import at
from rpg.language.grammar.places.their_ends import their_ends
from rpg.language.grammar.talk.slots import Patterns
from rpg.language.grammar.things.amounts import length
from rpg.language.grammar.things.nouns import noun_phrase, simple
from rpg.language.meaning import (
    Amount,
    At,
    Chain,
    Clause,
    Coord,
    Loc,
    Meaning,
    Noun,
    Pronoun,
    Spacing,
    Structure,
    That,
    Traits,
    replace,
)

_GAPS = tuple(
    (noun, measure, (noun, f"of {noun}", f"wide {noun}", f"of free {noun}", f"of empty {noun}"),
     (f"{noun} from", f"{noun} of"))
    for noun, measure in (("gap", "faces"), ("space", "faces"), ("distance", "centres"), ("spacing", "centres"),
                          ("separation", "centres"), ("gaps", "faces"), ("spaces", "faces"), ("distances", "centres"))
)  # fmt: skip
"""Words for a distance, what it is measured between, what of them follows a length, and what precedes two blocks."""
_NOUNS = frozenset(noun for noun, *_ in _GAPS)
_THERE_BE = (
    "there is", "there are", "there remains", "there stays", "there is left",
    *(f"there {must} {be}" for must in ("should", "must", "has to", "needs to", "shall", "will", "is to")
      for be in ("be", "remain", "stay", "be left", "be kept")),
)  # fmt: skip
_LEAVE = ("leave", "keep", "have", "put", "make", "maintain", "leaving", *_THERE_BE)


_IS = (
    "is", "be", "comes to", "amounts to", "measures", "are", "being",
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
    for found, j in (*_left_between(p, i), *_between_first(p, i), *_limited(p, i)):
        yield found, j
        for far, end in measured_so(p, cast(Loc, found.adjuncts[0]), i, j) if p.rarely(_MEASURED) else ():
            if end > j:
                yield replace(found, adjuncts=(far,), span=p.span(i, end)), end
    for how, j in _measured_ahead(p, i) if p.rarely(_MEASURED) else ():
        for found, end in gap(p, j):
            far = replace(cast(Loc, found.adjuncts[0]), measure=how)
            yield replace(found, adjuncts=(far, *found.adjuncts[1:]), span=p.span(i, end)), end


_MEASURED = frozenset({"measured"})


def _measured_ahead(p: Parser, i: int) -> Results[str]:
    """ "Measured from centre to centre, (the distance is 8 cm)": between what of the blocks."""
    if p.stands(i, ("measured",)):
        yield from ((MEASURED_BETWEEN[phrase], p.opt(k, ",")) for phrase, k in p.standing(i, MEASURED_BETWEEN))


_ANY_TWO = ("any two of", "every two of", "each two of", "each pair of", "every pair of", "any pair of")
"""Behind these stand all of the blocks, of which so much is said of two at a time."""


def _parted(p: Parser, i: int) -> Results[Meaning]:
    """Behind "between": some blocks, or those side by side in a line."""
    if j := p.any_of(i, NEXT):
        yield Pronoun(word="them", span=p.span(i, j)), j
    if of := p.any_of(i, _ANY_TWO):
        yield from ((some, j) for some, j in simple(p, of) if isinstance(some, Noun) and some.plural)
    for told, j in noun_phrase(p, i):
        every = isinstance(told, Structure) and told.plural and p.stands(i, ("any", "every", "each", "neighboring"))
        yield (replace(told, det="the", amount=None) if every and isinstance(told, Structure) else told), j


_SAME = tuple(
    f"{are} {all_}{same}"
    for are in ("are", "should be", "must be", "have to be", "shall be", "being")
    for all_ in ("", "all ")
    for same in ("equal", "the same", "equally wide", "equally large", "of equal size", "of the same size",
                 "of equal width", "the same size", "even", "identical")
)  # fmt: skip


def _alike(p: Parser, i: int, j: int, theme: Meaning) -> Results[Clause]:
    """ "the gaps between them are equal"."""
    if end := p.any_of(j, _SAME):
        even = Spacing(kind="even", span=p.span(j, end))
        yield Clause(verb="be", theme=theme, adjuncts=(even,), mode="goal", span=p.span(i, end)), end


_THERE = ("leave", "keep", *_THERE_BE)


def _between_first(p: Parser, i: int) -> Results[Clause]:
    """ "between the red and the blue block there is a gap of 5 cm", "between A and B the distance must be 12 cm"."""
    m = p.one(i, "between")
    ends = p.any_of(m, _ENDS) if m else 0
    for theme, k in _parted(p, ends or m) if m else ():
        k = p.opt(k, ",")
        there = p.any_of(k, _THERE)
        j = p.opt(there or k, "a", "an", "the")
        measures = {"": "", **_CENTERS}[" ".join(p.words[m:ends])]
        for (low, high), end, measure in _wide(p, j) if there else ():
            yield _far_apart(p, i, end, theme, low, high, measures or measure), end
        for (low, high), end, measure in _wide(p, j) if j > k and not there else ():
            for last in _REMAINS.matches(p, end):  # "between A and B, a gap of 5 cm shall be left"
                yield _far_apart(p, i, last, theme, low, high, measures or measure), last
        for noun, measure, _, _ in _GAPS if not there else ():
            measure = measures or measure
            named = p.one(j, noun)
            told = p.any_of(named, _IS)
            for (low, high), end in (*(bounds(p, told) if told else ()), *denied_bounds(p, named)) if named else ():
                yield _far_apart(p, i, end, theme, low, high, measure), end


_CENTERS = {
    f"the {ends} of": measure
    for ends, measure in (("centers", "centres"), ("middles", "centres"), ("faces", "faces"), ("sides", "faces"))
}
_ENDS = tuple(_CENTERS)
_LIMIT = {**dict.fromkeys(("maximum", "largest"), False), **dict.fromkeys(("minimum", "smallest"), True)}


def _limited(p: Parser, i: int) -> Results[Clause]:
    """ "the maximum distance is 10 cm", "the minimum gap between the blocks is 2 cm"."""
    j = p.opt(i, "the", "with", "a")
    least = p.lex(j, _LIMIT)
    for noun, measure, _, _ in _GAPS if least is not None else ():
        k = p.one(p.opt(j + 1, "allowed"), noun)
        between = p.one(k, "between") if k else 0
        them = Pronoun(word="them", span=p.span(i, k or j))
        for theme, end in _parted(p, between) if between else [(them, k)]:
            told = p.any_of(end, _IS) or p.opt(end, "of", ":") if end else 0
            for metres, last in length(p, told) if told > end else ():
                low, high = (metres, None) if least else (None, metres)
                yield _far_apart(p, i, last, theme, low, high, measure), last


def _end_of(p: Parser, i: int) -> Iterator[tuple[Noun, str, int]]:
    """ "the middle of the red block", "the edge of A": a block, and what of it a distance is measured from."""
    for phrase, j in p.standing(i, _ENDS_OF):
        for block, k in simple(p, j):
            if isinstance(block, Noun) and block.head != "patch":
                yield block, _ENDS_OF[phrase], k


_REMAINS = Patterns(
    "remains|remain|stays|is",
    "is|are|must_be|should_be|shall_be|has_to_be|is_to_be|will_be "
    "left|kept|maintained|observed|provided|required|needed|wanted|prescribed|requested?",
    "must|should|shall remain|stay",
)
"""What may stand between how far things are apart and what these are."""


def _left_between(p: Parser, i: int) -> Results[Clause]:
    """ "leave a gap of 6 cm between the red and the green block": the distance comes first."""
    j = p.any_of(i, _LEAVE) or i
    j = p.opt(p.opt(j, "all"), "a", "an", "the")
    spans = list(_wide(p, j))
    named = p.stands(j, _NOUNS)
    for noun, measure, _, _ in _GAPS if named else ():
        if k := p.one(j, noun):
            m = p.any_of(k, ("between the faces of", "between", "of"))
            measure = "faces" if m and p.words[m - 2] == "faces" else measure
            theirs = [(Pronoun(word="them", span=p.span(i, k)), k)] if p.words[j - 1] in ("the", "all") else []
            for theme, end in _parted(p, m) if m else theirs:
                yield from _alike(p, i, end, theme)
                made = end if p.words[i] in ("make", "keep") else 0
                be = p.any_of(end, _IS) or made
                wide_ = [*bounds(p, be), *(room(p, be) if measure == "faces" else ())] if be else []
                wide_ += denied_bounds(p, end)
                for (low, high), last in wide_:
                    last = p.opt(last, "wide")
                    stated = _far_apart(p, i, last, theme, low, high, measure)
                    yield (replace(stated, mode="goal", lemma="fact") if p.words[end:be] in _STATED else stated), last
    for _, measure, _, before in _GAPS if named else ():
        yield from _from_to(p, i, p.any_of(j, before), measure)
    spans += [(b, e, "faces") for b, e in bounds(p, j)]
    if k := p.any_of(j, ("room for", "space for", "gap of", "space of", "enough room for", "enough space for")):
        spans += [(b, e, "faces") for b, e in room(p, k)]
    for (low, high), k, _ in spans:
        for one, measure, m in _end_of(p, k + 1) if p.one(k, "from") else ():
            for two, same, end in _end_of(p, m + 1) if p.one(m, "to") else ():
                if same == measure:
                    both = Coord(op="and", items=(one, two), span=p.span(k, end))
                    yield _far_apart(p, i, end, both, low, high, measure), end
    for (low, high), k, measure in spans:
        k = behind_room(p, k)
        if m := p.one(max(_REMAINS.matches(p, k), default=k), "between"):
            if centres := p.any_of(m, ("the centers of", "centers of", "the middles of")):
                m, measure = centres, "centres"
            if faces := p.any_of(m, ("the faces of", "faces of", "the sides of")):
                m, measure = faces, "faces"
            for one, same, of in _end_of(p, m):
                for two, other, end in _end_of(p, of + 1) if p.one(of, "and") else ():
                    both = Coord(op="and", items=(one, two), span=p.span(m, end))
                    yield from [(_far_apart(p, i, end, both, low, high, same), end)] if same == other else ()
            for ends, end in their_ends(p, m):
                yield _far_apart(p, i, end, Pronoun(word="them", span=p.span(m, end)), low, high, ends), end
            for told, end in _parted(p, m):
                if _alone(told) and p.stands(end, ("and",)):
                    continue  # "between red and green, with blue on it": not "between red"
                theme = _its_own(told) if p.words[i] == "leaving" else told
                apart = _far_apart(p, i, end, theme, low, high, measure)
                for far, last in measured_so(p, cast(Loc, apart.adjuncts[0]), i, end):
                    yield replace(apart, adjuncts=(far,), span=p.span(i, last)), last
                yield from _with_side(p, i, end, apart)
                for beside, last in absolute(p, p.opt(end, ",")) if p.stands(p.opt(end, ","), ("with",)) else ():
                    yield replace(apart, adjuncts=(*apart.adjuncts, beside), span=p.span(i, last)), last


def _wide(p: Parser, j: int) -> Iterator[tuple[Any, int, str]]:
    """ "gap of 6 cm", "6 cm gap": how wide it is, and between what of the blocks."""
    told = bounds(p, j)
    for noun, measure, behind, _ in _GAPS if told or p.stands(j, _NOUNS) else ():
        of = p.one(k, "of") if (k := p.one(j, noun)) else 0
        yield from ((b, e, measure) for b, e in (bounds(p, of) if of else ()))
        yield from ((b, e, measure) for b, k in told if (e := p.any_of(k, behind)))


def apart_by(p: Parser, i: int, j: int, theme: Meaning) -> Results[Clause]:
    """ "(red and blue have) a gap of 6 cm between them"."""
    for (low, high), k, measure in _wide(p, p.opt(j, "a", "an")):
        if end := p.any_of(k, AMONG):
            yield _far_apart(p, i, end, theme, low, high, measure), end


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
            for (low, high), last in (*(bounds(p, told) if told else ()), *denied_bounds(p, end)) if both else ():
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


_STATED = (["is"], ["are"])
"""So it is told how it is, as of places: "red is right of white. The distance is 15 cm"."""


def _alone(told: Meaning) -> bool:
    """A single block, which has nothing between it."""
    if not isinstance(told, Noun) or told.plural or told.amount not in (None, Amount(1, 1)):
        return False
    return told.det in ("the", "a", "bare") and len(told.traits.colors + told.traits.labels) == 1


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
