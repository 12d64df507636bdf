"""Requests that say only what is to be otherwise: "green on top", "six", "3x2", "black", "a T instead of the plus"."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace

from rpg.steer.places import place
from rpg.steer.requests import requests as r
from rpg.steer.requests.changing import becomes
from rpg.steer.requests.language import (
    Parser,
    colors,
    count,
    dimensions,
    in_lines,
    lexicon,
    literal,
    longest,
    m,
    noun_phrase,
    phrases,
    region_name,
)
from rpg.steer.requests.phrases import fresh

_GOES = (
    "goes | go | should go | must go | has to go | needs to go | belongs | comes | should come | should be | must be | "
    "sits | should sit | stands | should stand | is to be | is to go | also goes | will go | lies | should lie | "
    "should be placed | is placed | gets placed | should be put | has to be | can go | could go | may go"
)
_LEADS = (
    "do | make | make it | build | build it as | form | have | try | i want | turn it into | change it to | use | "
    "change it into | it should be | let it be | arrange them in | arrange them as | make them | put them in | "
    "let us do | let us have | go for"
)


@dataclass(frozen=True, slots=True, kw_only=True)
class Tint(r.Request):
    """A colour alone: of what was spoken of last, or of blocks that all look alike."""

    color: str


@dataclass(frozen=True, slots=True, kw_only=True)
class Bound(r.Request):
    """How many of those that are counted: "exactly", "at_least", "at_most" so many; "as_now": what it is now. `amount`
    is None for all of them."""

    bound: str
    amount: int | None


@dataclass(frozen=True, slots=True, kw_only=True)
class Bring(r.Request):
    """Something that the task does not have, by its colour or its symbol alone, comes to a place."""

    theme: m.Noun
    place: r.Place


@dataclass(frozen=True, slots=True, kw_only=True)
class Shift(r.Request):
    """A place alone: the only relation, or the only region, of the goal is another one. `former`: what it is so far."""

    place: r.Place
    former: m.In | None = None


@dataclass(frozen=True, slots=True, kw_only=True)
class More(r.Request):
    """One more, and nothing else said: "another red cube", "and one more"."""

    theme: m.Noun


@dataclass(frozen=True, slots=True, kw_only=True)
class PileUp(r.Request):
    """Blocks that lie together form a stack where they are."""


def terse(p: Parser, i: int) -> Iterator[tuple[r.Request, int]]:
    """Every such request; what else it could be comes first."""
    yield from _on(p, i)
    yield from _rather(p, i)
    if i < 2 or p.words[i - 1] != "and":
        yield from _alone(p, i)
        yield from _shifted(p, i)
    yield from _stacked(p, i)
    yield from _tinted(p, i)


_FURTHER = frozenset({"and", "also", "plus"})
"""Behind these "the green one" may be one more: "and the green one on top of that"."""


def _on(p: Parser, i: int) -> Iterator[tuple[r.Request, int]]:
    """Phrases such as "green on top", "a 4 goes on top", "4 underneath": something new at a place."""
    for theme, j in noun_phrase(p, i):
        if not isinstance(theme, m.Noun) or theme.head == "patch":
            continue
        further = theme.det == "the" and p.follows(i, _FURTHER)
        named = theme.det == "bare" or further
        named = named and not theme.plural and theme.part_of is None and theme.amount is None
        one = max(len(theme.traits.colors), len(theme.traits.labels)) == 1 and not theme.conditions
        if not (fresh(theme) and theme.det == "a") and not (named and one):
            continue
        k = longest(p, j, _GOES) or j
        for where, end in place(p, k):
            if further and k > j:
                continue  # "and the orange one goes to the end" is one that is there
            if k > j or isinstance(where, r.Spot) or named:
                if named:
                    new = replace(theme, det="a", amount=m.Amount(1, 1))
                    yield Bring(theme=new, place=where, span=p.span(i, end), cost=5), end
                else:
                    yield r.Add(theme=theme, places=(where,), span=p.span(i, end), cost=5), end


def _rather(p: Parser, i: int) -> Iterator[tuple[r.Request, int]]:
    """Phrases such as "do a T instead of the plus", "make it a square rather than a circle"."""
    start = longest(p, i, _LEADS) or i
    for shape, j in noun_phrase(p, start):
        end = p.one(j, frozenset({"instead", "rather"}))
        if end and isinstance(shape, m.Structure) and shape.det in ("a", "bare") and _plainly(shape):
            yield r.Reshape(structure=shape, span=p.span(i, end), cost=3), end
        n = longest(p, j, "instead of | rather than | in place of | and not | , not | not")
        for given_up, end in noun_phrase(p, n) if n and isinstance(shape, m.Structure) else ():
            if isinstance(given_up, m.Structure) and isinstance(shape, m.Structure) and _plainly(given_up):
                theme = replace(given_up, det="the")
                yield r.Reshape(structure=shape, theme=theme, span=p.span(i, end), cost=1), end


def _plainly(given_up: m.Structure) -> bool:
    """Whether a structure is only named: what is said after it is of the new one."""
    return given_up.members is None and not given_up.details and given_up.traits == r.NO_TRAITS


_BOUNDS = {"exactly": "exactly", "only": "exactly", "just": "exactly", "at least": "at_least", "at most": "at_most"}


def _alone(p: Parser, i: int) -> Iterator[tuple[r.Request, int]]:
    """A number, dimensions, a colour or a word with nothing else in the sentence."""
    start = longest(p, i, "make it | make that | say | only | just | in") or i
    for n, j in count(p, start):
        if j == p.end or p.words[j] in (",", ".", "please", "now", "instead", "rather"):
            yield r.Recount(theme=None, amount=n, what="number", span=p.span(i, j), cost=4), j
            yield Bound(bound="as_now", amount=n, span=p.span(i, j), cost=5), j
    if j := longest(p, start, "both of them | all of them | every one of them | all | both"):
        amount = 2 if p.words[start] == "both" else None
        yield Bound(bound="as_now", amount=amount, span=p.span(i, j), cost=5), j
    for n, j in count(p, i):
        k = longest(p, j, "more | more of them | more block | more blocks | more cube | more cubes")
        if k and (k == p.end or p.words[k] in (",", ".", "please")):
            yield r.Recount(theme=None, by=n, what="number", span=p.span(i, k), cost=4), k
    more = longest(p, i, "another | one more | a further | an additional | two more | three more | one extra")
    ranked = p.one(i, "a") and p.lex(i + 1, lexicon.ORDINAL)
    for theme, j in noun_phrase(p, i) if more or ranked else ():
        if isinstance(theme, m.Noun) and fresh(theme) and theme.head != "patch" and not theme.conditions:
            yield More(theme=theme, span=p.span(i, j), cost=5), j
    for dims, j in dimensions(p, start):
        yield r.Recount(theme=None, dims=dims, lines=in_lines(p, start, j), span=p.span(i, j), cost=4), j
    for n, j in count(p, start):
        if end := longest(p, j, "of them | of those | of these"):
            yield Bound(bound="as_now", amount=n, span=p.span(i, end)), end
    for phrase, bound in _BOUNDS.items():
        k = p.seq(i, phrase)
        for n, j in count(p, k) if k else ():
            end = longest(p, j, "of them | of those | of these | of the blocks | blocks | block") or j
            yield Bound(bound=bound, amount=n, span=p.span(i, end), cost=2), end
    for (listed, _), j in colors(p, start):
        if len(listed) == 1:
            yield Tint(color=listed[0], span=p.span(i, j), cost=5), j
    for theme, j in noun_phrase(p, i):
        k = p.opt(j, ":", "=")
        if not isinstance(theme, m.Noun) or theme.det not in (("the", "bare") if k > j else ("the",)):
            continue
        if theme.conditions:
            continue
        for found, end in becomes(p, i, k, replace(theme, det="the"), cost=4):
            if isinstance(found, r.Restyle) and not found.traits.labels:
                yield found, end
    text = literal(p, i)
    first = i == 0 or p.words[i - 1] in (",", ".", "!", "please", "now", "no")
    if first and text is not None and len(text) > 1 and text.isalpha():
        word = m.Structure(kind="word", letter=text.upper(), span=p.span(i, i + 1))
        yield r.Reshape(structure=word, span=p.span(i, i + 1), cost=5), i + 1


_COLOR = phrases(
    "the color | its color | their color | the colors | their colors | the color of it | the color of them | "
    "the color of all blocks | the color of the blocks | the colors of the blocks | the color of the cubes"
)


def _tinted(p: Parser, i: int) -> Iterator[tuple[r.Request, int]]:
    """Phrases such as "change the colour to green", "the colour should be pink"."""
    lead = longest(p, i, "change | set | switch | turn | make | alter | modify") or i
    j = longest(p, lead, _COLOR)
    k = longest(p, j, "to | into | should be | must be | be | has to be | to be | is now | shall be") if j else 0
    for (listed, _), end in colors(p, k) if k else ():
        if len(listed) == 1:
            yield Tint(color=listed[0], span=p.span(i, end)), end


_WHERE = (
    "i meant | rather | should be | now | better | make it | make that | have it | let it be | it should be | "
    "it must be | i want it | it has to be | it goes | it should go | i mean | i meant to say | make them"
)
_SIDES = {
    "to the left": "left", "on the left": "left", "left of it": "left", "left": "left", "to its left": "left",
    "to the right": "right", "on the right": "right", "right of it": "right", "right": "right", "to its right": "right",
    "in front": "front", "in front of it": "front", "behind": "behind", "behind it": "behind",
    "on its left": "left", "on its right": "right", "to the left of it": "left", "to the right of it": "right",
    "on top of it": "on", "on it": "on", "under it": "under", "underneath it": "under", "below it": "under",
    "next to it": "beside", "beside it": "beside", "on the left of it": "left", "on the right of it": "right",
}  # fmt: skip


def _shifted(p: Parser, i: int) -> Iterator[tuple[r.Request, int]]:
    """Phrases such as "to the right", "behind it", "on top of the brown block", "in the far corner", said alone."""
    start = longest(p, i, _WHERE) or i
    for phrase, rel in _SIDES.items():
        if j := p.seq(start, phrase):
            where = m.Loc(rel=rel, span=p.span(start, j))
            yield Shift(place=where, span=p.span(i, j), cost=3), j
    for place_, j in place(p, start):
        if isinstance(place_, m.In) or (isinstance(place_, m.Loc) and isinstance(place_.landmark, m.Noun)):
            yield Shift(place=place_, span=p.span(i, j), cost=3), j
    for name, j in region_name(p, p.opt(start, "the")):
        yield Shift(place=m.In(region=name, span=p.span(i, j)), span=p.span(i, j), cost=3), j
        n = longest(p, j, ", not | not | instead of | rather than | and not | , and not")
        for lost, end in region_name(p, longest(p, n, "in the | the | in") or n) if n else ():
            former = m.In(region=lost, span=p.span(n, end))
            there = m.In(region=name, span=p.span(i, j))
            yield Shift(place=there, former=former, span=p.span(i, end), cost=3), end
    n = longest(p, i, "not in the | not the | not in | not")
    for lost, j in region_name(p, n) if n else ():
        former = m.In(region=lost, span=p.span(n, j))
        k = longest(p, j, ", but in the | , but the | but in the | but the | , in the | , the | ,")
        for name, end in region_name(p, k) if k else ():
            there = m.In(region=name, span=p.span(k, end))
            yield Shift(place=there, former=former, span=p.span(i, end), cost=3), end
    j = longest(p, i, "to right | to left | in right | in left | to the")
    half = f"{p.words[j - 1]}_half" if j and p.words[j : j + 1] == ["half"] else ""
    if half in ("left_half", "right_half"):
        yield Shift(place=m.In(region=half, span=p.span(i, j + 1)), span=p.span(i, j + 1), cost=3), j + 1


_PILED = (
    "stacked | in a stack | as a stack | stacked up | stacked on each other | "
    "on top of each other | on top of one another | in a pile on top of each other | in one stack | as one stack"
)


def _stacked(p: Parser, i: int) -> Iterator[tuple[r.Request, int]]:
    """Phrases such as "stacked", "on every mat they should be stacked"."""
    start = longest(p, i, _ON_EACH) or i
    start = p.opt(start, ",")
    start = (
        longest(
            p,
            start,
            "they should be | they must be | they should lie | they have to be | the blocks should be | have them | "
            "the blocks must be | make them | i want them | but | all | it should be | let them be | should be",
        )
        or start
    )
    j = longest(p, start, _PILED)
    if j and (end := longest(p, j, _ON_EACH) or j):
        yield PileUp(span=p.span(i, end), cost=1), end


_ON_EACH = tuple(
    f"{on} {each} {mat}"
    for on in ("on", "at")
    for each in ("every", "each", "the", "both", "all", "all the")
    for mat in ("mat", "patch", "mats", "patches", "target", "targets", "area", "zone", "pad", "pads", "spot")
)
