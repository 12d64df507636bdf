""" "Red is on blue, which is on the mat, and not on the mat itself": it does not lie on it directly."""

from __future__ import annotations

from collections.abc import Iterable

from rpg.ir import goal as g
from rpg.ir import relations as r
from rpg.ir.node import members
from rpg.ir.walk import transform


def not_directly(goal: g.Goal) -> g.Goal:
    """The goal without what is denied of the patch of a block that has to lie on another one which is there.

    What lies on a block that is on a patch is on it as well, so that the patch itself can only be meant, on which it
    does not lie then.
    """

    def change(node: g.Goal) -> g.Goal:
        if not isinstance(node, g.All):
            return node
        below = dict(_resting(node.goals))
        there = {(name, x.patch) for x in node.goals if isinstance(x, r.OnPatch) for name in members(x.a)}
        kept = tuple(x for x in node.goals if not _said_of_one_above(x, below, there))
        return node if kept == node.goals or not kept else node.model_copy(update={"goals": kept})

    return transform(goal, change)


def _resting(goals: Iterable[g.Goal]) -> Iterable[tuple[str, str]]:
    """What lies on what, block by block."""
    for goal in goals:
        if isinstance(goal, r.On) and len(members(goal.a)) == len(members(goal.b)) == 1:
            yield members(goal.a)[0], members(goal.b)[0]
        elif isinstance(goal, g.All):
            yield from _resting(goal.goals)


def _said_of_one_above(goal: g.Goal, below: dict[str, str], there: set[tuple[str, str]]) -> bool:
    """Whether a block is denied to be on a patch on which a block below it has to be."""
    if not isinstance(goal, g.Not) or not isinstance(goal.goal, r.OnPatch):
        return False
    names = members(goal.goal.a)
    return all(any((under, goal.goal.patch) in there for under in _under(name, below)) for name in names)


def _under(name: str, below: dict[str, str]) -> Iterable[str]:
    """The blocks below a block, from the next one down."""
    seen = {name}
    while name in below and below[name] not in seen:
        name = below[name]
        seen.add(name)
        yield name
