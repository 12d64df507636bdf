"""Gate 7: sampled starts leave the goal to be reached, and are physically sane."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

from rpg.blocks.evaluate import evaluate
from rpg.blocks.initial import sample_start
from rpg.blocks.physics import QUIET_SPEED
from rpg.blocks.state import BlockState
from rpg.blocks.symmetry import interchangeable, namings, rename_state
from rpg.blocks.waypoints import looks_back
from rpg.core.diagnostics import Diagnostic, Refusal
from rpg.env import BlockTask
from rpg.ir.artifact import GateReport, Program
from rpg.passes.validate.bench import Bench
from rpg.passes.validate.findings import failure, poses, refused, told
from rpg.passes.validate.gates.bounds import ROUNDING, room
from rpg.passes.validate.prints import print_of

MOVING = 10 * QUIET_SPEED
"""Speed (m/s) from which a start counts as moving."""


@dataclass
class _Starts:
    """What was measured over the sampled starts; findings by code, the first of each."""

    found: dict[str, Diagnostic] = field(default_factory=dict)
    resets: int = 0
    solved: int = 0
    overlap: float = 0.0
    speed: float = 0.0

    def report(self, gate: str) -> GateReport:
        """The figures in the units of the log."""
        return GateReport.of(
            gate,
            self.found.values(),
            resets=self.resets,
            solved=self.solved,
            overlap_mm=round(self.overlap * 1000, 2),
            speed_mm_s=round(self.speed * 1000, 1),
        )


@dataclass(frozen=True)
class UnsolvedGate:
    """G false at N sampled resets; no interpenetration, in bounds, at rest."""

    name: str = "unsolved"
    cost: int = 2

    def check(self, program: Program, bench: Bench) -> GateReport:
        """Reset with the first N seeds."""
        starts = _Starts()
        for seed in range(bench.measures.resets):
            starts.resets += 1
            try:
                self._look(starts, bench, seed)
            except Refusal as refusal:
                for diagnostic in refusal.diagnostics:
                    starts.found.setdefault(diagnostic.code, self._refused(program, bench, diagnostic))
                break
            except Exception as error:
                message = f"reset with seed {seed} fails: {type(error).__name__}: {error}"
                trace = told(error, bench.sources)
                crash = failure(self.name, "task-crashes", "runtime", message, traceback=trace, seed=seed)
                starts.found["crash"] = crash
                break
        return starts.report(self.name)

    def _look(self, starts: _Starts, bench: Bench, seed: int) -> None:
        task = bench.task
        start = task.reset(seed)
        solved, lost = task.solved(), bench.judge is None and task.judge().failed
        bench.prints[f"reset {seed}"] = print_of(task)
        overlap, speed = deepest_overlap(task), task.physics.fastest()
        task.step()
        speed = max(speed, task.physics.fastest())
        starts.solved += solved
        starts.overlap, starts.speed = max(starts.overlap, overlap), max(starts.speed, speed)
        found = []
        if solved:
            message = f"the goal holds already at the start of seed {seed}"
            found.append(failure(self.name, "reset-solved", "goal", message, seed=seed, poses=poses(start)))
        if lost:
            message = f"the episode of seed {seed} is lost at its start"
            found.append(failure(self.name, "reset-lost", "goal", message, seed=seed, poses=poses(start)))
        found += self._physical(bench, start, overlap, speed, seed)
        for diagnostic in found:
            starts.found.setdefault(diagnostic.code, diagnostic)

    def _physical(self, bench: Bench, start: BlockState, overlap: float, speed: float, seed: int) -> list[Diagnostic]:
        found = []
        if overlap > bench.measures.overlap_m:
            message = f"blocks overlap by {overlap * 1000:.1f} mm at the start of seed {seed}"
            facts: dict[str, Any] = {"overlap_m": round(overlap, 5), "seed": seed, "poses": poses(start)}
            found.append(failure(self.name, "reset-overlap", "instability", message, **facts))
        outside = [name for name in start.position if room(start, name) < -ROUNDING]
        if outside:
            message = f"{', '.join(outside)} starts outside of the workspace with seed {seed}"
            facts = {"blocks": outside, "seed": seed, "poses": poses(start)}
            found.append(failure(self.name, "reset-out-of-bounds", "bounds", message, **facts))
        if speed > MOVING:
            message = f"blocks move at {speed * 1000:.0f} mm/s at the start of seed {seed}"
            facts = {"speed_m_s": round(speed, 4), "seed": seed, "poses": poses(start)}
            found.append(failure(self.name, "reset-moves", "instability", message, **facts))
        return found

    def _refused(self, program: Program, bench: Bench, diagnostic: Diagnostic) -> Diagnostic:
        """Why there is no start: where only the code's goal holds in all of them, that goal is vacuous."""
        if diagnostic.code != "start-solves-goal":
            return refused(self.name, diagnostic, "bounds")
        if self._really_solved(program, bench):
            return refused(self.name, diagnostic, "goal")
        message = "the success check is true at every start, though the goal of task.yaml does not hold there"
        return failure(self.name, "goal-vacuous", "goal", message, hint="compare _success with the goal of task.yaml")

    def _really_solved(self, program: Program, bench: Bench) -> bool:
        if looks_back(program.task.goal):
            return True
        renamings = namings(interchangeable(program.task.goal, bench.world))
        for seed in range(bench.measures.resets):
            start = sample_start(program.task.init, bench.world, seed)
            if not any(evaluate(program.task.goal, rename_state(start, renaming)) for renaming in renamings):
                return False
        return True


def deepest_overlap(task: BlockTask) -> float:
    """How deep (m) any two bodies are inside each other."""
    data = task.data
    return max(0.0, -min(data.contact.dist.tolist())) if data.ncon else 0.0
