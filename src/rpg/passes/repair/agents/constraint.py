"""ConstraintFixAgent: supports that go round in a circle, hang in the air, or are asked for twice."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from random import Random

from rpg.core.diagnostics import Diagnostic, Refusal
from rpg.ir import goal as g
from rpg.ir.artifact import FailureClass
from rpg.ir.order import Order
from rpg.ir.relations import Above, On
from rpg.ir.structures import Stack
from rpg.passes.repair.guard import bare, conditions
from rpg.passes.repair.record import Case, Proposal, Tools, relowered


@dataclass(frozen=True)
class ConstraintFixAgent:
    """Turns a support round, reverses a chain, drops what is said twice.

    What it proposes is checked against the conditions of the instruction like any repair: a circle that was really
    asked for stays refused.
    """

    name: str = "ConstraintFixAgent"
    handles: FailureClass = "constraint"

    def propose(self, case: Case, failures: tuple[Diagnostic, ...], tools: Tools) -> Iterator[Proposal]:
        """One change of the goal at a time."""
        task = case.program.task
        for strategy, goal in _changes(task.goal, case.asked):
            changed = task.model_copy(update={"goal": goal})
            try:
                path = tools.arrange(changed, Random(f"repair {strategy}"))
            except Refusal:
                continue
            yield Proposal(strategy, relowered(case.program, tools, task=changed, path=path))


def _changes(goal: g.Goal, asked: g.Goal) -> Iterator[tuple[str, g.Goal]]:
    parts = list(conditions(goal))
    wanted = {bare(part).model_dump_json() for part in conditions(asked)}
    foreign = [part for part in parts if bare(part).model_dump_json() not in wanted]
    for index, part in enumerate(parts):
        if part in foreign:
            for strategy, turned in _turned(part):
                yield strategy, _joined([*parts[:index], turned, *parts[index + 1 :]])
    for index, part in enumerate(parts):
        if len(parts) > 1 and (part in foreign or isinstance(part, Above) or part in parts[:index]):
            yield f"drop the redundant {part.kind}", _joined([*parts[:index], *parts[index + 1 :]])


def _turned(part: g.Goal) -> Iterator[tuple[str, g.Goal]]:
    """The same supports the other way round."""
    if isinstance(part, On | Above):
        yield "turn a support round", part.model_copy(update={"a": part.b, "b": part.a})
    elif isinstance(part, Stack) and part.order.by == "given":
        ranks: Order = part.order.model_copy(update={"ranks": tuple(reversed(part.order.ranks))})
        yield "reverse a support chain", part.model_copy(update={"order": ranks})


def _joined(parts: list[g.Goal]) -> g.Goal:
    return parts[0] if len(parts) == 1 else g.All(goals=tuple(parts))
