"""What holds at every start of a task, or at none, wherever its blocks happen to lie.

Starts are drawn in search of one from which the whole way is ahead. Where some stage holds at all of them, or always is
past already, there is no such start, and nothing to be drawn for.
"""

from __future__ import annotations

from rpg.ir import goal as g
from rpg.ir.node import Highest, Lowest
from rpg.ir.relations import Moved, On, OnPatch, OnTable, Stayed
from rpg.ir.schema import InitialState


def at_every_start(goal: g.Goal, init: InitialState) -> bool | None:
    """Does `goal` hold at every start (True), or at none (False)? None where that depends on the draw, or is not seen.

    Nothing is said of starts that are built or heaped. All others lie flat on the table; what has no pose of its own
    touches nothing, and no patch.
    """
    return None if init.arranged or init.heaps else _judged(goal, frozenset(start.block for start in init.poses))


def _judged(goal: g.Goal, placed: frozenset[str]) -> bool | None:
    match goal:
        case g.All():
            return _every([_judged(part, placed) for part in goal.goals])
        case g.Any():
            return _not(_every([_not(_judged(part, placed)) for part in goal.goals]))
        case g.Not():
            return _not(_judged(goal.goal, placed))
        case Stayed() | OnTable():
            return True
        case Moved():
            return False
        case On() | OnPatch():
            loose = not isinstance(goal.a, Lowest | Highest) and placed.isdisjoint(goal.a)
            return False if loose and goal.a else None
        case _:
            return None


def _every(parts: list[bool | None]) -> bool | None:
    if False in parts:
        return False
    return None if None in parts else True


def _not(value: bool | None) -> bool | None:
    return None if value is None else not value
