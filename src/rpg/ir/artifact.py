"""What crosses the passes after the schema: a program with its goal path, and what the gates found out about it."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any, Literal

from pydantic import Field

from rpg.core.diagnostics import Diagnostic
from rpg.ir.base import Record
from rpg.ir.schema import TaskSchema

FailureClass = Literal["syntax", "api", "runtime", "goal", "instability", "bounds", "constraint"]
"""What kind of failure a gate reports; the repair orchestrator routes by it."""
FAILURE_CLASSES: tuple[FailureClass, ...] = ("syntax", "api", "runtime", "constraint", "bounds", "instability", "goal")


class Placement(Record):
    """Where a block is placed: centre in metres (world frame), orientation as a unit quaternion (w, x, y, z)."""

    block: str
    position: tuple[float, float, float]
    orientation: tuple[float, float, float, float] = (1.0, 0.0, 0.0, 0.0)


Scene = tuple[Placement, ...]
"""A placement for every block of the task."""


class Program(Record):
    """A task as it is shipped: schema, the scenes that lead to its goal, and the two files of code.

    `path` ends in the goal scene. Goals that look back (relative to the start, or in stages) have earlier scenes: the
    start of the episode, then one for each stage.
    """

    task: TaskSchema
    path: tuple[Scene, ...]
    code: str
    goal_code: str


class GateReport(Record):
    """What a gate measured. `figures` are there on success too; failures are diagnostics of severity "error".

    A failure's `facts` hold `class` (a FailureClass) and, where known, `poses`, `subgoals_passed`,
    `subgoals_failed` and `traceback`.
    """

    name: str
    passed: bool
    figures: dict[str, Any] = Field(default_factory=dict)
    diagnostics: tuple[Diagnostic, ...] = ()

    @classmethod
    def of(cls, name: str, diagnostics: Iterable[Diagnostic] = (), **figures: Any) -> GateReport:
        """The report of a gate that is passed unless one of `diagnostics` is an error."""
        found = tuple(diagnostics)
        return cls(name=name, passed=all(d.severity != "error" for d in found), figures=figures, diagnostics=found)

    @property
    def failures(self) -> tuple[Diagnostic, ...]:
        """The findings that made the gate fail."""
        return tuple(d for d in self.diagnostics if d.severity == "error")


def failure_class(diagnostic: Diagnostic) -> FailureClass:
    """The class of a gate's failure ("runtime" where a diagnostic names none)."""
    found = diagnostic.facts.get("class")
    return found if found in FAILURE_CLASSES else "runtime"
