"""Blocks that a row or a pile leaves out: "all but one of the six white blocks in a row" is no row of six."""

from __future__ import annotations

from rpg.ir import goal as g
from rpg.ir import structures as s
from rpg.passes.schema.resolve.goals.conflicts import required
from rpg.passes.schema.resolve.goals.logic import conj
from rpg.passes.schema.resolve.things.world import Scene


def none_left_out_in_line(goal: g.Goal, scene: Scene) -> g.Goal:
    """`goal`, in which none of those that were told as left out goes on with a row, or is in the pile of the others."""
    if not scene.all_but and not scene.excepted:
        return goal
    more: list[g.Goal] = []
    for made in required(goal):
        if isinstance(made, s.Row):
            blocks = {*made.blocks}
            longer = [s.Row(blocks=(*made.blocks, n), axis=made.axis) for n in _left_out(blocks, scene)]
            more += [g.Not(goal=row) for row in longer]
        elif isinstance(made, s.GroupBy) and len(made.groups) == 1:
            (group,) = made.groups
            larger = [s.GroupBy(groups=((*group, n),)) for n in scene.excepted if n not in group]
            more += [g.Not(goal=pile) for pile in larger]
    return conj([goal, *more]) if more else goal


def _left_out(blocks: set[str], scene: Scene) -> list[str]:
    """The blocks that a row of these leaves out."""
    others = [n for whole in scene.all_but if blocks < {*whole} for n in whole]
    return [n for n in dict.fromkeys((*others, *sorted(scene.excepted))) if n not in blocks]
