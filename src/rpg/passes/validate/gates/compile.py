"""Gate 2: both files run as modules and give one task class each."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from rpg.ir.artifact import GateReport, Program
from rpg.passes.validate.bench import Bench
from rpg.passes.validate.findings import failure, told
from rpg.passes.validate.gates.surface import nearest, public_names


@dataclass(frozen=True)
class CompileGate:
    """Compile and import; what is not our own lowering word for word is confined to a process of its own."""

    name: str = "compile"
    cost: int = 1

    def check(self, program: Program, bench: Bench) -> GateReport:
        """Load the classes."""
        try:
            task, goal = bench.classes
        except ImportError as error:
            wanted = str(error).split("'")[1] if "'" in str(error) else ""
            near = nearest(wanted, public_names())
            facts: dict[str, Any] = {"traceback": told(error, bench.sources), "name": wanted, "nearest": near}
            message = f"the code does not import: {error}"
            return GateReport.of(self.name, [failure(self.name, "code-import", "api", message, **facts)])
        except Exception as error:
            message = f"the code does not load: {type(error).__name__}: {error}"
            return GateReport.of(
                self.name,
                [failure(self.name, "code-load", "runtime", message, traceback=told(error, bench.sources))],
            )
        if not issubclass(goal, task):
            message = f"the goal-state class {goal.__name__} does not extend {task.__name__}"
            return GateReport.of(
                self.name, [failure(self.name, "code-shape", "api", message, file="goal_state_code.py")]
            )
        return GateReport.of(self.name, task=task.__name__, goal=goal.__name__)
