"""Blocks that a row leaves out: "all but one of the six white blocks in a row" is no row of six."""

from __future__ import annotations

from rpg.ir import goal as g
from rpg.ir import structures as s
from rpg.passes.schema.resolve.goals.conflicts import required
from rpg.passes.schema.resolve.goals.logic import conj
from rpg.passes.schema.resolve.things.world import Scene


def none_left_out_in_line(goal: g.Goal, scene: Scene) -> g.Goal:
    """`goal`, in which none of those that were told as left out of a row goes on with it."""
    rows = [x for x in required(goal) if isinstance(x, s.Row)] if scene.all_but else []
    longer = [
        s.Row(blocks=(*row.blocks, other), axis=row.axis)
        for row in rows
        for whole in scene.all_but
        for other in whole
        if other not in row.blocks and {*row.blocks} < {*whole}
    ]
    return conj([goal, *(g.Not(goal=row) for row in longer)]) if longer else goal
