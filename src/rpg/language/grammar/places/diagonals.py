"""Two sides at once: "to the front left of the blue block", "diagonally behind it, to the right"."""

from __future__ import annotations

from rpg.language.grammar.core import Parser, Results, choice
from rpg.language.grammar.places.prepositions import relation, side_relation
from rpg.language.grammar.things.nouns import simple
from rpg.language.meaning import Coord, Loc, TableTop, replace

_DEEP = {"front": "front", "back": "behind", "rear": "behind", "behind": "behind"}
_WIDE = {"left": "left", "right": "right"}
_EITHER_WAY = {"front": ("left", "right"), "behind": ("left", "right"), "left": ("front", "behind"),
               "right": ("front", "behind")}  # fmt: skip
_TO = ("to the", "on the", "at the", "in the", "towards the", "toward the", "off to the")
_TO_SIDE = tuple(f"{comma}{to}{side}" for comma in ("", ", ") for to in ("to the ", "on the ") for side in _WIDE)


@choice
def diagonal(p: Parser, i: int) -> Results[Coord]:
    """Each of the two sides along its own axis."""
    start = p.any_of(i, _TO) or i
    for one, other in ((_DEEP, _WIDE), (_WIDE, _DEEP)):
        first = p.peek(start, one)
        second = p.peek(start + 1, other) if first else None
        of = p.one(p.opt(start + 2, "side"), "of") if second else 0
        for mark, k in simple(p, of) if of else ():
            if first and second and not isinstance(mark, TableTop):
                sides = tuple(Loc(rel=side, landmark=mark, span=p.span(i, k)) for side in (first, second))
                yield Coord(op="and", items=sides, span=p.span(i, k)), k
    yield from _diagonally(p, i)


def _diagonally(p: Parser, i: int) -> Results[Coord]:
    """ "diagonally behind the white block, to the right"; without a side, to either."""
    start = p.any_of(i, ("diagonally", "at an angle"))
    yield from _along_both(p, i, start) if start else ()
    for (name, mods), j in relation(p, start) if start else ():
        for mark, k in simple(p, j) if name in _EITHER_WAY and not mods else ():
            if isinstance(mark, TableTop):
                continue
            placed = Loc(rel=name, landmark=mark, mods=("somewhere",), span=p.span(i, k))
            sides = tuple(replace(placed, rel=side) for side in _EITHER_WAY[name])
            either = Coord(op="or", items=sides, span=placed.span)
            yield Coord(op="and", items=(placed, either), span=placed.span), k
            if end := p.any_of(k, _TO_SIDE) if name in ("front", "behind") else 0:
                there = replace(placed, rel=p.words[end - 1])
                yield Coord(op="and", items=(placed, there), span=p.span(i, end), cost=-1), end


def _along_both(p: Parser, i: int, start: int) -> Results[Coord]:
    """ "diagonally behind and to the left of the orange block"."""
    firsts = [(name, j) for (name, _), j in relation(p, start)]
    firsts += [(side.rstrip("?"), j) for (side, _), j in side_relation(p, start)]
    firsts += [("front", j)] if (j := p.any_of(start, ("in front", "to the front"))) else []
    for first, j in firsts:
        for (second, _), m in relation(p, j + 1) if p.stands(j, ("and",)) else ():
            for mark, k in simple(p, m) if second in _EITHER_WAY.get(first, ()) else ():
                if not isinstance(mark, TableTop):
                    sides = tuple(Loc(rel=x, landmark=mark, span=p.span(i, k)) for x in (first, second))
                    yield Coord(op="and", items=sides, span=p.span(i, k)), k
