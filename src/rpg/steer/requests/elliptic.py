"""Requests without a verb: "four steps", "one layer higher", "all blue", "the other way round", "in the far corner"."""

from __future__ import annotations

from collections.abc import Iterator

from rpg.steer.places import place
from rpg.steer.requests import requests as r
from rpg.steer.requests.amounts import BLOCKS, LONG, TALL, by_so_many
from rpg.steer.requests.language import (
    Parser,
    colors,
    count,
    dimensions,
    in_lines,
    length,
    loc,
    longest,
    m,
    phrases,
    region_name,
    simple,
)

_ALL = "all | everything | all of it | all of them | everything in | all in | all of them in | both | both in | each in"
_EACH = (
    "of each color | of each | of every color | of each kind | for each color | in each color | blocks of each color | "
    "per color | of both colors | of either color"
)


def elliptic(p: Parser, i: int) -> Iterator[tuple[r.Request, int]]:
    """What only says how it is to be, with nothing but small words before it."""
    yield from _of_each(p, i)
    yield from _some(p, i)
    yield from _enough(p, i)
    yield from _copies(p, i)
    yield from _climbing(p, i)
    yield from _divided(p, i)
    yield from _directly(p, i)
    if j := longest(p, i, "alternate the colors | with alternating colors | alternating colors | colors alternating"):
        yield r.Reorder(how="alternating", span=p.span(i, j)), j
    yield from turned(p, i)
    yield from across(p, i)
    yield from _distance(p, i)
    if i and p.words[i - 1] == "and":
        return
    yield from _counted(p, i)
    yield from _colored(p, i)
    yield from _placed(p, i)


def _counted(p: Parser, i: int) -> Iterator[tuple[r.Request, int]]:
    """Phrases such as "four steps", "five high", "exactly three blocks wide", "one layer higher"."""
    lead = longest(p, i, "only | just | exactly") or i
    for n, j in count(p, lead):
        for units, what in ((TALL, "height"), (LONG, "length"), (BLOCKS, "blocks")):
            end = longest(p, j, units)
            if end and p.words[end - 1] != "them":
                yield r.Recount(theme=None, amount=n, what=what, span=p.span(i, end), cost=3), end
    yield from by_so_many(p, i, i, None)


def _of_each(p: Parser, i: int) -> Iterator[tuple[r.Request, int]]:
    """Phrases such as "two of each colour", "only use three of each"."""
    lead = longest(p, i, "use | have | take | with | make it | only use | just use | let there be | use only") or i
    lead = longest(p, lead, "only | just | exactly") or lead
    for n, j in count(p, lead):
        if end := longest(p, j, _EACH):
            yield r.Recount(theme=None, amount=n, what="each", span=p.span(i, end)), end


def _copies(p: Parser, i: int) -> Iterator[tuple[r.Request, int]]:
    """Phrases such as "I want two towers like that", "make three of those", "build it twice"."""
    start = (
        longest(p, i, "i want | i would like | make | build | i need | have | give me | let there be | we need") or i
    )
    for n, j in count(p, start):
        for noun, kind in (("towers", "tower"), ("stacks", "tower"), ("rows", "row"), ("of those", None)):
            k = p.seq(j, noun)
            end = longest(p, k, "like that | like this | like it | of that kind | like these | of these") if k else 0
            end = k if k and kind is None and start > i else end
            if end:
                yield r.Copies(amount=n, kind=kind, span=p.span(i, end)), end
    for phrase in ("build it twice", "make it twice", "do it twice", "the same thing twice", "double it up"):
        if j := p.seq(i, phrase):
            yield r.Copies(amount=2, span=p.span(i, j)), j


def _divided(p: Parser, i: int) -> Iterator[tuple[r.Request, int]]:
    """Phrases such as "make three of them red and two of them blue"."""
    j = longest(p, i, "make | paint | color | let | have | turn | with") or i
    parts: list[tuple[int, str]] = []
    while True:
        part = next(_share(p, j), None)
        if part is None:
            return
        number, color, j = part
        parts.append((number, color))
        if len(parts) > 1:
            yield r.Divide(parts=tuple(parts), span=p.span(i, j)), j
        k = longest(p, j, ", and | and | , | ; | but")
        if not k:
            return
        j = k


def _share(p: Parser, i: int) -> Iterator[tuple[int, str, int]]:
    """One part: "three of them red", "two blue", "the other two green"."""
    start = longest(p, i, "the other | the remaining | the last | the first") or i
    for number, j in count(p, start):
        j = longest(p, j, "of them | of the blocks | of those | blocks | should be | must be") or j
        j = longest(p, j, "should be | must be | in") or j
        for (listed, _), k in colors(p, j):
            if len(listed) == 1:
                yield number, listed[0], k


def _directly(p: Parser, i: int) -> Iterator[tuple[r.Request, int]]:
    """Phrases such as "directly behind it", "right next to it on the left": the relation that there is, only closer."""
    start = longest(p, i, "it should be | it must be | but | put it | it has to be") or i
    for where, j in loc(p, start):
        if isinstance(where, m.Loc) and isinstance(where.landmark, m.Pronoun) and where.mods:
            yield r.Closer(rel=where.rel, mods=where.mods, span=p.span(i, j), cost=4), j


_UP = tuple(
    f"{how} to the"
    for verb in ("go", "going", "goes", "rise", "rising", "climb", "climbing", "lead", "leading", "rises", "ascend")
    for how in ((f"{verb} up", verb) if verb not in ("go", "going", "goes", "lead", "leading") else (f"{verb} up",))
)


def _climbing(p: Parser, i: int) -> Iterator[tuple[r.Request, int]]:
    """Phrases such as "it should go up to the left", "make the stairs rise to the right"."""
    verb = longest(p, i, "make | let | have") or i
    for _, j in [*simple(p, verb), *[(None, i)]]:
        k = longest(p, j, "should | must | has to | have to | needs to | is | are | instead") or j
        k = longest(p, k, _UP)
        if k and p.words[k : k + 1] and p.words[k] in ("left", "right", "front", "back"):
            yield r.Climb(to=p.words[k], span=p.span(i, k + 1)), p.reach(k + 1)


_ARE_THERE = phrases(
    "of them do | of them are | of them are there | of them are on it | of them lie there | of them lie on it | "
    "of them do that | of them do so | of them are in it | of them are in there"
)
_NEEDED = phrases(
    "of them have to be there | of them need to be there | of them have to | of them need to | of them has to | "
    "of them needs to | of them have to be on it | of them need to be on it | of them are needed there"
)
_SUFFICES = phrases(
    "is enough | are enough | will do | would do | would be enough | should be enough | suffices | suffice | "
    "is sufficient | are sufficient | will be enough | is plenty | are plenty | is fine | are fine | would be fine"
)


def _enough(p: Parser, i: int) -> Iterator[tuple[r.Request, int]]:
    """Phrases such as "2x2 is enough", "four blocks will do", "only two of them have to"."""
    start = longest(p, i, "only | just | a | an") or i
    for dims, j in dimensions(p, start):
        if end := longest(p, longest(p, j, "grid | square | wall | one") or j, _SUFFICES):
            yield r.Recount(theme=None, dims=dims, lines=in_lines(p, start, j), span=p.span(i, end)), end
    for n, j in count(p, start):
        k = longest(p, j, BLOCKS) or longest(p, j, TALL) or longest(p, j, LONG) or j
        if end := longest(p, k, _SUFFICES):
            of_them = p.words[k - 1] == "them"
            yield r.Enough(amount=n, of_them=of_them, span=p.span(i, end)), end
        if end := longest(p, j, _NEEDED):
            yield r.Some(bound="at_least", amount=n, span=p.span(i, end)), end


_BOUNDS = {"exactly": "exactly", "only": "exactly", "at least": "at_least", "at most": "at_most"}


def _distance(p: Parser, i: int) -> Iterator[tuple[r.Request, int]]:
    """Phrases such as "make it 15 cm", "20 cm instead": the distance that the goal states."""
    start = longest(p, i, "make it | change it to | it should be | make that | change that to | let it be") or i
    for metres, j in length(p, start):
        end = longest(p, j, "instead | apart | away | instead of that") or j
        yield r.Loosen(what="distance", value=metres, bare=True, span=p.span(i, end), cost=3), end


def _some(p: Parser, i: int) -> Iterator[tuple[r.Request, int]]:
    """Phrases such as "exactly three of them", "at least two of them"."""
    start = longest(p, i, "only | just | make it | it is enough if | it is enough that") or i
    for phrase, bound in _BOUNDS.items():
        j = p.seq(start, phrase)
        for n, k in count(p, j) if j else ():
            if end := longest(p, k, "of them | of the blocks | of those | of these | of the cubes"):
                yield r.Some(bound=bound, amount=n, span=p.span(i, end)), end
    j = longest(p, i, "it is enough if | it is enough that | it is enough when | it suffices if | it suffices that")
    for n, k in count(p, p.opt(j, "only", "just")) if j else ():
        if end := longest(p, k, _ARE_THERE):
            yield r.Some(bound="at_least", amount=n, span=p.span(i, end)), end
    j = p.seq(i, "at least")
    for n, k in count(p, j) if j else ():
        if end := longest(p, k, _NEEDED):
            yield r.Some(bound="at_least", amount=n, span=p.span(i, end)), end


def _colored(p: Parser, i: int) -> Iterator[tuple[r.Request, int]]:
    if j := longest(p, i, _ALL):
        everything = m.Pronoun(word="them", span=p.span(i, j))
        for (listed, either), end in colors(p, j):
            traits = m.Traits(colors=listed, either=either)
            yield r.Restyle(theme=everything, traits=traits, span=p.span(i, end), cost=2), end


def _placed(p: Parser, i: int) -> Iterator[tuple[r.Request, int]]:
    """A place alone: where what was spoken of last has to be."""
    start = longest(p, i, "use | take | try | choose | make it | go for | i prefer | rather")
    for name, j in region_name(p, p.opt(start, "the")) if start else ():
        there = m.In(region=name, span=p.span(start, j))
        yield r.Move(theme=m.Pronoun(word="it", span=p.span(i, i + 1)), place=there, span=p.span(i, j), cost=4), j
    for name, j in region_name(p, p.opt(i, "the")) if not start else ():
        if p.one(j, "instead"):
            there = m.In(region=name, span=p.span(i, j))
            yield r.Move(theme=m.Pronoun(word="it", span=p.span(i, i + 1)), place=there, span=p.span(i, j), cost=4), j
    for where, j in place(p, i):
        if isinstance(where, m.In | m.Loc) and not _of_itself(where):
            yield r.Move(theme=m.Pronoun(word="it", span=p.span(i, i + 1)), place=where, span=p.span(i, j), cost=4), j


def _of_itself(where: m.Meaning) -> bool:
    return isinstance(getattr(where, "landmark", None), m.Pronoun)


_WAYS = {
    "to the left": "left", "on the left": "left", "left": "left", "to the right": "right", "on the right": "right",
    "right": "right", "in front": "front", "in the front": "front", "before": "front", "behind": "behind",
    "in the back": "behind", "at the back": "behind",
}  # fmt: skip


def _way(p: Parser, i: int) -> Iterator[tuple[str, int]]:
    """A direction, of whatever it was: "to the left", "behind it"."""
    for phrase, way in _WAYS.items():
        if j := p.seq(i, phrase):
            yield way, longest(p, j, "of it | of that | it | of them | of") or j


_OTHER_SIDE = tuple(
    f"{lead} {other} side{of}".strip()
    for lead in ("on", "to", "")
    for other in ("the other", "the opposite", "its other")
    for of in ("", " of it", " of that", " of the table")
)
_TAKEN = "move | put | place | shift | bring | push | slide | set"
_BELONGS = "should be | must be | should go | goes | belongs | has to be | should stand | should move | must go"


def across(p: Parser, i: int) -> Iterator[tuple[r.Request, int]]:
    """Phrases such as "on the other side", "move the blue one to the opposite side"."""
    verb = longest(p, i, _TAKEN)
    starts: list[tuple[m.Meaning | None, int]] = [(None, i)] if i == 0 or p.words[i - 1] != "and" else []
    for theme, k in simple(p, verb or i):
        k = k if verb else longest(p, k, _BELONGS)
        starts += [(theme, k)] if k else []
    for what, k in starts:
        if end := longest(p, k, _OTHER_SIDE):
            yield r.Across(theme=what, span=p.span(i, end)), end


_BETTER = phrases("would be better than | is better than | would be nicer than | looks better than | is nicer than")


def turned(p: Parser, i: int) -> Iterator[tuple[r.Request, int]]:
    """Phrases such as "to the right instead of to the left", "behind it, not in front of it", "not left, right"."""
    start = longest(p, i, "it should be | it must be | make it | put it | i want it | it has to be") or i
    for to, j in _way(p, start):
        k = longest(p, j, ", not | not | instead of | rather than | , and not | and not | , instead of | , rather than")
        for old, end in _way(p, k) if k else ():
            if to != old:
                yield r.Turn(to=to, old=old, span=p.span(i, end)), end
    for to, j in _way(p, start):
        k = longest(p, j, _BETTER)
        for old, end in _way(p, k) if k else ():
            if to != old:
                yield r.Turn(to=to, old=old, span=p.span(i, end)), end
    n = p.one(i, "not")
    for old, j in _way(p, n) if n else ():
        k = longest(p, j, ", but | but | ,")
        for to, end in _way(p, k) if k else ():
            if to != old:
                yield r.Turn(to=to, old=old, span=p.span(i, end)), end
