"""What alternates along a line: colours, sizes, kinds, vowels and consonants, odd and even digits."""

from __future__ import annotations

from collections import Counter

from rpg.ir.order import Attribute
from rpg.language.lexicon import COLORS, RAINBOW
from rpg.language.meaning import At, Coord, Noun, OrderBy, Structure, Traits, replace
from rpg.passes.schema.resolve.clauses.spec import Spec
from rpg.passes.schema.resolve.orders.parts import place_of
from rpg.passes.schema.resolve.things.things import fits
from rpg.passes.schema.resolve.things.world import Ref, Scene, Thing, refuse

_SORTS: dict[frozenset[str | None], Attribute] = {
    frozenset({"odd", "even"}): "parity",
    frozenset({"vowel", "consonant"}): "vowel",
    frozenset({"letter", "digit"}): "kind",
}
"""Sorts of symbols that may take turns, and what tells them apart."""


def as_listed(shape: Structure, spec: Spec, theme: Ref | None, scene: Scene) -> Structure:
    """ "A red, blue, red, blue tower": looks of which one comes again are told block by block.

    "An alternating tower, red and white, four high": which two take turns. "Three red and three white blocks take
    turns": these are its blocks.
    """
    colors = shape.traits.colors
    lined = shape.kind in ("stack", "row", "line", "column") and not shape.plural
    if lined and theme is None:
        _with_another(shape, spec, scene)
    if not lined or theme is not None or shape.members is not None:
        return shape
    turns = [o for o in spec.orders if o.by == "alternating"]
    pair = [o for o in spec.orders if o.by == "named" and len(o.items) == 2 and not o.first]
    if len(turns) == 1 and len(pair) == 1 and not turns[0].items:
        turns = [replace(turns[0], items=pair[0].items)]
        spec.orders = [turns[0] if o.by == "alternating" else o for o in spec.orders if o is not pair[0]]
    counted = len(turns) == 1 and all(isinstance(x, Noun) and x.amount for x in turns[0].items)
    if counted and turns[0].items and not (spec.usings or shape.sizes or colors):
        looks = tuple(replace(x, amount=None) for x in turns[0].items if isinstance(x, Noun))
        spec.orders = [replace(o, items=looks) if o is turns[0] else o for o in spec.orders]
        return replace(shape, members=Coord(op="and", items=turns[0].items, span=turns[0].span))
    if len(set(colors)) == len(colors) or shape.sizes or any(o.items for o in spec.orders):
        return shape
    items = tuple(Noun(head="any", traits=Traits(colors=(color,)), span=shape.span) for color in colors)
    spec.orders = [OrderBy(by="named", items=items, attribute="color", span=shape.span), *spec.orders]
    return replace(shape, traits=replace(shape.traits, colors=()))


def _with_another(shape: Structure, spec: Spec, scene: Scene) -> None:
    """ "A tower of four in alternating colours with black at the bottom": black and another colour take turns."""
    open_ = shape.members is None or (isinstance(shape.members, Noun) and shape.members.traits == Traits())
    turns = [n for n, o in enumerate(spec.orders) if o.by == "alternating" and not o.items]
    ends = [x.theme for x in spec.absolutes if isinstance(at := place_of(x), At) and at.side in _ENDS]
    colors = [*dict.fromkeys(x.traits.colors[0] for x in ends if isinstance(x, Noun) and len(x.traits.colors) == 1)]
    listed = any(o.items for o in spec.orders)
    if listed or not open_ or shape.traits.colors or len(turns) != 1 or not 0 < len(colors) <= _PAIR:
        return
    if len(colors) < _PAIR:
        colors.append("blue" if colors == ["red"] else "red")
        scene.assume(f"the other of the two colours is not said: {colors[1]}")
    items = tuple(Noun(head="any", traits=Traits(colors=(look,)), span=shape.span) for look in colors)
    spec.orders[turns[0]] = replace(spec.orders[turns[0]], items=items)


_ENDS = frozenset({"top", "bottom", "left", "right", "front", "back", "first", "last"})


def alternating(order: OrderBy, things: list[Thing], scene: Scene) -> Attribute:
    """What an alternation or a mirrored line is told apart by; colours are given to blocks that have none."""
    if order.by == "alternating" and not order.values and (order.attribute == "size" or _by_size(order, things)):
        _two_sizes(order, things)
        return "size"
    if order.items and order.by == "alternating":
        sorts = [x.traits for x in order.items if isinstance(x, Noun) and not x.traits.colors]
        told = _SORTS.get(frozenset(x.quality or x.kind for x in sorts)) if len(sorts) == len(order.items) else None
        if told is not None:
            _of_both_sorts(order, things, sorts)
            return told
        _alternate(order, things)
        return "color"
    if (attribute := _telling(things)) == "color":
        _two_colors(things, order.by, scene)
    if order.by == "mirrored" and attribute in ("color", "label"):
        looks = Counter(t.color if attribute == "color" else t.label for t in things)
        if sum(many % 2 for many in looks.values()) > 1:
            raise refuse("contradiction", "no order of these blocks is its own mirror image", order.span,
                         "have two of each, and at most one that stands in the middle")  # fmt: skip
    return attribute


def _by_size(order: OrderBy, things: list[Thing]) -> bool:
    """Whether what is told of the blocks is how large they are: "three small and three large cubes, alternating"."""
    told = [x.traits for x in order.items if isinstance(x, Noun)]
    if order.items:
        return len(told) == len(order.items) == len({x.size for x in told}) and not any(x.colors for x in told)
    return len({t.size for t in things}) > 1 and len({t.color for t in things}) == 1 and not any(t.kind for t in things)


def _two_sizes(order: OrderBy, things: list[Thing]) -> None:
    if len({t.size for t in things}) != _PAIR:
        raise refuse("contradiction", "these blocks are not of two sizes", order.span, "say 'small and large blocks'")


_PAIR = 2
_HOW = "it is not clear how these alternate: in this order again and again, or just so that no neighbours are alike?"


def _of_both_sorts(order: OrderBy, things: list[Thing], sorts: list[Traits]) -> None:
    lots = [[thing for thing in things if fits(thing, sort)] for sort in sorts]
    if not all(lots) or sum(map(len, lots)) != len(things):
        raise refuse("contradiction", "the blocks are not of these two sorts", order.span, "name blocks of both sorts")


def _alternate(order: OrderBy, things: list[Thing]) -> None:
    """Two colours said with the alternation."""
    looks = [i.traits.colors or i.traits.labels for i in order.items if isinstance(i, Noun)]
    colors = [look[0] for look in looks if len(look) == 1 and look[0] in COLORS]
    if len(set(looks)) == len(order.items) > 1 and (len(colors) > 2 or not colors) and all(map(len, looks)):
        raise refuse("ambiguous", _HOW, order.span, "list all the blocks in their order")
    if len(colors) != 2 or len(order.items) != 2:
        raise refuse("misplaced", "an alternation is of two colours", order.span, "say 'alternating red and blue'")
    counts = [x.amount.low for x in order.items if isinstance(x, Noun) and x.amount is not None]
    there = sorted(sum(t.color == color for t in things) for color in colors)
    if max(counts, default=1) > 1 and sorted(counts) != there and all(t.color for t in things):
        raise refuse("ambiguous", _HOW, order.span, "list all the blocks in their order")
    if max(counts, default=1) > 1 and sum(counts) != len(things):
        raise refuse("ambiguous", _HOW, order.span, "list all the blocks in their order")
    for index, thing in enumerate(things):
        if thing.color is None and thing.kind is None:
            thing.color = colors[index % 2]
    if {t.color for t in things} != set(colors):
        raise refuse("contradiction", "the blocks have other colours", order.span, "name two colours that they have")


def _telling(things: list[Thing]) -> Attribute:
    """What tells blocks apart that take turns: their colours; of those in one colour, their kinds or their symbols."""
    if len({t.color for t in things}) > 1 or not any(t.kind for t in things):
        return "color"
    if len({t.kind for t in things}) == 2:
        return "kind"
    labels = {t.label for t in things}
    return "label" if None not in labels and 1 < len(labels) < len(things) else "color"


def _two_colors(things: list[Thing], by: str, scene: Scene) -> None:
    """Colours for an alternation or a mirrored line where none were said."""
    if any(t.color or t.label for t in things) or not things:
        return
    half = (len(things) + 1) // 2
    for index, thing in enumerate(things):
        place = index % 2 if by == "alternating" else min(index, len(things) - 1 - index) % max(1, half)
        thing.color = (
            RAINBOW[0]
            if by == "alternating" and place == 0
            else "blue"
            if by == "alternating"
            else RAINBOW[place % len(RAINBOW)]
        )
    scene.assume(
        "the colours are not said: red and blue"
        if by == "alternating"
        else "the colours are not said: pairs of equal colours"
    )
