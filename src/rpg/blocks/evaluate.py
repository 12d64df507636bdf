"""Evaluation of goals: a fold over the expression, and the memory that sequences and `always` need over an episode."""

from __future__ import annotations

import math

import numpy as np

from rpg.blocks.centres import Centres, Mask
from rpg.blocks.constants import SUPPORT_GAP, TABLE_Z
from rpg.blocks.geometry import body_gap, is_level, rests_on, supporters, table_gap
from rpg.blocks.predicates import PREDICATES
from rpg.blocks.state import BlockState
from rpg.blocks.verdict import FALSE, Verdict, at_most, between, every, some
from rpg.ir import goal as g
from rpg.ir.walk import instances


def evaluate(goal: g.Goal, state: BlockState) -> Verdict:
    """Truth and margin of `goal` on a single state, with its names as they stand.

    A sequence holds when all of its stages do, but for those that a later one undoes; `always` when its goal does.
    """
    predicate = PREDICATES.get(goal.kind)
    if predicate is not None:
        return predicate.evaluate(goal, state)
    match goal:
        case g.All():
            return every([evaluate(part, state) for part in goal.goals])
        case g.Any():
            return some([evaluate(part, state) for part in goal.goals])
        case g.Not() | g.Always():
            inner = evaluate(goal.goal, state)
            return ~inner if isinstance(goal, g.Not) else inner
        case g.Count():
            return between(goal.at_least, goal.at_most, [evaluate(i, state) for i in instances(goal)])
        case g.Sequence():
            return every([evaluate(stage.goal, state) for stage in goal.stages if not stage.undone])
    raise TypeError(f"no predicate is registered for {goal.kind!r}")


def satisfied(goal: g.Goal, state: BlockState) -> bool:
    """The truth of `goal` alone: as `evaluate`, but it stops at the first part that decides."""
    predicate = PREDICATES.get(goal.kind)
    if predicate is not None:
        return predicate.holds(goal, state)
    match goal:
        case g.All():
            return all(satisfied(part, state) for part in goal.goals)
        case g.Any():
            return any(satisfied(part, state) for part in goal.goals)
        case g.Not():
            return not satisfied(goal.goal, state)
        case g.Always():
            return satisfied(goal.goal, state)
        case g.Sequence():
            return all(satisfied(stage.goal, state) for stage in goal.stages if not stage.undone)
        case _:
            return evaluate(goal, state).value


def perhaps(goal: g.Goal, many: Centres) -> Mask:
    """The states in which `goal` may be `satisfied`, as far as the centres of blocks tell."""
    predicate = PREDICATES.get(goal.kind)
    if predicate is not None:
        return predicate.perhaps(goal, many)
    found = many.all()
    match goal:
        case g.All():
            for part in goal.goals:
                found &= perhaps(part, many)
        case g.Any():
            found = many.none()
            for part in goal.goals:
                found |= perhaps(part, many)
        case g.Always():
            return perhaps(goal.goal, many)
        case g.Count() if goal.at_least > 0:
            enough: Mask = np.sum([perhaps(part, many) for part in instances(goal)], axis=0) >= goal.at_least
            return enough
        case g.Sequence():
            for stage in goal.stages:
                if not stage.undone:
                    found &= perhaps(stage.goal, many)
    return found


def settled(state: BlockState) -> Verdict:
    """Every block is at rest, released, and supported: nothing floats."""
    if state.moving or state.held:
        return FALSE
    return every([_supported(name, state) for name in state.position])


def rests(state: BlockState) -> bool:
    """The truth of `settled` alone: it stops at the first block that floats."""
    if state.moving or state.held:
        return False
    return all(_carried(name, state) or _supported(name, state).value for name in state.position)


def _carried(name: str, state: BlockState) -> bool:
    """Is a block on the table or plainly on another one?"""
    bottom = state.bottom(name)
    if abs(bottom - TABLE_Z) <= SUPPORT_GAP:
        return True
    return any(abs(bottom - state.top(b)) <= SUPPORT_GAP and rests_on(state, name, b) for b in state.position)


def _supported(name: str, state: BlockState) -> Verdict:
    gap = abs(table_gap(state, name))
    if gap > SUPPORT_GAP:
        bottom = state.bottom(name)
        gap = min((abs(bottom - state.top(b)) for b in supporters(state, name)), default=gap)
        if gap > SUPPORT_GAP and not is_level(state, name):
            gap = min(gap, _leaning_gap(name, state))
    return at_most(gap, SUPPORT_GAP)


def _leaning_gap(name: str, state: BlockState) -> float:
    """Distance from a tilted block, as it lies in a heap, to the nearest block whose centre is lower."""
    height = state.position[name][2]
    lower = (other for other, place in state.position.items() if other != name and place[2] < height)
    return min((abs(body_gap(state, name, other)) for other in lower), default=math.inf)
