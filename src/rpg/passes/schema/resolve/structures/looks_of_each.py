"""What is said of each of several structures, or of some of them: "the left one red", "the two outer columns white"."""

from __future__ import annotations

from collections.abc import Sequence

from rpg.language.meaning import Absolute, At, Coord, Noun, OrderBy, Places, Structure, Traits, replace
from rpg.passes.schema.resolve.clauses.spec import Spec
from rpg.passes.schema.resolve.structures.sharing import Look, in_turn
from rpg.passes.schema.resolve.things.world import refuse, which_one

_AXES = {"left": "y", "right": "y", "front": "x", "back": "x"}
_INSIDE = ("middle", "outer", "inner", "ends")
"""Which of them these are is only clear where they lie in one line."""
_LIE_ALONG = {"row": "x", "line": "x"}
"""How structures lie in such a line: rows behind each other, all others side by side."""


def sided(spec: Spec) -> OrderBy | None:
    """ "from left to right red, white and blue": the order in which several structures stand."""
    directed = spec.first("left", "right", "front", "back") is not None
    return next((o for o in spec.orders if o.items and (directed or o.first in _AXES)), None)


def whole(item: Absolute) -> Places | None:
    """Which of the structures an absolute speaks of, if it speaks of one as a whole."""
    place = item.adjuncts[0] if len(item.adjuncts) == 1 else None
    if isinstance(place, At) and place.side in ("left", "right", "front", "back") and place.index is None:
        return Places(side=place.side, unit="whole", span=place.span)
    named = isinstance(place, Places) and (place.unit in ("row", "column") or place.unit.startswith("whole"))
    return place if named and isinstance(place, Places) else None


def _of_them(item: Absolute) -> Places | None:
    """ "(the left one red,) the middle one white", "the others white": where one is told as a whole, these are such
    too."""
    place = item.adjuncts[0] if len(item.adjuncts) == 1 else None
    if isinstance(place, At) and place.side == "middle" and place.index is None:
        return Places(side="middle", unit="whole", span=item.span)
    some = isinstance(place, Places) and place.unit == "block" and place.side in (*_INSIDE[:3], "rest", "first", "last")
    return place if some and isinstance(place, Places) and not place.beyond else None


def beside_others(item: Absolute) -> bool:
    """ "The outer ones", which no tower has among its blocks: of several towers."""
    place = _of_them(item)
    return place is not None and place.side in ("outer", "inner")


def told_looks(spec: Spec, count: int, kind: str = "", colors: Sequence[str] = ()) -> tuple[list[Look], str | None]:
    """What is said of each, and the axis along which they are then told apart. `kind`: what they are; `colors`: of the
    blocks that there are, of which one is left for the last one: "three red and three white, the red row in front"."""
    found: list[Look] = [None] * count
    if (order := sided(spec)) is not None:
        return _in_order(order, spec, count)
    said = [(a, w) for a in spec.absolutes if (w := whole(a)) is not None]
    if any(w.side != "one" for _, w in said) or (kind == "stack" and any(map(beside_others, spec.absolutes))):
        said = [(a, w) for a in spec.absolutes if (w := whole(a) or _of_them(a)) is not None]
    spec.absolutes = [a for a in spec.absolutes if all(a is not b for b, _ in said)]
    said.sort(key=lambda told: told[1].side == "rest")
    for number, (item, place) in enumerate(said):
        theme = in_turn(item.theme)
        free = [n for n, look in enumerate(found) if look is None]
        these = [number] if place.side == "one" else _indices(place, count, free)
        alike = isinstance(theme, Noun) and theme.amount is None and not theme.traits.labels
        if (place.index or 0) > count:
            raise refuse("misplaced", f"there are {count} of them", item.span, "say which of these this is")
        if not these or not {*these} <= {*free} or not isinstance(theme, Noun | Coord | Structure):
            raise refuse("count-mismatch", f"there are {count} of them", item.span, "say one thing of each")
        if len(these) > 1 and not alike:
            raise refuse("ambiguous", "of all of these, or of each?", item.span, "say one thing of each")
        for index in these:
            found[index] = theme
    looks = [look for look in found if isinstance(look, Noun) and len(look.traits.colors) == 1]
    left = [color for color in colors if all(look.traits.colors != (color,) for look in looks)]
    if said and len(looks) == count - 1 == len(colors) - len(left) and len(left) == 1:
        found = [look or replace(looks[0], traits=Traits(colors=(left[0],))) for look in found]
    if said and None in found:
        raise which_one("it is not said of each of them", said[0][0].span, "say one thing of each")
    return found, _axis(said, kind)


def _axis(said: list[tuple[Absolute, Places]], kind: str) -> str | None:
    """The axis along which they lie, if one was told, or is needed to tell the middle one, or the first two."""
    told = {_AXES[place.side]: item for item, place in said if place.side in _AXES}
    if len(told) > 1:
        raise refuse("misplaced", "they lie in one line", max(x.span for x in told.values()), "say 'left' and 'right'")
    inside = any(place.side in _INSIDE for _, place in said)
    if any(place.side in ("first", "last") and (place.several or 1) > 1 for _, place in said):
        if kind in _LIE_ALONG:
            raise refuse(
                "misplaced", "it is not clear which ones these are", said[0][0].span, "say 'the two back rows'"
            )
        return "y"
    if (told or inside) and any(place.side in ("one", "first", "last") for _, place in said):
        raise refuse("misplaced", "it is not clear which one this is", said[0][0].span, "say 'left' and 'right'")
    return next(iter(told), _LIE_ALONG.get(kind, "y") if inside else None)


def _in_order(order: OrderBy, spec: Spec, count: int) -> tuple[list[Look], str | None]:
    """The looks of structures that stand in an order, from the left or from the front."""
    first = order.first or spec.first(*_AXES) or "left"
    items = [item for item in order.items if isinstance(item, Noun) and len(item.traits.colors) == 1]
    if len(items) != count or len(items) != len(order.items) or any(item.amount for item in items):
        raise refuse("count-mismatch", f"there are {count} of them", order.span, "say one thing of each")
    spec.orders.remove(order)
    spec.toward = []
    return list(items if first in ("left", "front") else items[::-1]), _AXES[first]


def _indices(place: Places, count: int, left: list[int]) -> list[int]:
    """Which of so many a part names, counted from the left or from the front; `left`: those not told of yet."""
    many, at = place.several or 1, (place.index or 1) - 1
    if at > 0 and (many > 1 or at >= count):
        return []
    match place.side:
        case "left" | "front" | "first":
            return [*range(at, at + many)]
        case "right" | "back" | "last":
            return [*range(count - at - many, count - at)]
        case "middle" if (count - many) % 2 == 0:
            return [*range((count - many) // 2, (count + many) // 2)]
        case "outer" | "ends" if place.several in (None, 2):
            return [0, count - 1]
        case "inner" if place.several in (None, count - 2):
            return [*range(1, count - 1)]
        case "rest" if place.several in (None, len(left)):
            return left
    return []
