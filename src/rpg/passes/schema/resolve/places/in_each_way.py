"""Places told of a line that may be laid in several ways already: each of these has them, or is none any more."""

from __future__ import annotations

from rpg.core.diagnostics import Span
from rpg.ir import goal as g
from rpg.ir import structures as s
from rpg.ir.walk import transform
from rpg.passes.schema.resolve.orders.agreeing import in_place
from rpg.passes.schema.resolve.orders.positions import MAX_ALTERNATIVES
from rpg.passes.schema.resolve.structures.structures import either
from rpg.passes.schema.resolve.things.world import Scene, refuse


def ways_of(goal: g.Goal, node: s.Stack | s.Row) -> tuple[g.Goal, list[s.Stack | s.Row]]:
    """The line with all the other ways to fill what was left open in it, of which one is to hold."""
    found: list[g.Any] = []

    def seen(part: g.Goal) -> g.Goal:
        found.extend([part] if isinstance(part, g.Any) and node in part.goals else [])
        return part

    transform(goal, seen)
    for some in found:
        ways = [x for x in some.goals if isinstance(x, s.Stack | s.Row) and {*x.blocks} == {*node.blocks}]
        if len(ways) == len(some.goals):
            return some, ways
    return node, [node]


def settled(
    ways: list[s.Stack | s.Row],
    places: dict[int, str],
    sides: tuple[str, ...],
    scene: Scene,
    span: Span,
) -> g.Goal:
    """Those ways to lay a line that have these blocks at these places; refused where there is none."""
    found: list[s.Stack | s.Row] = []
    for node in ways:
        for order in in_place(node.order, places, node.blocks, (sides[0], sides[1]), scene):
            along = {"axis": "y"} if isinstance(node, s.Row) and order.first in ("left", "right") else {}
            found.append(node.model_copy(update={"order": order, **along}))
    if not found or len(found) > MAX_ALTERNATIVES:
        hint = "keep one of them"
        raise refuse("order-conflict", "the order of these blocks is given already", span, hint)
    return either(found)
