"""Parts that are told by where they are: "the one in the middle", "the row at the back", "the four at the bottom"."""

from __future__ import annotations

from itertools import pairwise
from typing import TYPE_CHECKING

from rpg.language.grammar.core import Parser, Results
from rpg.language.grammar.places.sides import extreme, far_end
from rpg.language.grammar.structures.part_words import ALL_BEYOND, BETWEEN, BEYOND, SIDES, THERE, UNITS
from rpg.language.later import later
from rpg.language.meaning import At, Loc, Meaning, Places, Pronoun, replace

if TYPE_CHECKING:
    from rpg.language.grammar.structures.parts import part
else:
    (part,) = later(__name__, "rpg.language.grammar.structures.parts", "part")

_PLACED = ("in the", "at the", "on the", "at", "in", "on", "at both", "at each", "on both", "on each")
ONE_OR_MORE = ("block", "blocks", "cube", "cubes", "one", "ones", "bricks", "brick")


def told_there(p: Parser, i: int, j: int, unit: str) -> Results[Meaning]:
    """ "the one in the middle", "the two at the ends", "the three blocks in between": told by where they are."""
    several = p.number(j) if p.words[j] not in ("one", "ones") else None
    k = j + 1 if several is not None else j
    start = p.opt(k, *ONE_OR_MORE)
    if j == i or start == j:
        return
    if end := p.any_of(start, BETWEEN):
        yield Places(side="rest", unit="block", several=several, span=p.span(i, end)), end
    if several in (None, 1):
        yield from extreme(p, p.any_of(start, ("that is", "which is", "that lies", "that stands")) or start)
    lead = p.any_of(start, _PLACED)
    if lead and several in (None, 1) and p.stands(lead, ("corner",)) and p.stands(lead - 1, ("the", "its")):
        yield Places(side="corners", unit="block", several=1, span=p.span(i, lead + 1)), p.reach(lead + 1)
    lead = lead + 1 if lead and far_end(p, lead) else lead
    for place, end in part(p, lead, "") if lead and p.words[start] != "of" else ():
        if isinstance(place, Places) and place.unit == "block" and place.several is None and place.side != "rest":
            yield replace(place, several=several or place.several, span=p.span(i, end)), end
        elif isinstance(place, At) and several in (None, 1):
            yield replace(place, own=True, span=p.span(i, end)), end
        elif isinstance(place, At) and several is not None and place.index is None:
            yield Places(side=place.side, unit="block", several=several, span=p.span(i, end)), end
    side = SIDES.get(p.words[lead]) if lead and lead < p.end else None
    if side in ("left", "right", "top", "bottom", "front", "back") and p.words[start] not in ("in", "of"):
        end = p.opt(p.reach(lead + 1), "side", "end")
        if several is None or several == 1:
            yield At(side=side, own=True, span=p.span(i, end)), end
        else:
            yield Places(side=side, unit="block", several=several, span=p.span(i, end)), end


def rest_beyond(p: Parser, i: int) -> Results[Places]:
    """ "The four below it", "everything above", "the other two to its right": all that is left, on that side."""
    several, k = None, p.any_of(i, ALL_BEYOND)
    if not k and (j := p.any_of(i, ("the", "the other", "all"))) and p.words[j] not in ("one", "ones"):
        several = p.number(j)
        k = p.opt(j + 1, *ONE_OR_MORE) if several is not None else 0
    for phrase, end in p.standing(k, BEYOND) if k else ():
        yield Places(side="rest", unit="block", several=several, beyond=BEYOND[phrase], span=p.span(i, end)), end


_NEXT_TO_IT = {**BEYOND, **dict.fromkeys(("next to it", "beside it", "next to that", "beside that"), "beside")}
_RELS = {"above": "above", "below": "under"}
_ONE = ("the one", "the block", "the cube", "the next one", "the brick")
_LINES = frozenset({"row", "column", "layer"})
_BROAD = frozenset({"grid", "square", "wall", "rectangle", "pyramid", "towers", "stacks", "rows", "columns", "stairs"})


def next_to_it(p: Parser, i: int) -> Results[Loc]:
    """ "(The bottom one is green,) the one above it": where it is to the one before, in a line; behind "the front row"
    it is a row."""
    k = p.any_of(i, _ONE)
    if k and any(a in SIDES and b in _LINES for a, b in pairwise(p.words[:i])):
        return
    for phrase, end in p.standing(k, _NEXT_TO_IT) if k and p.all.isdisjoint(_BROAD) else ():
        way = _NEXT_TO_IT[phrase]
        it = Pronoun(word="it", span=p.span(k, end))
        yield Loc(rel=_RELS.get(way, way), landmark=it, span=p.span(i, end)), end


_LINES = frozenset(unit for unit, kind in UNITS.items() if kind in ("row", "column", "layer", "step"))


def line_there(p: Parser, i: int, j: int, unit: str) -> Results[Places]:
    """ "the row at the back", "the column on the left", "the layer in between"; "the one at the back" of rows."""
    lines = p.stands(j, _LINES)
    if j == i or not (lines or (unit in ("row", "column", "layer") and p.stands(j, ("one",)))):
        return
    for phrase, k in p.standing(j + 1, THERE):
        found = UNITS[p.words[j]] if lines else unit
        yield Places(side=THERE[phrase], unit=found, span=p.span(i, k)), k
