"""Orders that are denied of a tower as though it were a row: "stack A, B and C. They are not in alphabetical order"."""

from __future__ import annotations

from rpg.ir import goal as g
from rpg.ir import structures as s
from rpg.passes.schema.resolve.goals.conflicts import required
from rpg.passes.schema.resolve.things.world import refuse


def none_of_a_tower(goal: g.Goal) -> g.Goal:
    """`goal`, unless it denies an order of blocks that are stacked along a row, where they are not anyway."""
    parts = [*required(goal)]
    stacked = [{*part.blocks} for part in parts if isinstance(part, s.Stack)]
    for part in parts if stacked else ():
        row = part.goal if isinstance(part, g.Not) else None
        if isinstance(row, s.Row) and row.order.by != "any" and any({*row.blocks} <= blocks for blocks in stacked):
            raise refuse("ambiguous", "from the top or from the bottom of the tower?", row.span,
                         "say 'from bottom to top', or 'from top to bottom'")  # fmt: skip
    return goal
