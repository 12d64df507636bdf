"""Colours of rows, columns or layers one after the other: "each row in one colour: red, white from back to front"."""

from __future__ import annotations

from collections.abc import Iterator

from rpg.language.grammar.core import Parser, Results, choice, rule
from rpg.language.grammar.places.sides import OPPOSITE, SIDES, toward
from rpg.language.grammar.structures.patterns import agree
from rpg.language.grammar.talk.slots import Patterns
from rpg.language.grammar.things.adjectives import color
from rpg.language.grammar.things.nouns import simple
from rpg.language.meaning import (
    Absolute,
    Amount,
    Clause,
    Coord,
    Meaning,
    Noun,
    Pattern,
    Places,
    Structure,
    Toward,
    Traits,
    replace,
)

_UNITS = {"row": "row", "column": "column", "layer": "layer", "level": "layer"}
_WHOLES = {"tower": "whole", "stack": "whole"}
"""Several structures that may be told of in the same way."""
_WHERE = "with|where|and|so_that|such_that|having|in_which|whose|while?"
_ONE = "one|a|a_single|its_own|own|a_different|the_same|one_single|a_separate|a_distinct|only_one|just_one|another"


def _openings(unit: str) -> Patterns:
    """What the colours of all rows (or columns, or layers) are told after."""
    return Patterns(
        f"{_WHERE} each|every {unit} is|being|has|having|should_have|should_be|must_be|must_have|shows|gets|made? "
        f"in|of|to_have|with? {_ONE} color of_its_own?",
        f"{_WHERE} using|in|of? {_ONE} color per|for_each|for_every|to_each|to_every|in_each|in_every|each|every "
        f"{unit}",
        f"{_WHERE} each|every {unit} single_colored|one_colored|uniform|unicolored",
        f"{_WHERE} the|its {unit}s are|being|should_be|must_be|in_the_colors|colored|in|colored_in|have_the_colors",
        f"{_WHERE} the|its? {unit}s :",
        f"color|paint the|its|all {unit}s",
        f"the|its|all? {unit}s",
        f"with|whose the|its? {unit}s are|being|colored|in?",
        f"whose {unit}s are_of|have|each_have {_ONE} color each?",
    )


_NAMED_AS = ("colors", "the colors", "in the colors", "in the order", "with the colors", "the colors are", "colors are")
"""What the colours are listed after, where that they are one for each line was said before."""


EACH = Patterns(f"each|every being|is|has|having|with? in|of|with? {_ONE} color of_its_own?")
"""The same behind "three columns"."""


_OPENINGS = {unit: _openings(unit) for unit in _UNITS}
_COLON = ("- from", ": from", ", from", ", namely", ": namely", ":", ",", "-", "from", "namely", "in")
_FIRST = {"row": ("back", "front", "top", "bottom"), "column": ("left", "right"), "layer": ("bottom", "top"),
          "whole": ("left", "right")}  # fmt: skip
"""Where a count of lines may begin, the side of the first one in front."""
_LEADS = ("in the", "at the", "on the", "for the", "is the", "in", "at", "on", "the", "is in the", "goes to the", "is")
_NEXT = ("and then", "then", "and finally", "finally", "and last", "and", "followed by")
_ITEM_SIDES = {
    **{word: side for word, side in SIDES.items() if word not in ("base", "ground")},
    "nearest": "front", "closest": "front", "farthest": "back", "furthest": "back", "upper": "top", "lower": "bottom",
    "middle": "middle", "center": "middle",
}  # fmt: skip
_MARKED = frozenset({"each", "every", "row", "rows", "column", "columns", "layer", "layers", "level", "levels",
                     "towers", "stacks", "they"})  # fmt: skip


@rule
def each_line(p: Parser, i: int) -> Results[Meaning]:
    """As many parts as there are colours, counted from the side that the direction names."""
    start = p.opt(i, ",", ":")
    if not p.anywhere(_MARKED):
        return
    for first, unit, are in _run_along(p, start):
        told, end = _told(p, p.opt(are, ":"), unit)
        yield from _whole(p, i, end, told, unit, first)
    for word, unit in _UNITS.items():
        for k in _OPENINGS[word].matches(p, start):
            bare = p.words[k - 1] == f"{word}s"
            led = p.words[start] in ("with", "whose") and bare
            if bare and p.words[start] not in ("with", "whose", "color", "paint") and not p.one(i, _SET_OFF):
                continue
            closed = p.words[k - 1] in (":", "are", "being", "in", "colored") or p.any_of(k, _COLON)
            if led or p.one(i, ",") or closed:
                yield from _colors(p, i, k if p.words[k - 1] == ":" else p.any_of(k, _SET_APART) or k, unit)
    behind = _UNITS.get(p.words[start - 1].removesuffix("s")) if start > 0 and p.words[start] == "each" else None
    for k in EACH.matches(p, start) if behind else ():
        if end := p.any_of(k, _SET_APART):
            yield from _colors(p, i, end, behind or "")


def _run_along(p: Parser, start: int) -> Iterator[tuple[str, str, int]]:
    """ "From left to right the columns are", "the rows, from back to front, are": where they begin, what they are."""
    units = {**_UNITS, **_WHOLES}
    for way, j in toward(p, start):
        if isinstance(way, Toward) and way.first is not None and (are := p.any_of(p.opt(j, ","), _THE_LINES)):
            they = "row" if way.first in _FIRST["row"][:2] else "whole"
            yield way.first, next((u for w, u in units.items() if f"{w}s" in p.words[j:are]), they), are
    named = p.any_of(start, _NAMED)
    for way, j in toward(p, named + 1) if named and p.one(named, (",",)) else ():
        if isinstance(way, Toward) and way.first is not None and (are := p.any_of(p.opt(j, ","), _ARE)):
            yield way.first, units[p.words[named - 1].removesuffix("s")], are


_GRIDS = ("grid", "wall", "square", "rectangle")
_HAS = ("has", "should have", "must have", "is in", "is of", "is", "should be", "must be", "shows", "gets")


@choice
def lines_of(p: Parser, i: int) -> Results[Clause]:
    """ "each row of the 2x3 grid has its own colour: the front row is red, the back row white"."""
    each = p.one(i, ("each", "every"))
    unit = _UNITS.get(p.words[each], "") if each else ""
    of = p.one(each + 1, ("of", "in")) if unit else 0
    for grid, k in simple(p, of) if of else ():
        told = isinstance(grid, Structure) and grid.kind in _GRIDS and (grid.dims or grid.sizes)
        has = p.any_of(k, _HAS) if told else 0
        for alike, j in agree(p, i, has, unit) if has and isinstance(grid, Structure) else ():
            behind = p.any_of(j, (":", ","))
            for lines, end in [(alike, j), *(_colors(p, i, behind, unit) if behind else ())]:
                made = replace(grid, det="a")
                yield Clause(verb="build", theme=made, adjuncts=(lines,), mode="goal", span=p.span(i, end)), end


def _colors(p: Parser, i: int, start: int, unit: str) -> Results[Meaning]:
    start = p.opt(p.any_of(start, _NAMED_AS) or start, ":")
    for way, j in toward(p, start):
        if isinstance(way, Toward) and way.first is not None:
            told, end = _told(p, p.opt(j, ":", ","), unit)
            yield from _whole(p, i, end, told, unit, way.first)
    if (begun := p.any_of(start, _BEGUN)) and (side := _ITEM_SIDES.get(p.words[begun])) and unit != "layer":
        k = p.opt(p.opt(p.reach(begun + 1), unit, "side", "end", "one"), ":", ",", "with")
        told, end = _told(p, k, unit)
        yield from _whole(p, i, end, told, unit, side)
    told, end = _told(p, p.opt(start, "from"), unit)
    plain = len(told) > 1 and not any(side for _, side, _ in told)
    if plain and (free := p.any_of(p.opt(end, ","), _ANY_ORDER)):
        values = tuple(look.traits.colors[0] for look, _, _ in told)
        yield Pattern(unit=unit, values=values, span=p.span(i, free)), free
    if plain and not _EVERY.isdisjoint(p.words[i:start]) and all(look.amount for look, _, _ in told):
        return  # "each column in its own colour: two red, two pink": what there is, and not where
    yield from _whole(p, i, end, told, unit, None)
    for way, j in toward(p, p.opt(end, ",")) if told else ():
        if isinstance(way, Toward) and way.first is not None:
            yield from _whole(p, i, j, told, unit, way.first)


_ANY_ORDER = ("in any order", "in whatever order", "in no particular order", "in either order", "in some order")
_EVERY = frozenset({"each", "every", "per", "color"})
_BEGUN = ("from the", "starting from the", "starting at the", "starting with the", "beginning with the",
          "beginning at the", "starting in the", "counted from the", "beginning from the")  # fmt: skip
_SET_OFF = frozenset({",", ":", "-"})
_SET_APART = (":", ",", "-", ", namely", ": namely", "namely", ", i.e.", ", that is")
_ARE = ("are", "should be", "must be", "are colored", "have the colors", ":", "being", "shall be")
_NAMED = tuple(f"{the}{unit}s" for the in ("the ", "its ", "") for unit in (*_UNITS, *_WHOLES))
_THE_LINES = tuple(f"{named} {are}" for named in (*_NAMED, "they") for are in _ARE)
Told = tuple[tuple[Noun, str, tuple[int, int]], ...]
"""Colours, each with the side where it is said to be, or with none."""


def _told(p: Parser, i: int, unit: str) -> tuple[Told, int]:
    """ "red, white, blue", "red far, white middle, blue near", "red in the far one, then white": all of them."""
    found: list[tuple[Noun, str, tuple[int, int]]] = []
    at = end = i
    while len(found) < 12:
        ahead, start = _side(p, p.opt(at, "the"), unit)
        start = (p.any_of(start, _IS) or start) if ahead else at
        many = p.number(start)
        named = next(iter(color(p, p.opt(start, "all", "only") if many is None else start + 1)), None)
        if named is None:
            break
        k = p.opt(named[1], "again", unit)
        k = p.opt(k, "blocks", "cubes", "bricks", "ones") if many else k
        side, end = (ahead, k) if ahead else _side(p, k, unit)
        amount = Amount(many, many) if many else None
        look = Noun(head="any", amount=amount, traits=Traits(colors=(named[0],)), span=p.span(at, end))
        found.append((look, side, p.span(at, end)))
        comma = p.opt(end, ",")
        at = p.any_of(comma, _NEXT) or comma
    return tuple(found), end


def _side(p: Parser, i: int, unit: str) -> tuple[str, int]:
    j = p.any_of(i, _LEADS) or i
    side = p.lex(j, _ITEM_SIDES)
    if side is None or p.words[j + 1] in ("to", "of"):
        return "", i
    return side, p.opt(p.reach(j + 1), unit, "one", "end", "side")


def _whole(p: Parser, i: int, j: int, told: Told, unit: str, first: str | None) -> Iterator[tuple[Meaning, int]]:
    """The parts that the colours make, if they are told in one way."""
    sides = [side for _, side, _ in told]
    if len(told) < 2:
        return
    if first is None and all(sides) and len(set(sides)) == len(sides):
        places = [Places(side=_end(side, unit), unit=unit, of=len(told), span=span) for _, side, span in told]
    else:
        begin = first or sides[0] or (_FIRST[unit][0] if unit != "layer" else "")
        last = "middle" not in sides and sides[-1] in ("", OPPOSITE.get(begin))
        inner = [side for side in sides[1:-1] if side]
        if begin not in _FIRST[unit] or inner or not last or (first is not None and any(sides)):
            return
        numbers = range(1, len(told) + 1) if _FIRST[unit].index(begin) % 2 == 0 else range(len(told), 0, -1)
        side = _FIRST[unit][0] if first or sides[0] else "first"
        places = [
            Places(side=side, unit=unit, index=n, of=len(told), span=span)
            for n, (_, _, span) in zip(numbers, told, strict=True)
        ]
    parts = tuple(
        Absolute(theme=look, adjuncts=(place,), span=span) for place, (look, _, span) in zip(places, told, strict=True)
    )
    yield Coord(op="absolutes", items=parts, span=p.span(i, j)), j


def _end(side: str, unit: str) -> str:
    """Rows of a grid on the table that are told as on a page: the top one is the far one."""
    return {"top": "back", "bottom": "front"}.get(side, side) if unit == "row" else side


_ONE_LINE = ("one", "a", "an", "the other", "another", "the other one", "the first", "the second", "the third",
             "another one", "the first one", "the second one")  # fmt: skip
_IS = ("is", "is all", "in", "of", "being", "all", "all in", "should be", "must be", "made of", ":")


def one_line_each(p: Parser, i: int) -> Iterator[tuple[str, tuple[str, ...], int]]:
    """ "with one red row and one blue row", ", one row red, the other blue": a colour for each, whichever is where."""
    at = p.any_of(i, (", with", "with", ",", ":", "of", ", of which", "of which", "where", ", where"))
    unit, named = "", []
    while at and (k := p.any_of(at, _ONE_LINE)):
        before = _UNITS.get(p.words[k], "")
        k = p.any_of(k + 1, _IS) or k + 1 if before else p.any_of(k, _IS) or k
        told = next(iter(color(p, k)), None)
        if told is None:
            return
        after = _UNITS.get(p.words[told[1]], "") if not before else ""
        end = p.opt(told[1] + 1 if after else told[1], "one")
        line = before or after or unit
        if not line or unit not in ("", line) or told[0] in named:
            return
        unit = line
        named.append(told[0])
        if len(named) > 1:
            yield unit, tuple(named), p.reach(end)
        at = p.any_of(end, (", and", ",", "and", ", while", "while"))
