"""Stages of a sequence that are met on the way to the one in front of them, whatever is done."""

from __future__ import annotations

from itertools import pairwise

from rpg.ir import goal as g
from rpg.ir.relations import On, OnTable
from rpg.ir.structures import Stack
from rpg.ir.walk import conjuncts


def passed(sequence: g.Sequence) -> tuple[int, ...]:
    """The indices of stages that may be met before the one in front of them, for that cannot be met otherwise.

    "Build a tower of A, B and C; then put C back on the table", with A and B a tower still: so they were before C was
    put on them.
    """
    pairs = pairwise(sequence.stages)
    return tuple(k for k, (one, after) in enumerate(pairs, 1) if one.undone and _on_the_way(after.goal, one.goal))


def _on_the_way(goal: g.Goal, to: g.Goal) -> bool:
    """Whether a goal is a part of another one with what is not built yet on the table."""
    built = [part for part in conjuncts(goal) if not isinstance(part, OnTable)]
    return bool(built) and all(any(_part(one, of) for of in conjuncts(to)) for one in built)


def _part(one: g.Goal, of: g.Goal) -> bool:
    """Whether one block on another is asked for by both, or one is a stack of the lowest blocks of the other."""
    if isinstance(one, On) and isinstance(of, On):
        return (one.a, one.b) == (of.a, of.b)
    if not isinstance(one, Stack) or not isinstance(of, Stack) or {one.order.by, of.order.by} != {"given"}:
        return False
    lower, whole = _upwards(one), _upwards(of)
    return len(lower) < len(whole) and whole[: len(lower)] == lower


def _upwards(stack: Stack) -> tuple[tuple[str, ...], ...]:
    ranks = tuple(map(tuple, stack.order.ranks))
    return ranks[::-1] if stack.order.first == "top" else ranks
