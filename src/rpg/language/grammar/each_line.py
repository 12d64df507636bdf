"""Colours of rows, columns or layers one after the other: "each row in one colour: red, white from back to front"."""

from __future__ import annotations

from rpg.language.grammar.core import Parser, Results, rule
from rpg.language.grammar.lists import listed
from rpg.language.grammar.sides import toward
from rpg.language.meaning import Absolute, Coord, Meaning, Noun, Places, Toward, Traits

_UNITS = {
    "row": "row", "rows": "row", "column": "column", "columns": "column", "layer": "layer", "layers": "layer",
    "level": "layer", "levels": "layer",
}  # fmt: skip
_ONE = (
    "in one color", "of one color", "in a single color", "of a single color", "a different color", "one color",
    "in its own color", "a single color", "in a different color", "of a different color", "a color of its own",
)  # fmt: skip
_FIRST = {"row": ("back", "front", "top", "bottom"), "column": ("left", "right"), "layer": ("bottom", "top")}
"""Where a count of lines may begin, the side of the first one in front."""


@rule
def each_line(p: Parser, i: int) -> Results[Meaning]:
    """As many parts as there are colours, counted from the side that the direction names."""
    comma = p.opt(i, ",")
    if each := p.any_of(comma, ("each", "every", "with each", "where each", "with every")):
        unit = _UNITS.get(p.words[each]) if each < p.end else None
        told = p.any_of(each + 1, _ONE) or p.any_of(p.opt(each + 1, "is", "being", "should"), _ONE) if unit else 0
        start = p.one(told, ":") if told else 0
    else:
        lead = p.any_of(comma, ("the", "with the", "where the", "with", "its", "whose")) or comma
        unit = p.peek(lead, _UNITS)
        if not unit or not p.words[lead].endswith("s") or not (lead > i or i == 0):
            return
        start = p.any_of(lead + 1, ("are", "being", ":", "should be", "are :", "must be", "in the colors", "colored"))
    if not unit or not start:
        return
    for way, j in toward(p, start):
        if isinstance(way, Toward):
            yield from _lines(p, i, p.opt(j, ":", ","), unit, way)
    for items, j in listed(p, start):
        for way, end in toward(p, p.opt(j, ",")):
            if isinstance(way, Toward) and (found := _parts(items, unit, way)) is not None:
                yield Coord(op="absolutes", items=found, span=p.span(i, end)), end


def _lines(p: Parser, i: int, j: int, unit: str, way: Toward) -> Results[Meaning]:
    for items, end in listed(p, j):
        if (found := _parts(items, unit, way)) is not None:
            yield Coord(op="absolutes", items=found, span=p.span(i, end)), end


def _parts(items: tuple[Meaning, ...], unit: str, way: Toward) -> tuple[Meaning, ...] | None:
    sides = _FIRST[unit]
    if way.first not in sides or not all(isinstance(x, Noun) and x.traits == Traits(colors=x.traits.colors[:1])
                                         and x.traits.colors and x.amount is None for x in items):  # fmt: skip
        return None
    ordered = items if sides.index(way.first) % 2 == 0 else items[::-1]
    return tuple(
        Absolute(theme=item, adjuncts=(Places(side="first", unit=unit, index=n, span=item.span),), span=item.span)
        for n, item in enumerate(ordered, 1)
    )
