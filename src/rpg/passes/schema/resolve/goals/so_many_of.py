"""Of several goals so many hold: "no mat is empty", "exactly one of the mats is empty"."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import combinations

from rpg.core.diagnostics import Span
from rpg.ir import goal as g
from rpg.passes.schema.resolve.goals.logic import conj, denied, disj
from rpg.passes.schema.resolve.things.world import Ref, refuse

_FEW = 6
"""Of more goals than these it is not told apart which hold."""


def so_many_of(goals: Sequence[g.Goal], whole: Ref, span: Span) -> g.Goal:
    """The goals of the things that `whole` names, of which it says how many there are."""
    many = whole.quant
    if whole.op not in ("and", "or") or whole.mixed or len(goals) > _FEW:
        raise refuse("misplaced", "it is not clear of which of them this is said", span, "say it of each of them")
    if whole.op == "or":
        return disj(list(goals), span)
    if many is None or many.low == len(goals):
        return conj(goals, span)
    most = len(goals) if many.high is None else min(many.high, len(goals))
    ways = []
    for count in range(many.low, most + 1):
        for chosen in combinations(range(len(goals)), count):
            one = [goal if n in chosen else denied(goal, span) for n, goal in enumerate(goals)]
            ways.append(conj(one, span))
    return disj(ways, span)
