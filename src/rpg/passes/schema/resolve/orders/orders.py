"""Orders of lines and stacks: from what was said to `Order`, with looks for members where they were left open."""

from __future__ import annotations

from rpg.core.diagnostics import Span
from rpg.ir.order import Order
from rpg.language.lexicon import RAINBOW
from rpg.language.meaning import OrderBy, Toward, replace
from rpg.passes.schema.resolve.clauses.one_each import ONE_END
from rpg.passes.schema.resolve.clauses.spec import Spec
from rpg.passes.schema.resolve.orders.agreeing import OPPOSITE, Ranks, agreed, one_way
from rpg.passes.schema.resolve.orders.alternating import alternating
from rpg.passes.schema.resolve.orders.backwards import last_first, turned_round
from rpg.passes.schema.resolve.orders.between_ends import between_ends
from rpg.passes.schema.resolve.orders.by_size import at_one_end
from rpg.passes.schema.resolve.orders.extremes import directed, sorted_from
from rpg.passes.schema.resolve.orders.kinds_first import by_kind, check_which_sorted, each_sorted
from rpg.passes.schema.resolve.orders.onward import onward
from rpg.passes.schema.resolve.orders.parts import place_of
from rpg.passes.schema.resolve.orders.positions import SIDES, Placed, belongs, doubled, positions
from rpg.passes.schema.resolve.orders.reading import reading_begins
from rpg.passes.schema.resolve.orders.runs import painted
from rpg.passes.schema.resolve.orders.way_told import way_told
from rpg.passes.schema.resolve.things.items import by_look, claimed, claims
from rpg.passes.schema.resolve.things.world import Scene, Scope, Thing, refuse


def implied_kind(spec: Spec) -> str | None:
    """The kind of block that an order takes for granted: letters for alphabetical, digits for numeric."""
    for order in spec.orders:
        if order.by in ("label", "vowel_first", "consonant_first"):
            return "letter"
        if order.by in ("number", "even_first", "odd_first"):
            return "digit"
    return None


def order_of(spec: Spec, names: tuple[str, ...], kind: str, scene: Scene, scope: Scope, span: Span) -> Order:
    """The order of `names` in a line or stack of `kind`."""
    sides = SIDES[kind]
    _left_open(spec, names, scene)
    check_which_sorted(spec.orders)
    told_by_ends = [*sorted_from(spec, names, kind, scene), *last_first(spec, names, scene)]
    spec.orders = way_told([*_as_listed(spec, names, scene, sides), *told_by_ends], names, scene)
    pointed = [o for o in spec.orders if o.first in sides and o.by in _FROM_AN_END]
    first = spec.first(*sides) or next((o.first for o in spec.orders if o.first in sides and o not in pointed), None)
    turned = next((o for o in spec.orders if o.by in ("named", "given") and o.first not in (None, first)), None)
    if first is not None and turned is not None:
        raise refuse("order-conflict", "this begins at two ends", turned.span, "keep one of them")
    wrong: Toward | OrderBy | None = next((t for t in spec.toward if t.first and t.first not in sides), None)
    wrong = wrong or next((o for o in spec.orders if o.first and o.first not in sides and o.by in _FROM_AN_END), None)
    if wrong is not None:
        raise refuse(
            "misplaced", f"this direction does not fit a {kind}", wrong.span, f"say from {sides[0]} to {sides[1]}"
        )
    found, told = Order(), first
    for order in sorted(spec.orders, key=lambda o: (not _gives_looks(o, names, scene), o.by in _LATER)):
        merged = _merge(found, order, names, kind, scene, scope, order.first if order in pointed else first)
        if merged.by == "given" and not order.items and len(merged.ranks) == len(names) == sum(map(len, spec.in_turn)):
            merged = merged.model_copy(update={"ranks": spec.in_turn})
        if found.by == merged.by != "any" and not scene.lenient:
            points = order in pointed or order.by in _FROM_BELOW
            merged = one_way(found, merged, points, told) or _two_orders(order.span)
        told = told or (order.first if order in pointed else "bottom" if order.by in _FROM_BELOW else None)
        if found.by not in ("any", merged.by) and order.by not in ("in_order", "paged", "reverse", "either", "any"):
            if scene.lenient:
                continue
            merged = agreed(found, merged, first is not None, scene) or _two_orders(order.span)
        found = merged
    if any(o.by == "reverse" for o in spec.orders):
        found = turned_round(found, spec, told_by_ends, scene, names, first or _default_side(kind), span)
    looks = [(scene.things[n].color, scene.things[n].label) for n in names]
    if found.by == "mirrored" and spec.listed and looks == looks[::-1]:
        found = Order()
        spec.orders = [o for o in spec.orders if o.by != "mirrored"]
    as_listed = found.by == "any" and not spec.orders and spec.listed and (first or doubled(names, scene))
    if as_listed:
        found = _merge(found, OrderBy(by="given", span=span), names, kind, scene, scope, first)
    starts = all(place.side == "first" for place in map(place_of, spec.absolutes) if place is not None)
    inside = kind == "stack" or all(belongs(item.theme, names, scene) for item in spec.absolutes)
    spec.absolutes = onward(spec.absolutes) if inside else spec.absolutes
    placed = _placed(spec, names, kind, scene, first if starts else None)
    if placed is not None and found.by == "alternating":
        return _begun(found, placed, names, kind, scene, span)
    if placed is not None and (way := directed(found, placed, names, kind, scene, first, starts)) is not None:
        return way
    if placed is not None and not (scene.lenient and found.by != "any"):
        if found.by != "any" and not (as_listed and len({*looks}) < len(names)):  # "four white ones and a red one"
            return _two_orders(span)
        if first is not None and placed.first not in (None, first):
            raise refuse("order-conflict", "the places are counted from two sides", span, "keep one of them")
        free = placed.paired or any(o.by == "any" for o in spec.orders)
        ranks = placed.ranks if free else between_ends(placed.ranks, names, scene)
        found = Order(by="given", ranks=ranks, first=placed.first)  # type: ignore[arg-type]
    if found.by != "any" and first and found.first is None:
        found = found.model_copy(update={"first": first})
    return _either_way(found, spec, kind, first)


def _left_open(spec: Spec, names: tuple[str, ...], scene: Scene) -> None:
    """ "In any order": that in which they are listed is none."""
    if any(o.by == "any" for o in spec.orders):
        scene.in_any_order.add(frozenset(names))
        spec.orders = [o for o in spec.orders if not (o.items and o.by in ("named", "given"))]


def _placed(spec: Spec, names: tuple[str, ...], kind: str, scene: Scene, first: str | None) -> Placed | None:
    """Places in the line; one that begins with a block begins at its own end (`first`)."""
    placed = positions(spec, names, kind, scene)
    return replace(placed, first=first) if placed is not None and first is not None and not placed.paired else placed


def _two_orders(span: Span) -> Order:
    raise refuse("order-conflict", "two orders are given for the same blocks", span, "keep one of them")


_FROM_AN_END = ("number", "extreme")
"""Orders that may be told by what stands at an end."""
_FROM_BELOW = ("size_up", "size_down", "number_up", "number_down")
"""Orders told by what is at the bottom."""


def _either_way(found: Order, spec: Spec, kind: str, first: str | None) -> Order:
    """ "in either direction": no end of a line is its beginning."""
    said = next((o for o in spec.orders if o.by == "either"), None)
    if said is None:
        return found
    if kind == "stack" or first is not None:
        raise refuse("order-conflict", "this has one direction, and either is asked for", said.span, "leave one out")
    if found.by == "any":
        raise refuse("ambiguous", "it is not said which order may go either way", said.span, "name the order")
    return found.model_copy(update={"first": None})


def _begun(found: Order, placed: Placed, names: tuple[str, ...], kind: str, scene: Scene, span: Span) -> Order:
    """ "alternating red and blue, blue at the bottom": of the two alternations the one that fits."""
    looks = {n: scene.things[n].color for n in names}
    for begin in sorted({look for look in looks.values() if look}):
        one = [n for n in names if looks[n] == begin]
        two = [n for n in names if looks[n] != begin]
        row = [(one if k % 2 == 0 else two)[k // 2 : k // 2 + 1] for k in range(len(names))]
        said = [n for rank in placed.ranks for n in (rank if len(rank) == 1 else (None,) * len(rank))]
        fits = all(a is None or (b and looks[a] == looks[b[0]]) for a, b in zip(said, row, strict=True))
        if fits and all(row) and len({looks[n] for n in two}) == 1 and abs(len(one) - len(two)) < 2:
            return Order(by="given", ranks=tuple(map(tuple, row)), first=placed.first)  # type: ignore[arg-type]
    return _two_orders(span)


def _read_from(begin: str, scene: Scene) -> None:
    scene.assume(f"the order is read from {begin} to {OPPOSITE[begin]}")


def _default_side(kind: str) -> str:
    return "bottom" if kind == "stack" else "front" if kind == "column" else "left"


def _merge(
    found: Order, order: OrderBy, names: tuple[str, ...], kind: str, scene: Scene, scope: Scope, first: str | None
) -> Order:
    things = [scene.things[n] for n in names]
    match order.by:
        case "any" | "reverse" | "either":
            return found
        case "read":
            begin = order.first or first or reading_begins(order, names, kind, scene)
            return _given(order, names, kind, scene, scope, begin)
        case "given" | "named" | "run" if order.items:
            return _given(order, names, kind, scene, scope, first)
        case "backwards":
            return Order(by="given", ranks=tuple((n,) for n in reversed(names)), first=first or _default_side(kind))  # type: ignore[arg-type]
        case "given" if not any(t.color or t.label or t.size or t.edge for t in things):
            raise refuse("no-referent", "these blocks were told in no order", order.span, "list them in their order")
        case "given":
            begin = first or _default_side(kind)
            scene.assume(f"in the order in which the blocks are named, from {begin} to {OPPOSITE.get(begin, 'last')}")
            return Order(by="given", ranks=tuple((n,) for n in names), first=first or _default_side(kind))  # type: ignore[arg-type]
        case "in_order":
            return _in_order(found, things, names, kind, scene, order, first)
        case "paged":
            return _paged(found, order, things, names, kind, scene, first)
        case "label" | "number" | "ascending":
            return _symbolic(order, things, kind, scene, first)
        case "countdown" | "count_up" | "number_up" | "number_down":
            return _counted(order, things, kind, scene, first)
        case "rainbow":
            return _rainbow(order, things, kind, scene, first)
        case "extreme" if any(t.kind == "letter" for t in things):
            raise refuse("misplaced", "letters are not ordered by size", order.span, "say 'in alphabetical order'")
        case "extreme":
            by = "number" if {t.kind for t in things} <= {"digit"} else "size"
            whole = _merge(found, replace(order, by=by), names, kind, scene, scope, first)
            return (at_one_end(order, things) or whole) if (by, order.attribute) == ("size", ONE_END) else whole
        case "size_down" | "size_up" if {t.kind for t in things} == {"digit"}:
            by = "number_down" if order.by == "size_down" else "number_up"
            return _merge(found, replace(order, by=by), names, kind, scene, scope, first)
        case "size" | "size_down" | "size_up":
            return _by_size(order, things, kind, scene, first)
        case "alternating" | "mirrored":
            return Order(by=order.by, attribute=alternating(order, things, scene))
        case "even_first" | "odd_first" | "vowel_first" | "consonant_first":
            return _quality_first(order, things, kind, scene, first)
        case "by_color" | "grouped":
            return Order(by="together", attribute="color")
        case "by_label":
            return Order(by="together", attribute="label")
        case "attribute":
            if order.attribute == "size":
                return _by_size(order, things, kind, scene, first)
            if order.attribute == "label":
                return _symbolic(order, things, kind, scene, first)
            return Order(by="together", attribute=order.attribute)  # type: ignore[arg-type]
        case _:
            raise refuse("misplaced", "this order does not fit here", order.span)


def _paged(
    found: Order,
    order: OrderBy,
    things: list[Thing],
    names: tuple[str, ...],
    kind: str,
    scene: Scene,
    first: str | None,
) -> Order:
    """ "from left to right and top to bottom": symbols in their order, other blocks as they are listed."""
    if len({t.kind for t in things}) == 1 and {t.kind for t in things} <= {"letter", "digit"}:
        labels = [t.label or "" for t in things]
        if all(labels) and labels != sorted(labels):
            raise refuse("ambiguous", "these could be sorted, or stand as they are listed", order.span,
                         "say 'in alphabetical order', or 'in the order' with all of them")  # fmt: skip
        return _in_order(found, things, names, kind, scene, order, first)
    if found.by != "any" or not all(t.label or t.color for t in things):
        return _in_order(found, things, names, kind, scene, order, first)
    return Order(by="given", ranks=tuple((n,) for n in names), first=_default_side(kind))  # type: ignore[arg-type]


_LATER = ("given", "in_order", "paged", "reverse")
"""What an order is checked against that is sorted by what the blocks look like."""


def _as_listed(spec: Spec, names: tuple[str, ...], scene: Scene, sides: tuple[str, ...]) -> list[OrderBy]:
    """ "Red, green and blue in order from bottom to top": colours have no order but that of their list."""
    colored = all(scene.things[n].color and not scene.things[n].label for n in names)
    if not (colored and spec.listed and spec.first(*sides) and all(o.by == "in_order" for o in spec.orders)):
        return spec.orders
    return [replace(order, by="given") for order in spec.orders]


def _gives_looks(order: OrderBy, names: tuple[str, ...], scene: Scene) -> bool:
    """ "Line up cubes in rainbow order: red, yellow, green": a list that says what they look like is read first."""
    told = order.by == "given" and len(order.items) == len(names)
    return told and all(scene.things[n].color is None and scene.things[n].label is None for n in names)


def _counted(order: OrderBy, things: list[Thing], kind: str, scene: Scene, first: str | None) -> Order:
    """Numbers that count up or down, along a line or a tower."""
    number = replace(order, by="number")
    if order.by in ("number_up", "number_down"):
        made = _symbolic(number, things, kind, scene, "bottom")
        return made.model_copy(update={"descending": order.by == "number_down"})
    if order.by == "count_up":
        return _symbolic(number, things, kind, scene, first or ("bottom" if kind == "stack" else None))
    if kind == "stack" and first is None:
        raise refuse("ambiguous", "it is not said from which end this counts down", order.span,
                     "say 'from top to bottom' or 'from bottom to top'")  # fmt: skip
    return _symbolic(number, things, kind, scene, first)


def _given(order: OrderBy, names: tuple[str, ...], kind: str, scene: Scene, scope: Scope, first: str | None) -> Order:
    ranks: list[tuple[str, ...]] = []
    told = claims(order.items, names, scene)
    for item in order.items:
        had = {name for rank in ranks for name in rank}
        ranks.append(claimed(item, names, scene) if told else by_look(item, names, had, scene))
    listed = [n for rank in ranks for n in rank]
    missing = [n for n in names if n not in listed]
    if missing or len(set(listed)) != len(listed) or not set(listed) <= set(names):
        raise refuse(
            "count-mismatch", f"the order lists {len(set(listed))} of {len(names)} blocks", order.span,
            "list every block once",
            listed=len(set(listed)), blocks=len(names),
        )  # fmt: skip
    if first is None:
        _read_from(_default_side(kind), scene)
    return Order(by="given", ranks=tuple(ranks), first=first or _default_side(kind))  # type: ignore[arg-type]


def _in_order(
    found: Order,
    things: list[Thing],
    names: tuple[str, ...],
    kind: str,
    scene: Scene,
    order: OrderBy,
    first: str | None,
) -> Order:
    if found.by != "any":
        return found
    kinds = {t.kind for t in things}
    if kinds == {"letter"}:
        return _symbolic(OrderBy(by="label", span=order.span), things, kind, scene, first)
    if kinds == {"digit"}:
        return _symbolic(OrderBy(by="number", span=order.span), things, kind, scene, first)
    raise refuse(
        "ambiguous",
        "it is not said in which order",
        order.span,
        "say 'in the order red, green, blue' or 'in rainbow order'",
    )


def _symbolic(order: OrderBy, things: list[Thing], kind: str, scene: Scene, first: str | None) -> Order:
    kinds = {t.kind for t in things}
    plain = order.attribute == "size" and kinds == {None}  # "from smallest to largest", of blocks that show nothing
    if order.by == "ascending" and None in kinds and (plain or len({t.size or t.edge for t in things}) > 1):
        return _by_size(order, things, kind, scene, first)
    by = "number" if order.by == "number" or (order.by != "label" and kinds <= {"digit", None}) else "label"
    want = "digit" if by == "number" else "letter"
    for thing in things:
        if thing.kind == "symbol" or (thing.kind is None and not thing.color):
            thing.kind = want
    if first is None:
        first = "top" if kind == "stack" else _default_side(kind)
        _read_from("top" if kind == "stack" else _default_side(kind), scene)
    return Order(by=by, descending=order.descending, first=first)  # type: ignore[arg-type]


def _by_size(order: OrderBy, things: list[Thing], kind: str, scene: Scene, first: str | None) -> Order:
    if len({t.size or t.edge for t in things}) < 2 and len(things) > 1:
        edges = [round(0.03 + 0.02 * i / max(1, len(things) - 1), 4) for i in range(len(things))]
        for thing, edge in zip(things, edges, strict=True):
            thing.edge = edge
        scene.assume("the sizes are not said: edges from 3 to 5 cm")
    if order.by in ("size_down", "size_up"):
        if kind != "stack":
            raise refuse(
                "misplaced", "a line on the table has no top and bottom", order.span, "say 'from left to right'"
            )
        return Order(by="size", first="bottom", descending=order.by == "size_down")
    return Order(by="size", descending=order.descending, first=first or _default_side(kind))  # type: ignore[arg-type]


def _rainbow(order: OrderBy, things: list[Thing], kind: str, scene: Scene, first: str | None) -> Order:
    """A gradient; where both its ends are told, it begins with the first of them."""
    if not order.values:
        _paint(things, scene)
        return Order(by="rainbow", descending=order.descending, first=first)  # type: ignore[arg-type]
    if first is None and kind != "line":
        first = _default_side(kind)
        _read_from(first, scene)
    return Order(by="rainbow", descending=painted(order, things, scene), first=first)  # type: ignore[arg-type]


def _paint(things: list[Thing], scene: Scene) -> None:
    """A gradient wants different colours: give those that are open a run of the rainbow."""
    known = {t.color for t in things if t.color}
    spare = iter(c for c in RAINBOW if c not in known)
    for thing in things:
        if thing.color is None and thing.kind is None:
            thing.color = next(spare, RAINBOW[-1])
            scene.assume("the colours are not said: a run of the rainbow from red on")


def _quality_first(order: OrderBy, things: list[Thing], kind: str, scene: Scene, first: str | None) -> Order:
    ranks: Ranks = by_kind(order, things)
    if order.items:
        ranks = each_sorted(ranks, order.items, things, scene)
    if first is None:
        _read_from("top" if kind == "stack" else _default_side(kind), scene)
    return Order(by="given", ranks=ranks, first=first or ("top" if kind == "stack" else "left"))  # type: ignore[arg-type]
