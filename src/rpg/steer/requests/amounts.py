"""Requests about numbers: how many blocks, how large a figure."""

from __future__ import annotations

from collections.abc import Iterator

from rpg.steer.requests import requests as r
from rpg.steer.requests.language import Parser, count, dimensions, in_lines, longest, m, phrases, simple
from rpg.steer.requests.phrases import old

TALL = phrases(
    "blocks tall | blocks high | block tall | block high | tall | high | levels | layers | levels high | "
    "layers high | steps | steps high | levels tall | cubes tall | cubes high | layers tall | stories "
    "high | stories"
)
LONG = ("blocks long", "blocks wide", "long", "wide", "cubes long", "cubes wide", "in length", "blocks in length")
BLOCKS = (
    "blocks",
    "cubes",
    "block",
    "cube",
    "pieces",
    "letters",
    "bricks",
    "of them",
    "blocks in total",
    "blocks total",
)
_WHAT = {"taller": "height", "higher": "height", "lower": "height", "longer": "length", "wider": "length"}
_MORE = {"taller": 1, "higher": 1, "longer": 1, "shorter": -1, "lower": -1, "wider": 1, "bigger": 1, "smaller": -1}


def recount(p: Parser, i: int) -> Iterator[tuple[r.Request, int]]:
    """Phrases such as "make it five blocks tall", "make it two blocks taller", "use four blocks"."""
    for theme, j in _subjects(p, i):
        yield from _to(p, i, j, theme)
        yield from by_so_many(p, i, j, theme)
    if j := longest(
        p, i, "use | with | have | only use | use only | just use | make it with | build it with | do it with"
    ):
        j = p.opt(j, "only", "just")
        for n, k in count(p, j):
            if end := longest(p, k, BLOCKS):
                end = _instead_of(p, end)
                yield r.Recount(theme=None, amount=n, span=p.span(i, end)), end
    yield from _brought_to(p, i)
    k = longest(p, longest(p, i, "give it | give the pyramid | it needs | it should have | i want | with") or i, _OF)
    for n, j in count(p, k) if k else ():
        end = longest(p, j, BLOCKS) or j
        what = "height" if "height" in p.words[i:k] else "length"
        yield r.Recount(theme=None, amount=n, what=what, span=p.span(i, end)), end
    lead = longest(p, i, "only | just | with | with only | use | use only | have | make it | exactly") or i
    for n, j in count(p, lead):
        if end := longest(p, longest(p, j, BLOCKS) or j, _AT_BASE):
            yield r.Recount(theme=None, amount=n, what="length", span=p.span(i, end)), end
    each = longest(p, i, _EACH_ONE)
    for n, j in count(p, each) if each else ():
        if end := longest(p, j, (*TALL, *LONG)):
            them = m.Pronoun(word="each of them", span=p.span(i, each))
            yield r.Recount(theme=them, amount=n, what="height", span=p.span(i, end)), end
    lead = longest(p, i, "make | make it | make them | with | use | only | just | now") or i
    for n, j in count(p, lead):
        k = longest(p, j, (*TALL, *BLOCKS)) or j
        if end := longest(p, k, "each | in each | in each of them | in every tower | in each tower | per tower"):
            them = m.Pronoun(word="each of them", span=p.span(i, end))
            yield r.Recount(theme=them, amount=n, what="height", span=p.span(i, end)), end
    yield from _multiplied(p, i)
    yield from _plain_count(p, i)
    for phrase, by in (("extend", 1), ("lengthen", 1), ("shorten", -1), ("grow", 1)):
        j = p.seq(i, phrase)
        for theme, k in simple(p, j) if j else ():
            for n, end in _so_many(p, k):
                yield r.Recount(theme=theme, by=by * n, span=p.span(i, end)), end


_AT_BASE = tuple(
    f"{at} the {base}"
    for at in ("in", "at", "on", "for", "as")
    for base in ("base", "bottom row", "bottom layer", "lowest row", "lowest layer", "bottom", "base row", "base layer")
)
_BRINGS = phrases(
    "enlarge | make it grow | reduce | cut | cut down | cut back | trim | shorten | bring | bring down | limit | "
    "lower | increase | raise | "
    "extend | grow | stretch | expand | shrink | lengthen | go | go down | go up | scale | scale down | "
    "scale up | build"
)
_HEIGHTS = phrases(
    "its height | the height | their height | its length | the length | the number of blocks | the count | "
    "the number of cubes | the number of pieces | the number of bricks"
)


def _brought_to(p: Parser, i: int) -> Iterator[tuple[r.Request, int]]:
    """Phrases such as "reduce it to two blocks", "cut the tower down to three"."""
    j = longest(p, i, _BRINGS)
    starts: list[tuple[m.Meaning | None, int]] = [(None, j)] if j else []
    for whole, k in simple(p, j) if j else ():
        if isinstance(whole, m.Structure | m.Pronoun):
            starts += [(whole, k), (whole, p.opt(k, "down", "up", "back"))]
    if j and (k := longest(p, j, _HEIGHTS)):
        starts.append((None, k))
    for theme, k in dict.fromkeys(starts):
        if n := longest(p, k, "to | down to | up to | back to | to only | to just | down to just | to a height of"):
            for amount, end in count(p, n):
                stop = longest(p, end, (*BLOCKS, *TALL, *LONG, "only")) or end
                what = "height" if longest(p, end, "steps | levels | layers | stories") else "blocks"
                yield r.Recount(theme=theme, amount=amount, what=what, span=p.span(i, stop)), stop
            for dims, end in dimensions(p, n):
                yield r.Recount(theme=theme, dims=dims, lines=in_lines(p, n, end), span=p.span(i, end)), end


def _multiplied(p: Parser, i: int) -> Iterator[tuple[r.Request, int]]:
    """Phrases such as "double its height", "make it twice as tall"."""
    for word, times in (("double", 2.0), ("halve", 0.5), ("triple", 3.0)):
        j = p.one(i, word)
        if j and (k := longest(p, j, _HEIGHTS)):
            yield r.Recount(theme=None, times=times, span=p.span(i, k)), k
        for whole, k in simple(p, j) if j else ():
            if isinstance(whole, m.Structure) and whole.det == "the":
                end = longest(p, k, "in height | in length | in size") or k
                yield r.Recount(theme=whole, times=times, span=p.span(i, end)), end
    for theme, j in _subjects(p, i):
        for phrase, times in (("twice", 2.0), ("double", 2.0), ("half", 0.5), ("three times", 3.0)):
            if k := longest(p, j, tuple(f"{phrase} {how}" for how in _AS_TALL)):
                yield r.Recount(theme=theme, times=times, span=p.span(i, k)), k


_AS_TALL = ("as tall", "as high", "as long", "the height", "the length", "as wide")


def _plain_count(p: Parser, i: int) -> Iterator[tuple[r.Request, int]]:
    """Phrases such as "just three blocks", "one block fewer", "five instead of four", "it needs six blocks"."""
    lead = (
        longest(p, i, "just | only | i need | i want | it needs | it should have | there should be | let there be") or i
    )
    for n, j in count(p, lead):
        k = longest(p, j, BLOCKS) or 0
        less = longest(p, k or j, "fewer | less | fewer blocks | less blocks")
        more = longest(p, k, "more") if k else 0
        if less or more:
            end = longest(p, less or more, BLOCKS) or less or more
            yield (r.Recount(theme=None, by=-n if less else n, span=p.span(i, end), cost=1), end)
        swapped = _instead_of(p, k or j)
        if swapped > (k or j):
            yield r.Recount(theme=None, amount=n, span=p.span(i, swapped)), swapped
        of_them = bool(k) and p.words[k - 1] == "them"
        if k and (lead > i or of_them or (i and p.words[i - 1] in ("just", "only"))):
            end = longest(p, k, "in it | in the tower | in the row | in all | in total | only | will do | tall") or k
            yield r.Recount(theme=None, amount=n, of_them=of_them, span=p.span(i, end), cost=1), end


_BASES = phrases(
    "the base | its base | the bottom layer | the square | the sides | the bottom row | its bottom row | the bottom | "
    "the lowest row | the lowest layer"
)


_OF = phrases("a base of | a bottom row of | a bottom layer of | a height of | a length of | a width of")


_EACH_ONE = (
    "each | both | each of them | each one | every one | all of them | all | both of them | each tower | every tower"
)


def _subjects(p: Parser, i: int) -> Iterator[tuple[m.Meaning | None, int]]:
    """Phrases such as "make the tower", "it should be", "change the number of blocks to"."""
    if j := longest(p, i, "make | have | build | let | change | extend | turn | i want | i would like | we want"):
        for theme, k in simple(p, j):
            if isinstance(theme, m.Structure | m.Pronoun) and old(theme):
                yield (theme, longest(p, k, "to be | to | be | into | out of | from | with") or k)
        for phrase in (
            "the number of blocks",
            "the number of cubes",
            "the height",
            "the length",
            "the count",
            "the size",
        ):
            if (k := p.seq(j, phrase)) and (end := longest(p, k, ("to", "be"))):
                yield None, end
        if k := longest(p, j, _BASES):
            yield None, longest(p, k, "to be | to | be | into") or k
    for theme, k in simple(p, i):
        if isinstance(theme, m.Structure | m.Pronoun) and (
            end := longest(p, k, "should be | must be | should have | needs to be | has | must have")
        ):
            yield theme, end


def _to(p: Parser, i: int, j: int, theme: m.Meaning | None) -> Iterator[tuple[r.Request, int]]:
    for n, k in count(p, j):
        for units, what in ((TALL, "height"), (LONG, "length"), (BLOCKS, "blocks")):
            if end := longest(p, k, units):
                end = _instead_of(p, longest(p, end, "tall | high | long | wide") or end)
                yield (r.Recount(theme=theme, amount=n, what=what, span=p.span(i, end)), end)
        if k == p.end or p.words[k] in _CLOSES:
            yield r.Recount(theme=theme, amount=n, what="number", span=p.span(i, k)), k
    start = longest(p, j, ("a", "an")) or j
    for dims, k in dimensions(p, start):
        end = (
            longest(p, k, "square | grid | base | cube | wall | rectangle | pyramid | one | at the base | block base")
            or k
        )
        yield r.Recount(theme=theme, dims=dims, lines=in_lines(p, start, k), span=p.span(i, end)), end


_CLOSES = frozenset({",", ".", "and", "then", "instead", "please", "now", "not", "rather"})
"""What may follow a number that stands alone: "make it six instead"."""


def by_so_many(p: Parser, i: int, j: int, theme: m.Meaning | None) -> Iterator[tuple[r.Request, int]]:
    start = longest(p, j, "one block | a block | one level | a level | one layer | a layer | one step") or j
    amount = 1
    if start == j:
        for n, k in count(p, j):
            start, amount = (longest(p, k, "blocks | levels | layers | cubes | steps | block") or k, n)
    word = p.words[start] if start < p.end else ""
    if word in _MORE and (start > j or word not in ("bigger", "smaller")):
        what = _WHAT.get(word, "blocks")
        for n, end in _so_many(p, start + 1):
            by = _MORE[word] * (amount if start > j else n)
            yield (r.Recount(theme=theme, by=by, what=what, span=p.span(i, end)), end)


def _so_many(p: Parser, i: int) -> Iterator[tuple[int, int]]:
    if j := p.one(i, "by"):
        for n, k in count(p, j):
            yield (n, longest(p, k, "blocks | block | levels | cubes | level | layers | layer | more") or k)
        return
    yield 1, i


def _instead_of(p: Parser, i: int) -> int:
    """Phrases such as "instead of three"."""
    if j := longest(p, i, ("instead of", "rather than", "not")):
        for _, k in count(p, j):
            return longest(p, k, BLOCKS) or k
    return i
