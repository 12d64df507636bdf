"""The parts of a goal on a state: which hold, which do not, and where the instruction speaks of them."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

from rpg.blocks.alike import Renamed
from rpg.blocks.english import clause
from rpg.blocks.evaluate import satisfied
from rpg.blocks.namings import all_namings
from rpg.blocks.state import BlockState, World
from rpg.blocks.symmetry import interchangeable
from rpg.core.diagnostics import Span
from rpg.ir import goal as g
from rpg.ir.schema import TaskSchema
from rpg.ir.walk import names


@dataclass(frozen=True)
class Subgoals:
    """Conjuncts of the goal under the naming of look-alikes that comes closest."""

    parts: tuple[tuple[g.Goal, str, bool], ...]

    def facts(self) -> dict[str, Any]:
        """For a failure's facts."""
        return {
            "subgoals_passed": [text for _, text, holds in self.parts if holds],
            "subgoals_failed": [text for _, text, holds in self.parts if not holds],
        }

    @property
    def span(self) -> Span | None:
        """Where the instruction asks for the first part that does not hold."""
        return next((part.span for part, _, holds in self.parts if not holds and part.span), None)

    def span_about(self, block: str) -> Span | None:
        """Where the instruction speaks of `block`, first among the parts that do not hold."""
        ranked = sorted(self.parts, key=lambda part: part[2])
        return next((part.span for part, _, _ in ranked if part.span and block in names(part)), None)

    def broken_text(self) -> str:
        """The parts that do not hold, in words."""
        broken = [text for _, text, holds in self.parts if not holds]
        return "; ".join(f"not so: {text}" for text in broken) or "its parts hold, but not together"


def subgoals(task: TaskSchema, state: BlockState) -> Subgoals:
    """Judge every conjunct of the schema's goal on `state`."""
    world = World(task.assets)
    parts = tuple(conjuncts(task.goal))
    renamed = Renamed(parts, all_namings(interchangeable(task.goal, world)))
    values = [satisfied(goal, state) for goal in renamed.goals]
    best = max(renamed.namings, key=lambda numbers: sum(values[k] for k in numbers))
    return Subgoals(tuple((part, clause(part, world), values[k]) for part, k in zip(parts, best, strict=True)))


def conjuncts(goal: g.Goal) -> Iterator[g.Goal]:
    """The parts that all have to hold; the stages of a sequence count one by one."""
    match goal:
        case g.All():
            for part in goal.goals:
                yield from conjuncts(part)
        case g.Sequence():
            for stage in goal.stages:
                yield from () if stage.undone else conjuncts(stage.goal)
        case _:
            yield goal
