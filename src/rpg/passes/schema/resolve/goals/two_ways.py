"""Blocks that are moved along both axes: "10 cm forward and then 10 cm to the left"."""

from __future__ import annotations

from rpg.ir import goal as g
from rpg.ir.node import members
from rpg.ir.relations import Shifted
from rpg.ir.walk import transform
from rpg.passes.schema.resolve.goals.conflicts import required

ALONG_X = frozenset({"front", "back"})
FREE = 0.6
"""As far as nothing goes on the table (m): it is not said how far to that side."""


def across(one: Shifted, other: g.Goal) -> bool:
    """Whether the other one moves a block of the first along the other axis."""
    if not isinstance(other, Shifted) or not {*members(one.a)} & {*members(other.a)}:
        return False
    return (one.toward in ALONG_X) != (other.toward in ALONG_X)


def two_ways(goal: g.Goal) -> g.Goal:
    """`goal`, where what is moved along both axes is as far off the one as it goes along the other."""
    shifts = [atom for atom in required(goal) if isinstance(atom, Shifted)]

    def widened(node: g.Goal) -> g.Goal:
        others = [x for x in shifts if across(node, x)] if isinstance(node, Shifted) else []
        if not others or not isinstance(node, Shifted):
            return node
        off = max(FREE if x.at_most is None else x.at_most for x in others)
        return node.model_copy(update={"across": round(off + (node.across or 0.0), 6)})

    return transform(goal, widened)
