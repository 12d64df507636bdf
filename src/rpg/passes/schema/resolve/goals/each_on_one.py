"""Blocks that are on one patch or another, of which it is counted how many are on each: "all six lie on the red or the
blue patch, at least two of them on each"."""

from __future__ import annotations

from collections.abc import Iterable

from rpg.ir import goal as g
from rpg.ir import relations as r
from rpg.ir.walk import transform, within


def each_on_one(goal: g.Goal) -> g.Goal:
    """Each of them is on one or the other, where all together on one would leave nothing to be counted."""

    def change(node: g.Goal) -> g.Goal:
        if not isinstance(node, g.All):
            return node
        counted = [x for part in node.goals for x in within(part) if isinstance(x, g.Count)]
        goals = [x for part in node.goals for x in _apart(part, counted)]
        return node if tuple(goals) == node.goals else node.model_copy(update={"goals": tuple(goals)})

    return transform(goal, change)


def _apart(part: g.Goal, counted: Iterable[g.Count]) -> Iterable[g.Goal]:
    """The choice between patches, of each of the blocks if some of them are counted on one of these."""
    on = [x for x in part.goals if isinstance(x, r.OnPatch)] if isinstance(part, g.Any) else []
    lots = {x.a for x in on}
    lot = next(iter(lots)) if len(lots) == 1 else ()
    if not isinstance(part, g.Any) or len(on) < len(part.goals) or not isinstance(lot, tuple) or len(lot) < 2:
        return [part]
    patches = {x.patch for x in on}
    if not any(isinstance(x.goal, r.OnPatch) and x.goal.patch in patches and {*x.over} <= {*lot} for x in counted):
        return [part]
    one_by_one = [[x.model_copy(update={"a": (name,)}) for x in on] for name in lot]
    return [part.model_copy(update={"goals": tuple(each)}) for each in one_by_one]
