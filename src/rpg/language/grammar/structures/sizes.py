"""Sizes of structures: "3x3", "three blocks high", "with 3 rows and 4 columns", "whose base is 3 by 3"."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator

from rpg.language import lexicon
from rpg.language.grammar.core import Parser, Results, rule
from rpg.language.grammar.structures.outlines import A_SIDE
from rpg.language.grammar.structures.told_by_one import shows_it
from rpg.language.grammar.talk.slots import Patterns
from rpg.language.grammar.things import amounts
from rpg.language.meaning import Manner, Meaning, Size, Structure

_BY = frozenset({"by", "x", "times"})
_BLOCKS = ("block", "blocks", "cube", "cubes", "brick", "bricks", "level", "levels", "layer", "layers")
IN_TOTAL = ("in total", "in all", "altogether", "all in all", "total")
_UNITS = {
    "high": "high", "tall": "high", "in height": "high", "long": "long", "in length": "long", "wide": "wide",
    "in width": "wide", "across": "wide",
    "deep": "deep", "in a row": "columns", "rows deep": "rows", "columns wide": "columns",
    "steps high": "steps",
}  # fmt: skip
_PARTS = {
    "steps": "steps", "step": "steps", "stairs": "steps", "levels": "layers", "layers": "layers", "tiers": "layers",
    "stories": "layers", "floors": "layers",
    "rows": "rows", "columns": "columns", "layer": "layers", "row": "rows", "column": "columns",
}  # fmt: skip
AS_HIGH = Patterns(
    ",? as high|tall up? as possible|you_can|we_can|it_can|they_can|can_be|it_can_be|they_go|it_goes|they_will_go|"
    "it_will_go|they_can_go|it_can_go|they_get|it_gets|it_can_get|you_can_get|you_can_get_it|you_can_make_it|you_manage|"
    "they_will_reach|they_reach|it_will_get|you_can_go"
)
"""What says no more of blocks that are counted or named than that all of them are to be in the tower."""
_BASES = ("base", "foundation", "bottom", "footprint", "bottom layer", "bottom row", "ground floor",
          "lowest row", "lowest layer", "bottom level", "lowest level", "first row", "first layer")  # fmt: skip
_IS = ("of", "is", "that is", "which is", "being", "should be", ":", "has", "counts", "contains", "consists of",
       "is made of", "must have", "should have", "having", "with")  # fmt: skip

_BELOW = ("below", "at the bottom", "at the base", "on the bottom", "as its base", "as a base", "as the base",
          "as base", "at its base", "underneath", "in the bottom layer")  # fmt: skip


def as_high(p: Parser, found: Iterable[tuple[Structure, int]]) -> Iterator[tuple[Structure, int]]:
    """ "a tower as tall as possible (from five blocks)": no more than the tower."""
    for shape, j in found:
        yield shape, j
        for k in AS_HIGH.matches(p, j) if shape.kind == "stack" else ():
            if not p.all.isdisjoint(OF_WHAT):
                yield shape, k


OF_WHAT = frozenset({"with", "use", "using", "from", "of", "all", "every", "blocks", "cubes", "everything", "take"})
"""Without one of these it is not said of which blocks something is to be as high as it can be."""


@rule
def dimensions(p: Parser, i: int) -> Results[tuple[int, ...]]:
    """ "3x3", "3 by 3 by 3", "two by four"."""
    token = p.token(i)
    if token is not None and token.kind == "dims" and isinstance(token.value, tuple):
        yield token.value, p.reach(i + 1)
    first = p.number(i)
    if first is None:
        return
    yield from _lines_by_lines(p, i, first)
    if not p.one(i + 1, _BY):
        return
    second = p.number(i + 2)
    if second is None:
        return
    third = p.number(i + 4) if p.one(i + 3, _BY) else None
    if third is not None:
        yield (first, second, third), i + 5
    yield (first, second), i + 3


_LINES = {"row": "columns", "rows": "columns", "column": "rows", "columns": "rows"}


def in_lines(p: Parser, i: int, j: int) -> bool:
    """Whether rows or columns are named there: what the rows of a wall are is then told, and not how wide it is."""
    return not _LINES.keys().isdisjoint(p.words[i:j])


def _lines_by_lines(p: Parser, i: int, first: int) -> Results[tuple[int, ...]]:
    """ "four rows by two columns", "2 rows 4 columns": the rows come first in what is yielded."""
    other = _LINES.get(p.words[i + 1]) if i + 3 < p.end else None
    k = p.opt(i + 2, *_BY)
    second = p.number(k) if other else None
    if second is not None and p.words[k + 1] in (other, (other or "")[:-1]):
        yield ((first, second) if other == "columns" else (second, first)), p.reach(k + 2)


@rule
def rows_and_columns(p: Parser, i: int) -> Results[tuple[int, ...]]:
    """ "two rows and three columns", "4 rows x 2 columns": a grid that is told by these alone."""
    first = p.number(i)
    if first is None:
        return
    other = _LINES.get(p.words[i + 1])
    k = p.any_of(i + 2, ("and", "by", "x", ", and", ",", "times", "*")) or i + 2
    second = p.number(k) if other else None
    if second is not None and other is not None and p.words[k + 1] in (other, other[:-1]):
        yield ((first, second) if other == "columns" else (second, first)), p.reach(k + 2)


@rule
def size_phrase(p: Parser, i: int) -> Results[Size]:
    """One statement of size after the noun."""
    j = p.opt(i, ",", "and", "but", ":")
    j = (
        p.any_of(
            j,
            (
                "that is",
                "which is",
                "that should be",
                "which should be",
                "that has to be",
                "that must be",
                "that are",
                "each",
                "all",
                "of which each is",
                "each of them",
                "each one",
                "every one of them",
                "all of them",
                "both of them",
                "both",
                "with a size of",
                "of size",
                "measuring",
                "it is",
            ),
        )
        or j
    )
    for found, k in amounts.amount(p, j):
        k = p.opt(k, *_BLOCKS)
        if end := p.any_of(k, IN_TOTAL):
            yield Size(what="total", amount=found, span=p.span(i, end)), end
        if p.words[i] == "," and p.words[k - 1] in ("blocks", "cubes") and j == i + 1:
            yield Size(what="size", amount=found, span=p.span(i, k), cost=1), k
        for unit, end in p.standing(k, _UNITS):
            ranging = unit == "in a row" and found.low != found.high
            yield Size(what=_UNITS[unit], amount=found, span=p.span(i, end), cost=2 if ranging else 0), end
            if each := p.any_of(end, ("each", "apiece", "each of them")):  # "two towers side by side, 3 high each"
                yield Size(what=_UNITS[unit], amount=found, span=p.span(i, each)), each
    for dims, k in dimensions(p, j):
        if below := p.any_of(p.opt(k, *_BLOCKS), _BELOW):
            yield Size(what="base", dims=dims, span=p.span(i, below)), below
        yield (
            Size(what="dims", dims=dims, named=in_lines(p, j, k), span=p.span(i, k), cost=0 if j > i else 1),
            p.any_of(k, ("in size", "blocks", "cubes", "per layer", "in each layer", "for each layer")) or k,
        )
    for dims, k in dimensions(p, i + 1) if p.one(i, "of") else ():
        yield Size(what="dims", dims=dims, named=in_lines(p, i, k), span=p.span(i, k)), k
    yield from _led(p, i, j)
    yield from _begun(p, i)


_STARTS = ("starting with", "starting from", "that starts with", "which starts with", "beginning with",
           "that begins with", "which begins with", "starts with", "begins with")  # fmt: skip
_A_ROW = ("a row of", "a base of", "a layer of", "a bottom row of", "a bottom layer of")


def _begun(p: Parser, i: int) -> Results[Size]:
    """ "(a pyramid) starting with four (blocks)", "... with a row of four": how large its base is."""
    j = p.any_of(p.opt(i, ","), _STARTS)
    j = (p.any_of(j, _A_ROW) or j) if j else 0
    for found, k in amounts.amount(p, j) if j else ():
        k = p.opt(k, *_BLOCKS)
        end = p.any_of(k, _BELOW) or k
        yield Size(what="base", amount=found, span=p.span(i, end)), end


_MEASURES = {
    "of height": "high", "with height": "high", "with a height of": "high", "of length": "long",
    "with a length of": "long", "of size": "size", "with a width of": "wide", "of width": "wide", "in height": "high",
}  # fmt: skip
_WITH = (
    "with", "of", "having", "that has", "which has", "that have", "containing", "in", "whose", "has", "on",
    "with each side", "the", "consists of", "consisting of", "that consists of",
)  # fmt: skip
_LOWEST = ("at the bottom", "at its base", "at its bottom", "in the base", "in the lowest row", "in the bottom layer",
           "in the lowest layer")  # fmt: skip
_COUNTED = (
    (("block base", "blocks base", "cube base", "wide base", "block wide base", "base", "blocks wide base",
      "blocks wide bottom"), "base", 0),
    (("each", *(f"{blocks}{every}" for blocks in ("", "blocks ", "cubes ", "bricks ") for every in (
        "each", "per row", "in each row", "in every row", "per layer", "in each layer", "in every layer", "per level",
        "in each level", "to a layer", "to each layer", "to the layer")[1 - bool(blocks) :])), "columns", 0),
    (("blocks per column", "blocks in each column", "cubes per column", "per column", "blocks in every column",
      "cubes in each column"), "rows", 0),
    (("blocks on the bottom", "blocks in the bottom row", "blocks at the bottom", "on the bottom", "in the bottom row",
      "blocks at its base", "blocks in the base", "cubes at the bottom", "cubes in the bottom row",
      "blocks in the bottom layer", "blocks as its base", "at the base"), "base", 1),
    (_LOWEST, "base", 0),
)  # fmt: skip
_SEVERAL = {*_PARTS, *(word for word, (_, many) in lexicon.STRUCTURE.items() if many)} - {"row", "column", "layer"}
"""With these words "two each" says how many each of them has."""


def _led(p: Parser, i: int, j: int) -> Results[Size]:
    """After "with", "of", "having"."""
    for lead, told in p.standing(i, _MEASURES):
        for found, k in amounts.amount(p, told):
            yield Size(what=_MEASURES[lead], amount=found, span=p.span(i, k)), p.opt(k, *_BLOCKS)
    k = p.any_of(j, _WITH) or (j if j > i or p.stands(j, ("base",)) else 0)
    if not k:
        return
    k = p.opt(k, "a", "an", "the", "its")
    for found, e in amounts.amount(p, k):
        for part, end in p.standing(e, _PARTS):
            yield Size(what=_PARTS[part], amount=found, span=p.span(i, end)), p.opt(end, "only")
        for phrases, what, cost in _COUNTED:
            if phrases is _LOWEST and (p.follows(k, ("the",)) or shows_it(p, i, e)):
                continue  # "the 1 at the bottom" is a block
            if end := p.any_of(e, phrases):
                of_looks = p.words[end - 1] == "each" and p.all.isdisjoint(_SEVERAL)  # "red and blue, two each"
                of_looks = of_looks and sum(word in lexicon.STRUCTURE for word in p.words) < 2
                yield Size(what=what, amount=found, span=p.span(i, end), cost=cost + 5 * of_looks), end
        for end in A_SIDE.matches(p, e):
            yield Size(what="side", amount=found, span=p.span(i, end)), end
    lines = p.number(k)
    for dims, e in _lines_by_lines(p, k, lines) if lines is not None else ():
        yield Size(what="dims", dims=dims, named=True, span=p.span(i, e)), e
    for dims, e in dimensions(p, k):
        if end := p.any_of(p.opt(e, "block", "blocks", "square"), _BASES):
            yield Size(what="base", dims=dims, span=p.span(i, end)), end
    if e := p.any_of(k, ("side of", "sides of", "side length of", "sides")):
        for found, m in amounts.amount(p, e):
            yield Size(what="side", amount=found, span=p.span(i, m)), p.opt(m, *_BLOCKS)
    yield from _based(p, i, k)


def _based(p: Parser, i: int, k: int) -> Results[Size]:
    """ "base of 3 blocks", "base is 3 x 3"."""
    square = p.one(k, "square")
    base = p.any_of(square or k, _BASES)
    e = p.any_of(base, _IS) if base else 0
    e = e or (base if base and (p.number(base) or any(True for _ in dimensions(p, base))) else 0)
    if not e:
        return
    for dims, m in dimensions(p, p.opt(e, "a")):
        yield Size(what="base", dims=dims, span=p.span(i, m)), p.any_of(m, ("in size",)) or p.opt(m, *_BLOCKS, "square")
    for found, m in amounts.amount(p, e):
        side = math.isqrt(found.low)
        if square and side * side != found.low:
            continue
        if square and (found.high == found.low or found.high is None):
            end = p.opt(m, *_BLOCKS)
            yield Size(what="base", dims=(side, side), span=p.span(i, end)), end
            continue
        m = p.opt(p.opt(m, "horizontal"), *_BLOCKS)
        yield Size(what="base", amount=found, span=p.span(i, m)), p.opt(m, "wide", "long", "across")


_ROWS = {"rows": ("grid", "square", "rectangle"), "columns": ("grid", "square", "rectangle"), "layers": ("wall",)}
"""Lines of which it can be said how many blocks each has, by the kinds of structures."""


def ends_in_lines(p: Parser, j: int) -> bool:
    """Whether "three rows" stands just before: "of four" then says how long each is."""
    return j > 1 and p.words[j - 1] in _ROWS and p.number(j - 2) is not None


def each_told(shapes: Structure) -> tuple[Meaning, ...]:
    """The details of "two equal towers of four blocks each": that they are equal says no more than "each" does."""
    return tuple(x for x in shapes.details if not (isinstance(x, Manner) and x.kind == "equal"))


_LAYERED = frozenset({"layers", "levels", "tiers", "floors"})
_OF_EACH = ("of", "each", ", each", "each of", "each with", ", each of", ", each with", "with", "on a base of", "on a",
            "each a", ", each a", "being", "of a", "of one", "each of a", ", each of a", "in a", "both a")  # fmt: skip
_EACH_LAYER = ("each", "in each layer", "per layer", "in every layer", "in each", "base", "grid", "square", "in size")


_LIKE_A_CUBE = Patterns(
    ",? like|forming|making|so_as_to_form|as|i.e.|so_it_looks_like|to_form|that_makes a|one big|large|small|solid? "
    "cube|block|box"
)


@rule
def layers_of(p: Parser, i: int) -> Results[Size]:
    """ "two layers of 2x2 blocks", "three layers on a 2x2 base": rows, columns and layers."""
    layers = p.number(i)
    of = p.any_of(i + 2, _OF_EACH) if layers and p.stands(i + 1, _LAYERED) else 0
    for dims, j in dimensions(p, of) if of else ():
        if len(dims) == 2 and layers is not None:
            j = p.any_of(j, _EACH_LAYER) or j
            end = p.any_of(p.opt(j, "of"), _EACH_LAYER) or j
            end = max(_LIKE_A_CUBE.matches(p, end), default=end) if {*dims} == {layers} else end
            yield Size(what="dims", dims=(*dims, layers), span=p.span(i, end)), end


@rule
def lines_of(p: Parser, i: int, kind: str) -> Results[Size]:
    """ "with three rows of four": the extents of a grid, or of a wall."""
    if kind in _THICK and (after := p.any_of(i, ("with", "of", "having", "in", ",", ":", "made of", ", with", "i.e.",
                                                 ", i.e.", ", that is ,", ", so", "and"))):  # fmt: skip
        yield from layers_of(p, after)
    j = p.any_of(i, ("with", "of", "having", "in", "made of", ",", ":", ", with", ", in", ": with", "has", "that has"))
    j = j or i  # "rectangle 2 rows of 3 orange blocks"
    lines = p.number(j)
    what = p.words[j + 1] if lines is not None and j + 3 < p.end else ""
    each = p.number(j + 3) if what in _ROWS and p.words[j + 2] in ("of", "with") else None
    if lines is None or each is None or not (kind in _ROWS[what] or (kind == "wall" and what == "rows")):
        return
    dims = (lines, each) if what == "rows" and kind != "wall" else (each, lines)
    end = p.any_of(j + 4, _IN_EACH_LINE)
    yield Size(what="dims", dims=dims, span=p.span(i, end or j + 4)), end or j + 4


_IN_EACH = ("", " each", *(f" in {a} {line}" for a in ("each", "every") for line in ("row", "layer", "column")))
_IN_EACH_LINE = tuple(f"{noun}{tail}" for noun in ("blocks", "cubes", "bricks") for tail in _IN_EACH)
_THICK = ("grid", "cube", "square", "rectangle", "stack")
