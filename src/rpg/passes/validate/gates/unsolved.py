"""Gate 7: sampled starts leave the goal to be reached, and are physically sane."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from rpg.blocks.physics import QUIET_SPEED
from rpg.blocks.state import BlockState
from rpg.core.diagnostics import Diagnostic, Refusal
from rpg.env import BlockTask
from rpg.ir.artifact import GateReport, Program
from rpg.passes.validate.bench import Bench
from rpg.passes.validate.findings import failure, poses, told
from rpg.passes.validate.gates.bounds import ROUNDING, room
from rpg.passes.validate.prints import print_of


@dataclass(frozen=True)
class UnsolvedGate:
    """G false at N sampled resets; no interpenetration, in bounds, at rest."""

    name: str = "unsolved"
    cost: int = 2

    def check(self, program: Program, bench: Bench) -> GateReport:
        """Reset with the first N seeds."""
        found: dict[str, Diagnostic] = {}
        figures: dict[str, Any] = {"resets": bench.measures.resets, "solved": 0, "overlap_mm": 0.0, "speed_mm_s": 0.0}
        task = bench.task
        for seed in range(bench.measures.resets):
            try:
                start = task.reset(seed)
                judged = task.judge()
                overlap, speed = deepest_overlap(task), task.physics.fastest()
            except Refusal as refusal:
                for d in refusal.diagnostics:
                    kind = "goal" if d.code == "start-solves-goal" else "bounds"
                    found.setdefault(d.code, d.model_copy(update={"facts": {"class": kind, **d.facts}}))
                break
            except Exception as error:
                message = f"reset with seed {seed} fails: {type(error).__name__}: {error}"
                trace = told(error, bench.sources)
                found["crash"] = failure(self.name, "task-crashes", "runtime", message, traceback=trace, seed=seed)
                break
            bench.prints[f"reset {seed}"] = print_of(task)
            figures["solved"] += bool(judged.success)
            figures["overlap_mm"] = max(figures["overlap_mm"], round(overlap * 1000, 3))
            figures["speed_mm_s"] = max(figures["speed_mm_s"], round(speed * 1000, 2))
            for problem in self._problems(bench, seed, start, judged.success.value, judged.failed, overlap, speed):
                found.setdefault(problem.code, problem)
        return GateReport.of(self.name, found.values(), **figures)

    def _problems(
        self, bench: Bench, seed: int, start: BlockState, solved: bool, lost: bool, overlap: float, speed: float
    ) -> list[Diagnostic]:
        facts: dict[str, Any] = {"seed": seed, "poses": poses(start)}
        found = []
        if solved:
            message = f"the goal holds already at the start of seed {seed}"
            found.append(failure(self.name, "reset-solved", "goal", message, **facts))
        if lost:
            message = f"the episode of seed {seed} is lost at its start"
            found.append(failure(self.name, "reset-lost", "goal", message, **facts))
        if overlap > bench.measures.overlap_m:
            message = f"blocks overlap by {overlap * 1000:.1f} mm at the start of seed {seed}"
            found.append(
                failure(self.name, "reset-overlap", "instability", message, overlap_m=round(overlap, 5), **facts)
            )
        outside = [name for name in start.position if room(start, name) < -ROUNDING]
        if outside:
            message = f"{', '.join(outside)} starts outside of the workspace with seed {seed}"
            found.append(failure(self.name, "reset-out-of-bounds", "bounds", message, blocks=outside, **facts))
        if speed > 10 * QUIET_SPEED:
            message = f"blocks move at {speed * 1000:.0f} mm/s at the start of seed {seed}"
            found.append(failure(self.name, "reset-moves", "instability", message, speed_m_s=round(speed, 4), **facts))
        return found


def deepest_overlap(task: BlockTask) -> float:
    """How deep (m) any two bodies are inside each other."""
    contacts = task.data.contact
    if not task.data.ncon:
        return 0.0
    return max(0.0, -float(contacts.dist[: task.data.ncon].min()))
