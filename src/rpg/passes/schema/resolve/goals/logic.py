"""Goals joined and denied."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from itertools import product

from rpg.core.diagnostics import Span
from rpg.ir import goal as g
from rpg.ir import relations as r

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


def denied(goal: g.Goal, span: Span | None = None) -> g.Goal:
    """That a goal does not hold; what is denied twice does."""
    return goal.goal if isinstance(goal, g.Not) else g.Not(goal=goal, span=span)


_OF_EACH = (
    r.OnPatch | r.OnTable | r.InRegion | r.LeftOf | r.RightOf | r.InFrontOf | r.Behind | r.Stayed | r.Moved | r.Shifted
)
"""Relations that hold of several blocks where they hold of each."""


def negate(goal: g.Goal, negated: bool, span: Span) -> g.Goal:
    return conj(negation([goal], span), span) if negated else goal


def negation(goals: Atoms, span: Span) -> Atoms:
    """None of `goals`: each is denied of each block, those inside a conjunction or an alternative too. A structure that
    is "not there" is there with none of its blocks: it could be there in part."""
    flat = [y for goal in goals for x in _flat(goal) for y in _of_each(x)]
    return [x.goal if isinstance(x, g.Not) else g.Not(goal=x, span=span) for x in flat]


def _of_each(goal: g.Goal) -> list[g.Goal]:
    """ "Red and blue are not on the mat": neither of them is."""
    if not isinstance(goal, _OF_EACH):
        return [goal]
    sides = {key: _apart(value) for key in ("a", "b") if (value := getattr(goal, key, None)) is not None}
    return [goal.model_copy(update=dict(zip(sides, each, strict=True))) for each in product(*sides.values())]


def _apart(operand: object) -> list[object]:
    several = isinstance(operand, tuple) and len(operand) > 1
    return [(name,) for name in operand] if several and isinstance(operand, tuple) else [operand]


def _flat(goal: g.Goal) -> Iterator[g.Goal]:
    if isinstance(goal, g.All | g.Any):
        for part in goal.goals:
            yield from _flat(part)
    else:
        yield goal


def forbids(goal: g.Goal) -> bool:
    """ "no two may touch", "at most one may be on the patch": what limits the end, so that "may" is no mere leave."""
    if isinstance(goal, g.All | g.Any):
        return all(forbids(x) for x in goal.goals)
    if isinstance(goal, g.Count):  # "at least one but at most two may be there"
        return goal.at_least == 0 or (goal.at_most is not None and goal.at_least < goal.at_most)
    return isinstance(goal, g.Not | r.Clear | r.Empty)
