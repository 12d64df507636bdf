"""The body of `_success`: every condition a named boolean, then their combination."""

from __future__ import annotations

from dataclasses import dataclass, field

from rpg.ir import goal as g
from rpg.ir.walk import children, transform, without_span
from rpg.passes.codegen.calls import inline, marks
from rpg.passes.codegen.layout import Expr, Group, Infix, Labelled
from rpg.passes.codegen.naming import boolean_name, unique

NONE: frozenset[str] = frozenset()


@dataclass
class Success:
    """Named conditions in the order of the goal; `check` is the combination that a settled task must meet."""

    goal: g.Goal
    bindings: dict[str, Expr] = field(default_factory=dict)
    sources: dict[str, g.Goal] = field(default_factory=dict)
    _known: dict[g.Goal, str] = field(default_factory=dict)

    @property
    def check(self) -> Expr:
        """The expression over the named booleans; binds what it needs."""
        parts = [self._expr(part) for part in _conjuncts(self.goal)]
        return parts[0] if len(parts) == 1 else Infix("&", tuple(parts))

    def _expr(self, goal: g.Goal) -> Expr:
        match goal:
            case g.All() | g.Any() if goal.goals:
                parts = tuple(self._expr(part) for part in goal.goals)
                return parts[0] if len(parts) == 1 else Infix("&" if isinstance(goal, g.All) else "|", parts)
            case g.Not():
                return Labelled("~", self._expr(goal.goal))
            case g.Always():
                return self._bind(goal, Group("self.always", (self._expr(goal.goal),)))
            case g.Sequence():
                stages = tuple(self._stage(stage.goal) for stage in goal.stages)
                return self._bind(goal, Group("self.in_order", (*stages, *marks(goal))))
            case _:
                return self._bind(goal, inline(goal, NONE))

    def _stage(self, goal: g.Goal) -> Expr:
        expr = self._expr(goal)
        return expr if isinstance(expr, str) else self._bind(goal, expr)

    def _bind(self, goal: g.Goal, expr: Expr) -> str:
        key = transform(goal, without_span)
        if key not in self._known:
            name = unique(boolean_name(goal), self.bindings)
            self._known[key] = name
            self.bindings[name] = expr
            self.sources[name] = goal
        return self._known[key]


def _conjuncts(goal: g.Goal) -> list[g.Goal]:
    """The parts of a conjunction, nested ones opened up."""
    if isinstance(goal, g.All):
        return [part for inner in goal.goals for part in _conjuncts(inner)]
    return [goal]


def looks_over_time(goal: g.Goal) -> tuple[bool, bool]:
    """Whether a goal has a sequence, and whether it has a standing condition."""
    inner = [looks_over_time(child) for child in children(goal)]
    sequence = isinstance(goal, g.Sequence) or any(found for found, _ in inner)
    return sequence, isinstance(goal, g.Always) or any(found for _, found in inner)
