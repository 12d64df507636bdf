""" "The smallest number at the left": what is said of an end of a line sorts it, where no other order is given."""

from __future__ import annotations

from rpg.core.diagnostics import Span
from rpg.ir.order import Order
from rpg.language.meaning import Absolute, At, Noun, OrderBy, Places
from rpg.passes.schema.resolve.clauses.spec import Spec
from rpg.passes.schema.resolve.orders.agreeing import OPPOSITE, forget_side, key
from rpg.passes.schema.resolve.orders.positions import SIDES, Placed
from rpg.passes.schema.resolve.things.world import Scene, refuse

_EXTREMES = ("smallest", "largest")


def sorted_from(spec: Spec, names: tuple[str, ...], kind: str, scene: Scene) -> list[OrderBy]:
    """The order that an extreme at an end stands for; what said so is taken out of `spec`."""
    told = next((o for o in spec.orders if o.values == ("end",)), None)
    if told is not None and not any(t.first for t in spec.toward):
        _not_in_a_stack(kind, told.span)
    found: OrderBy | None = None
    ends = [(item, _order(item, spec, names, kind, scene)) for item in spec.absolutes]
    told_ends = [order for _, order in ends if order is not None]
    if len(told_ends) == 1 and told_ends[0].by == "size" and told_ends[0].first and not spec.orders:
        return []  # "the biggest at the bottom": the others stand as they like
    for item, order in ends:
        if order is None:
            continue
        spec.absolutes.remove(item)
        if found is not None and not _agree(found, order):
            raise refuse("contradiction", "these ends do not fit one order", order.span, "keep one of them")
        found = found or order
    if found is None:
        return []
    scene.assume("what is said of one end is read as the order of all of them")
    return [found]


def tells_an_end(item: Absolute) -> bool:
    """ "Starting with the largest": which of them is the first one."""
    theme, place = item.theme, item.adjuncts[0] if len(item.adjuncts) == 1 else None
    ranked = isinstance(theme, Noun) and theme.traits.rank in _EXTREMES
    return ranked and isinstance(place, At | Places) and (place.side, place.index) == ("first", 1)


def _not_in_a_stack(kind: str, span: Span) -> None:
    if kind == "stack":
        raise refuse("ambiguous", "the first one may be at the bottom or on top", span, "say '... at the bottom'")


def _order(item: Absolute, spec: Spec, names: tuple[str, ...], kind: str, scene: Scene) -> OrderBy | None:
    theme, place = item.theme, item.adjuncts[0] if len(item.adjuncts) == 1 else None
    if not isinstance(theme, Noun) or theme.traits.rank not in _EXTREMES or theme.traits.colors:
        return None
    if isinstance(place, Places) and (place.unit, place.several, place.of) != ("block", None, None):
        return None
    ends = [("first", 1), *((side, None) for side in SIDES[kind])]
    if not isinstance(place, At | Places) or (place.side, place.index) not in ends:
        return None
    kinds = {scene.things[n].kind for n in names}
    if theme.traits.kind == "letter" or "letter" in kinds:
        return None
    if place.side == "first" and not any(t.first for t in spec.toward):
        _not_in_a_stack(kind, item.span)
    first = None if place.side == "first" else place.side
    by = "number" if theme.traits.kind == "digit" or kinds == {"digit"} else "size"
    return OrderBy(by=by, first=first, descending=theme.traits.rank == "largest", span=item.span)


def _agree(one: OrderBy, two: OrderBy) -> bool:
    """Whether the same order is said from both ends."""
    return one.by == two.by and one.descending != two.descending and two.first == OPPOSITE.get(one.first or "")


def directed(
    order: Order, placed: Placed, names: tuple[str, ...], kind: str, scene: Scene, first: str | None, starts: bool
) -> Order | None:
    """ "in numeric order with 1 at the bottom": a place that fits the order one way round says which end is first.

    What descends along a line is read from its usual side. `first`: the side where it begins, where that was said.
    `starts`: the place is the beginning, from which a rainbow runs either way.
    """
    if first is None and order.by == "mirrored" and _in_the_middle(order, placed, names, scene):
        return order
    listed = [n for rank in order.ranks for n in rank] if order.by == "given" else []
    ranked = [(k, n) for k, n in enumerate(listed)] if listed else [(key(order, scene.things[n]), n) for n in names]
    first = order.first if listed else first
    keys = [one for one, _ in ranked if one is not None]
    if len(keys) < len(names) or len(set(keys)) < len(keys):
        return None
    row = [n for _, n in sorted(ranked, key=lambda pair: (pair[0] is None, pair[0]), reverse=order.descending)]
    free = scene.free_runs.pop(placed.ranks, ())
    side = placed.first or SIDES[kind][0]
    if first is not None:
        ahead = row if first == side else row[::-1]
        turned = [(ahead[::-1], True)] if starts and order.by == "rainbow" and not order.descending else []
        for way, descending in [(ahead, order.descending), *turned]:
            if _fits(way, placed, free):
                return order.model_copy(update={"first": first, "descending": descending})
        return None
    ways = [(side, row), (OPPOSITE[side], row[::-1])]
    one_way = (order.descending and kind != "stack") or (starts and order.by in ("label", "number", "size"))
    for begin, way in ways[:1] if one_way else ways:
        if _fits(way, placed, free):
            forget_side(scene)
            return order.model_copy(update={"first": begin})
    return None


def _in_the_middle(order: Order, placed: Placed, names: tuple[str, ...], scene: Scene) -> bool:
    """Whether the one block that has a place is the one that a mirrored line has in its middle anyway."""
    if order.attribute != "color" or [len(rank) == 1 for rank in placed.ranks[1:2]] != [True]:
        return False
    colors = [scene.things[n].color for n in names]
    odd = [color for color in dict.fromkeys(colors) if colors.count(color) % 2]
    outside = [len(placed.ranks[n]) for n in scene.free_runs.get(placed.ranks, ())]
    return outside == [len(names) // 2] * 2 and odd == [scene.things[placed.ranks[1][0]].color]


def _fits(row: list[str], placed: Placed, free: tuple[int, ...]) -> bool:
    """Whether every block that has a place stands there."""
    at = 0
    for index, rank in enumerate(placed.ranks):
        if index not in free and set(row[at : at + len(rank)]) != set(rank):
            return False
        at += len(rank)
    return True
