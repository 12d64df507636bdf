"""Goals joined and denied."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from rpg.core.diagnostics import Span
from rpg.ir import goal as g

Atoms = list[g.Goal]


def conj(goals: Iterable[g.Goal], span: Span | None = None) -> g.Goal:
    """All of `goals`, flat; a single one as it is."""
    flat: list[g.Goal] = []
    for goal in goals:
        flat += goal.goals if isinstance(goal, g.All) else [goal]
    unique = list(dict.fromkeys(flat))
    return unique[0] if len(unique) == 1 else g.All(goals=tuple(unique), span=span)


def disj(goals: list[g.Goal], span: Span | None = None) -> g.Goal:
    """Any of `goals`; a single one as it is."""
    return goals[0] if len(goals) == 1 else g.Any(goals=tuple(goals), span=span)


def negate(goal: g.Goal, negated: bool, span: Span) -> g.Goal:
    return negation([goal], span)[0] if negated else goal


def negation(goals: Atoms, span: Span) -> Atoms:
    """None of `goals`: each is denied, those inside a conjunction or an alternative too."""
    flat = [x for goal in goals for x in _flat(goal)]
    return [x.goal if isinstance(x, g.Not) else g.Not(goal=x, span=span) for x in flat]


def _flat(goal: g.Goal) -> Iterator[g.Goal]:
    if isinstance(goal, g.All | g.Any):
        for part in goal.goals:
            yield from _flat(part)
    else:
        yield goal
