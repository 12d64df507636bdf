""" "Move the tower to the blue patch, keeping the order", "lay them in a row in the same order": that of the start."""

from __future__ import annotations

from rpg.core.diagnostics import Span
from rpg.ir import goal as g
from rpg.ir import structures as s
from rpg.ir.order import Order
from rpg.ir.walk import transform
from rpg.language.meaning import At, Meaning, Noun, Traits
from rpg.passes.schema.resolve.clauses.spec import Spec
from rpg.passes.schema.resolve.orders.reordered import FIRST, LAST, line_of_the_start, lines_of_the_start
from rpg.passes.schema.resolve.things.world import Scene, refuse


def note_what_is_kept(spec: Spec, scene: Scene, span: Span) -> None:
    """Take note of words that keep an order, and of the place of an end of it: "the bottom cube at the left"."""
    kept = [order for order in spec.orders if order.by == "kept"]
    if not kept:
        return
    spec.orders = [order for order in spec.orders if order.by != "kept"]
    if not lines_of_the_start(scene):  # what is told of the start may be told by this very clause
        scene.same_order.append(((), None, kept[0].span or span))
        return
    home = line_of_the_start(scene, kept[0].span)
    first = None
    begin = home.side or FIRST[home.kind]
    for item in list(spec.absolutes):
        place = item.adjuncts[0] if len(item.adjuncts) == 1 else None
        end = _end(item.theme, home.members, begin, scene)
        if isinstance(place, At) and place.index is None and end and place.side in LAST:
            first = place.side if end == begin else LAST[place.side]
            spec.absolutes.remove(item)
    scene.same_order.append((home.members, first, kept[0].span or span))


def _end(theme: Meaning, names: tuple[str, ...], begin: str, scene: Scene) -> str | None:
    """The side of the line at which a block is there at the start."""
    if not isinstance(theme, Noun) or theme.plural:
        return None
    marks = theme.traits
    if marks.rank is not None:
        return marks.rank if marks.rank in (begin, LAST[begin]) else None
    for name, side in ((names[0], begin), (names[-1], LAST[begin])):
        thing = scene.things[name]
        told = (thing.color,) == marks.colors or (thing.label,) == marks.labels
        if told and marks in (Traits(colors=marks.colors), Traits(labels=marks.labels)):
            return side
    return None


def with_order_kept(goal: g.Goal, scene: Scene) -> g.Goal:
    """The goal with its lines in the order that they are said to keep."""
    for told, side, span in scene.same_order:
        found: list[g.Goal] = []
        names = told or line_of_the_start(scene, span).members

        def change(
            node: g.Goal, names: tuple[str, ...] = names, side: str | None = side, found: list[g.Goal] = found
        ) -> g.Goal:
            if not isinstance(node, s.Row | s.Stack) or {*node.blocks} != {*names}:
                return node
            open_ = node.order.by == "any"
            way = next((x for x in (names, names[::-1]) if open_ or (side is None and _fits(node.order, x))), None)
            if way is None:
                return node
            found.append(node)
            return _in_order(node, way, side if open_ else node.order.first, scene)

        goal = transform(goal, change)
        if len(found) != 1:
            raise refuse("ambiguous", "it is not clear what is to be in this order", span,
                         "say 'in a row' or 'in a tower', or name the blocks in their order")  # fmt: skip
    return goal


def _fits(order: Order, names: tuple[str, ...]) -> bool:
    """Whether what is told of some places of a line agrees with its blocks in this order."""
    at = 0
    for rank in order.ranks:
        if {*rank} != {*names[at : at + len(rank)]}:
            return False
        at += len(rank)
    return order.by == "given" and at == len(names) and not order.descending


def _in_order(line: s.Row | s.Stack, names: tuple[str, ...], side: str | None, scene: Scene) -> g.Goal:
    usual = "bottom" if isinstance(line, s.Stack) else "front" if line.axis == "x" else "left"
    first = side or usual
    upright = first in ("bottom", "top")
    if upright != isinstance(line, s.Stack):
        raise refuse("misplaced", "the line has no such end", line.span, "say 'at the left' of a row")
    if side is None:
        scene.assume(f"in the same order as at the start, from {first} to {LAST[first]}")
    order = Order(by="given", ranks=tuple((name,) for name in names), first=first)  # type: ignore[arg-type]
    fixed = {} if upright else {"axis": "x" if first in ("front", "back") else "y"}
    return line.model_copy(update={"order": order, **fixed})
