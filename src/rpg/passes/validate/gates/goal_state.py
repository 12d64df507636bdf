"""Gate 5: the goal configuration stands by itself, and the goal holds in it for as long as anyone looks."""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from rpg.blocks.state import BlockState
from rpg.core.diagnostics import Diagnostic, Refusal
from rpg.env import BlockTask, Verdict
from rpg.ir.artifact import GateReport, Program
from rpg.passes.validate.bench import Bench, Trace
from rpg.passes.validate.findings import failure, poses, refused, told
from rpg.passes.validate.subgoals import Subgoals, subgoals

NUDGE = 0.02
"""Angular speed (rad/s) that every block is given at the beginning: what only balances does not bear it."""
STILL = 5e-5
"""A verdict of our own lowering, which depends on the state alone, is taken over from the step before while nothing has
moved by more than this (m, or unit of rotation) ..."""
SAFE_MARGIN = 0.02
"""... and while it was clear by at least this margin."""


@dataclass
class _Hold:
    """What happened while the goal state was held."""

    margin: float = math.inf
    broken_at: int | None = None
    drift: float = 0.0
    fall: float = 0.0
    who: str = ""
    states: list[BlockState] = field(default_factory=list)


@dataclass(frozen=True)
class GoalStateGate:
    """Settle, then hold: G true after settling and throughout, drift within bounds, at rest at the end."""

    name: str = "goal-state"
    cost: int = 2

    def check(self, program: Program, bench: Bench) -> GateReport:
        """Run the goal-state task with the robot holding still."""
        task = bench.goal
        try:
            authored = task.reset(0)
            task.physics.let_sleep()
            nudge(task)
            settle(task, bench)
        except Refusal as refusal:
            return GateReport.of(self.name, [refused(self.name, d) for d in refusal.diagnostics])
        except Exception as error:
            message = f"the goal-state task does not run: {type(error).__name__}: {error}"
            crash = failure(self.name, "task-crashes", "runtime", message, traceback=told(error, bench.sources))
            return GateReport.of(self.name, [crash])
        settled = task.state()
        judged = task.judge()
        hold = self._hold(task, authored, settled, judged.success, bench)
        bench.trace = Trace(authored, settled, task.state(), history_of(program, authored))
        found = self._findings(program, bench, hold, judged.success)
        return GateReport.of(self.name, found, **self._figures(bench, hold))

    def _hold(
        self, task: BlockTask, authored: BlockState, settled: BlockState, verdict: Verdict, bench: Bench
    ) -> _Hold:
        hold = _Hold(margin=verdict.margin)
        places = task.data.qpos
        seen, moving = places.copy(), bool(settled.moving)
        self._measure(hold, authored, settled, settled)
        for step in range(1, bench.measures.hold_steps + 1):
            task.step()
            last = step == bench.measures.hold_steps or stays(task, bench)
            way = places - seen
            # the sum of squares, in a fifth of the time, tells of most steps that no part of it is larger
            still = bench.trusted and (way.dot(way) <= STILL**2 or np.abs(way).max() <= STILL)
            if still and not moving and verdict.margin >= SAFE_MARGIN and not last:
                continue
            now, verdict = task.state(), task.judge().success
            seen, moving = places.copy(), bool(now.moving)
            hold.margin = min(hold.margin, verdict.margin)
            if not verdict.value and hold.broken_at is None:
                hold.broken_at = step
            self._measure(hold, authored, settled, now)
            if last:
                break
        return hold

    def _measure(self, hold: _Hold, authored: BlockState, settled: BlockState, now: BlockState) -> None:
        for name, place in now.position.items():
            drift = max(math.dist(place, authored.position[name]), math.dist(place, settled.position[name]))
            if drift > hold.drift:
                hold.drift, hold.who = drift, name
            fall = max(abs(place[2] - authored.position[name][2]), abs(place[2] - settled.position[name][2]))
            hold.fall = max(hold.fall, fall)

    def _findings(self, program: Program, bench: Bench, hold: _Hold, verdict: Verdict) -> list[Diagnostic]:
        assert bench.trace is not None
        measures, final = bench.measures, bench.trace.final
        stands = hold.fall <= measures.topple_m and hold.drift <= measures.drift_m and not final.moving
        if stands and verdict.value and hold.broken_at is None:
            return []
        parts = subgoals(program.task, bench.trace.settled if not verdict.value else final)
        facts = {**parts.facts(), "poses": poses(final)}
        found = []
        if hold.fall > measures.topple_m:
            message = f"the goal state topples: {hold.who} ends {hold.fall * 1000:.0f} mm higher or lower than it was"
            found.append(self._unstable("goal-topples", message, hold, parts, facts))
        elif hold.drift > measures.drift_m:
            message = (
                f"the goal state drifts: {hold.who} moves by {hold.drift * 1000:.1f} mm, at most 10 mm are allowed"
            )
            found.append(self._unstable("goal-drifts", message, hold, parts, facts))
        if final.moving:
            message = f"{', '.join(sorted(final.moving))} still moves at the end of the goal state"
            found.append(self._unstable("goal-moves", message, hold, parts, facts))
        if not verdict.value:
            message = f"the goal does not hold in the goal state: {parts.broken_text()}"
            found.append(failure(self.name, "goal-not-met", "goal", message, span=parts.span, **facts))
        elif hold.broken_at is not None:
            message = f"the goal holds at first and breaks after {hold.broken_at} control steps: {parts.broken_text()}"
            found.append(failure(self.name, "goal-not-kept", "goal", message, span=parts.span, **facts))
        return found

    def _unstable(self, code: str, message: str, hold: _Hold, parts: Subgoals, facts: dict[str, Any]) -> Diagnostic:
        measured = {"block": hold.who, "drift_m": round(hold.drift, 5), "fall_m": round(hold.fall, 5)}
        span = parts.span_about(hold.who)
        return failure(self.name, code, "instability", message, span=span, **{**facts, **measured})

    def _figures(self, bench: Bench, hold: _Hold) -> dict[str, Any]:
        measures = bench.measures
        return {
            "control_steps": measures.settle_steps + measures.hold_steps,
            "margin": round(hold.margin, 2),
            "drift_mm": round(hold.drift * 1000, 1),
            "fall_mm": round(hold.fall * 1000, 1),
        }


def settle(task: BlockTask, bench: Bench) -> None:
    """Let the goal state come to rest; once everything sleeps, the steps that are left would change nothing."""
    for _ in range(bench.measures.settle_steps):
        task.step()
        if stays(task, bench):
            return


def stays(task: BlockTask, bench: Bench) -> bool:
    """Would further steps change nothing? Code that is not our own lowering may do anything at each of them."""
    return bench.trusted and task.physics.asleep()


def nudge(task: BlockTask) -> None:
    """Set every block rocking by a hair; it comes to rest within a step unless it stands on an edge."""
    count = len(task.world.blocks)
    for index in range(count):
        sign = 1.0 if index % 2 else -1.0
        task.data.qvel[6 * index + 3 : 6 * index + 5] = (NUDGE, sign * NUDGE)


def history_of(program: Program, authored: BlockState) -> tuple[BlockState, ...]:
    """The scenes before the goal scene, the start first."""
    return tuple(
        BlockState(
            authored.world,
            {placement.block: placement.position for placement in scene},
            {placement.block: placement.orientation for placement in scene},
        )
        for scene in program.path[:-1]
    )
