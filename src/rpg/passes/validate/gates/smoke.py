"""Gate 3: the task can be made, reset and stepped, and what it holds is what the schema asks for."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import mujoco

from rpg.blocks.state import BlockState
from rpg.core.diagnostics import Diagnostic, Refusal
from rpg.env import BlockTask
from rpg.ir.artifact import GateReport, Program
from rpg.passes.validate.bench import Bench
from rpg.passes.validate.findings import failure, place_of, refused, told
from rpg.passes.validate.prints import print_of

DIVERGES = "positions are no finite numbers, at the start or a few steps later"
BAD_NUMBERS = tuple(
    int(kind)
    for kind in (mujoco.mjtWarning.mjWARN_BADQPOS, mujoco.mjtWarning.mjWARN_BADQVEL, mujoco.mjtWarning.mjWARN_BADQACC)
)


@dataclass(frozen=True)
class SmokeGate:
    """Instantiate, reset, zero-action steps."""

    name: str = "smoke"
    cost: int = 2

    def check(self, program: Program, bench: Bench) -> GateReport:
        """Run the task for a moment with the robot holding still."""
        try:
            found, figures = self._run(bench)
        except Refusal as refusal:
            found, figures = [refused(self.name, d) for d in refusal.diagnostics], {}
        except Exception as error:
            place = place_of(error, bench.sources)
            where = f" in {place[0]}, line {place[1]}" if place else ""
            message = f"the task does not run: {type(error).__name__}{where}: {error}"
            facts: dict[str, Any] = {
                "traceback": told(error, bench.sources),
                "file": place and place[0],
                "line": place and place[1],
            }
            found, figures = [failure(self.name, "task-crashes", "runtime", message, **facts)], {}
        return GateReport.of(self.name, found, **figures)

    def _run(self, bench: Bench) -> tuple[list[Diagnostic], dict[str, Any]]:
        task = bench.task
        found = self._assets(bench, task)
        try:
            start = task.reset(0)
        except Refusal as refusal:
            if any(d.code != "start-solves-goal" for d in refusal.diagnostics):
                raise
            # the gate of starts says more about this one; here the goal state shows whether the task runs
            task = bench.goal
            start = task.reset(0)
        if not _finite(start):
            return [*found, failure(self.name, "physics-diverges", "instability", DIVERGES)], {}
        bench.prints["reset 0"] = print_of(task)
        task.step(bench.measures.smoke_steps)
        state = task.state()
        if bench.judge is None:
            task.solved()
        bench.prints["steps"] = print_of(task)
        if not _finite(state) or any(task.data.warning[kind].number for kind in BAD_NUMBERS):
            return [*found, failure(self.name, "physics-diverges", "instability", DIVERGES)], {}
        moved = max((math.dist(start.position[n], state.position[n]) for n in state.position), default=0.0)
        return found, {
            "blocks": len(state.position),
            "control_steps": bench.measures.smoke_steps,
            "moved_mm": round(moved * 1000, 1),
        }

    def _assets(self, bench: Bench, task: BlockTask) -> list[Diagnostic]:
        """The objects in the code against those in the schema."""
        wanted, made = bench.world.assets, task.world.assets
        if wanted == made:
            return []
        names = sorted(n for n in {*wanted, *made} if wanted.get(n) != made.get(n))
        message = f"the code and task.yaml differ in their objects: {', '.join(names) or 'their order'}"
        return [failure(self.name, "assets-differ", "api", message, names=names)]


def _finite(state: BlockState) -> bool:
    return all(math.isfinite(value) for place in state.position.values() for value in place)
