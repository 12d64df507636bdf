"""An order that nobody told: "three blocks in one tower, red, white, blue; red is not at the bottom" lists what there
is."""

from __future__ import annotations

from rpg.ir import goal as g
from rpg.ir import structures as s
from rpg.ir.order import Order
from rpg.ir.walk import transform
from rpg.passes.schema.resolve.goals.conflicts import required
from rpg.passes.schema.resolve.things.world import Scene

_ASSUMED = ("the order is read from", "in the order in which the blocks are")


def order_left_free(goal: g.Goal, scene: Scene) -> g.Goal:
    """`goal` with a line in any order where its order was only read from a list, and a place in it is denied as well:
    of a line in one order that would be either needless or impossible."""
    assumed = [note for note in scene.assumptions if note.startswith(_ASSUMED)]
    parts = [*required(goal)] if assumed else []
    denied = [x.goal for x in parts if isinstance(x, g.Not) and isinstance(x.goal, s.Row | s.Stack)]
    free = [x for x in parts if isinstance(x, s.Row | s.Stack) and _listed(x) and any(_same(x, y) for y in denied)]
    if len(free) != 1:
        return goal
    for note in assumed:
        del scene.assumptions[note]
    line = free[0].model_copy(update={"order": Order(), "readable": False})
    return transform(goal, lambda part: line if part == free[0] else part)


def _listed(line: s.Row | s.Stack) -> bool:
    return line.order.by == "given" and [len(rank) for rank in line.order.ranks] == [1] * len(line.blocks)


def _same(line: s.Row | s.Stack, other: s.Row | s.Stack) -> bool:
    placed = other.order.by == "given" and any(len(rank) > 1 for rank in other.order.ranks)
    return line.kind == other.kind and {*line.blocks} == {*other.blocks} and placed
