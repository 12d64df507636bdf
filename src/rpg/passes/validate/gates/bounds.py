"""Gate 6: every block of the goal state is in the workspace, as authored and as it settled."""

from __future__ import annotations

import math
from dataclasses import dataclass

from rpg.blocks.constants import TABLE_Z, WORKSPACE_X, WORKSPACE_Y
from rpg.blocks.state import BlockState
from rpg.ir.artifact import GateReport, Program
from rpg.passes.validate.bench import Bench
from rpg.passes.validate.findings import failure, poses
from rpg.passes.validate.subgoals import subgoals

ROUNDING = 1e-6


@dataclass(frozen=True)
class BoundsGate:
    """Centres within x 0.40 to 0.70 and y -0.25 to 0.25, not below the table."""

    name: str = "bounds"
    cost: int = 1

    def check(self, program: Program, bench: Bench) -> GateReport:
        """Measure the least distance of any centre to the border."""
        if bench.trace is None:
            return GateReport(name=self.name, passed=True)
        found = []
        for name in bench.trace.final.position:
            states = (*bench.trace.history, bench.trace.authored, bench.trace.settled, bench.trace.final)
            worst = min(states, key=lambda state: room(state, name))
            if room(worst, name) < -ROUNDING:
                x, y, z = worst.position[name]
                message = (
                    f"{name} is at x {x:.3f}, y {y:.3f}, z {z:.3f} m in the goal state; "
                    f"the workspace is x 0.40 to 0.70, y -0.25 to 0.25 on the table at {TABLE_Z}"
                )
                parts = subgoals(program.task, worst)
                facts = {
                    "block": name,
                    "outside_m": round(-room(worst, name), 4),
                    "poses": poses(worst),
                    **parts.facts(),
                }
                span = parts.span_about(name)
                found.append(failure(self.name, "goal-out-of-bounds", "bounds", message, span=span, **facts))
        least = min((room(bench.trace.final, name) for name in bench.trace.final.position), default=math.inf)
        return GateReport.of(self.name, found, least_room_mm=round(least * 1000, 1))


def room(state: BlockState, name: str) -> float:
    """Distance (m) of a block's centre from leaving the workspace; negative outside, or below the table top."""
    x, y, z = state.position[name]
    sides = (x - WORKSPACE_X[0], WORKSPACE_X[1] - x, y - WORKSPACE_Y[0], WORKSPACE_Y[1] - y, z - TABLE_Z)
    return min(sides) if all(math.isfinite(side) for side in sides) else -math.inf
