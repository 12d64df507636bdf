"""What holds at every start of a task, or at none, wherever its blocks happen to lie.

Starts are drawn in search of one from which the whole way is ahead. Where some stage holds at all of them, or always is
past already, there is no such start, and nothing to be drawn for.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import NamedTuple

from rpg.ir import goal as g
from rpg.ir.node import members
from rpg.ir.relations import Above, Empty, Moved, On, OnPatch, OnTable, Ranged, Shifted, Stayed
from rpg.ir.schema import InitialState
from rpg.ir.walk import names, plain


class _Outset(NamedTuple):
    """What is known of every start: blocks that are built into something or have poses, and what is built."""

    placed: frozenset[str]
    built: frozenset[str]
    holding: tuple[g.Goal, ...]


def at_every_start(goal: g.Goal, init: InitialState) -> bool | None:
    """Does `goal` hold at every start (True), or at none (False)? None where that depends on the draw, or is not seen.

    Nothing is said of starts with heaps. In all others, what is built holds, and blocks that are not built into it lie
    flat on the table; what has no pose of its own either touches nothing, and no patch.
    """
    if init.heaps:
        return None
    holding = tuple(_conjuncts(map(plain, init.arranged)))
    built = frozenset(name for part in holding for name in names(part))
    outset = _Outset(built.union(start.block for start in init.poses), built, holding)
    return _judged(plain(goal) if holding else goal, outset)


def _judged(goal: g.Goal, outset: _Outset) -> bool | None:
    if goal in outset.holding:
        return True
    match goal:
        case g.All():
            return _every([_judged(part, outset) for part in goal.goals])
        case g.Any():
            return _not(_every([_not(_judged(part, outset)) for part in goal.goals]))
        case g.Not():
            return _not(_judged(goal.goal, outset))
        case Stayed():
            return True
        case Moved() | Shifted() | Ranged():
            return False
        case OnTable():
            return True if outset.built.isdisjoint(members(goal.a)) else None
        case OnPatch() if any(_covers(part, goal) for part in outset.holding):
            return True
        case On() | Above() | OnPatch():
            loose = isinstance(goal.a, tuple) and outset.placed.isdisjoint(goal.a)
            return False if loose and goal.a else None
        case Empty():
            taken = any(isinstance(part, OnPatch) and part.patch == goal.patch for part in outset.holding)
            return False if taken else None
        case _:
            return None


def _covers(told: g.Goal, goal: OnPatch) -> bool:
    """Does what is told put all of these blocks on that patch?"""
    if not isinstance(told, OnPatch) or not isinstance(told.a, tuple):
        return False
    return told.patch == goal.patch and {*members(goal.a)} <= {*told.a}


def _conjuncts(goals: Iterable[g.Goal]) -> Iterable[g.Goal]:
    for goal in goals:
        yield from goal.goals if isinstance(goal, g.All) else (goal,)


def _every(parts: list[bool | None]) -> bool | None:
    if False in parts:
        return False
    return None if None in parts else True


def _not(value: bool | None) -> bool | None:
    return None if value is None else not value
