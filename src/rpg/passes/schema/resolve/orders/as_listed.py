""" "Start with a tower of red, blue and green. End with one of green, blue and red.": told in the order of names."""

from __future__ import annotations

from rpg.ir import goal as g
from rpg.ir import structures as s
from rpg.ir.order import Order
from rpg.passes.schema.resolve.orders.reordered import LAST
from rpg.passes.schema.resolve.things.world import Scene


def both_as_listed(goal: g.Goal, scene: Scene) -> g.Goal:
    """The goal; where it is the same line of the same blocks as at the start, but for the order in which they are
    named, both have that order."""
    if isinstance(goal, g.All) and len(goal.goals) == 1:
        return both_as_listed(goal.goals[0], scene)
    line = goal if isinstance(goal, s.Row | s.Stack) and goal.order.by == "any" else None
    for n, start in enumerate(scene.start_goals):
        if line is None or not isinstance(start, s.Row | s.Stack) or not _same_but_for_names(line, start):
            continue
        if _looks(line, scene) == _looks(start, scene) or len({*_looks(line, scene)}) < len(line.blocks):
            continue
        scene.start_goals[n] = _in_order(start)
        found = _in_order(line)
        first = found.order.first or ""
        scene.assume(f"at the start and at the end in the order in which the blocks are named, from {first} to "
                     f"{LAST[first]}")  # fmt: skip
        return found
    return goal


def _same_but_for_names(line: s.Row | s.Stack, start: s.Row | s.Stack) -> bool:
    told = {"span", "blocks", "exact"}
    return {*line.blocks} == {*start.blocks} and line.model_dump(exclude=told) == start.model_dump(exclude=told)


def _looks(line: s.Row | s.Stack, scene: Scene) -> list[tuple[str | None, ...]]:
    return [(scene.things[name].color, scene.things[name].label, scene.things[name].size) for name in line.blocks]


def _in_order(line: s.Row | s.Stack) -> s.Row | s.Stack:
    first = "bottom" if isinstance(line, s.Stack) else "front" if line.axis == "x" else "left"
    order = Order(by="given", ranks=tuple((name,) for name in line.blocks), first=first)  # type: ignore[arg-type]
    fixed = {"order": order} if isinstance(line, s.Stack) else {"order": order, "axis": line.axis or "y"}
    return line.model_copy(update=fixed)
