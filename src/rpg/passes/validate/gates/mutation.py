"""Gate 8: the code's goal tells the goal state from its near-misses, and accepts other goal states."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass, replace
from itertools import islice
from random import Random
from typing import Any

from rpg.blocks.alike import Judge
from rpg.blocks.arrange.solve import ANYHOW, Solver
from rpg.blocks.evaluate import evaluate, settled
from rpg.blocks.near_miss import both_kinds
from rpg.blocks.predicate import NearMiss
from rpg.blocks.state import BlockState, Quat
from rpg.core.diagnostics import Diagnostic
from rpg.env import BlockTask
from rpg.env.bench import judge_each
from rpg.ir.artifact import GateReport, Program
from rpg.passes.validate.bench import Bench
from rpg.passes.validate.findings import failure, poses, told
from rpg.passes.validate.subgoals import subgoals

SHAKES = (0.008, 0.004, 0.002)
"""How far (m) the blocks of a goal state are moved when it is shaken; they turn by ten times that in radians."""
SLACK = 0.05
TRIES = 1200
"""Candidate places judged for another goal state before it is left out."""
MOST_NAMED = 5
"""Survivors listed in a failure."""


@dataclass(frozen=True)
class MutationGate:
    """Near-misses must make G false, other sampled goal states must make it true."""

    name: str = "mutation"
    cost: int = 1

    def check(self, program: Program, bench: Bench) -> GateReport:
        """Judge states without physics."""
        assert bench.trace is not None
        try:
            return self._run(program, bench)
        except Exception as error:
            message = f"the goal cannot be judged on a near-miss: {type(error).__name__}: {error}"
            crash = failure(self.name, "task-crashes", "runtime", message, traceback=told(error, bench.sources))
            return GateReport.of(self.name, [crash])

    def _run(self, program: Program, bench: Bench) -> GateReport:
        assert bench.trace is not None
        rng = Random(f"near-misses of {program.task.name}")
        goal = bench.trace.authored
        history = bench.trace.history
        judge = bench.judge or Judge(program.task.goal, bench.world)
        doubtful, known = both_kinds(program.task.goal, goal, rng, judge)
        misses = doubtful + known
        sampled, moving = other_goals(program, bench), unsettled(goal)
        survivors = misses
        if bench.tells:
            survivors = [miss for miss in doubtful if judge.as_named(_begun(miss.state, history))]
        if bench.judge is None and survivors:
            survivors = surviving(bench.task, history, survivors)
        # our own lowering says word for word what the others are found by: one shows that it does
        others = list(islice(sampled, 1 if bench.trusted else None))
        # where stages count, the goal was met before it moves again
        survivors += surviving(bench.task, (*history, goal) if history else (), moving)
        judged = zip(others, judge_each(bench.task, history, others), strict=True)
        rejected = [state for state, judgement in judged if not judgement.success]
        misses += moving
        found = []
        if survivors:
            found.append(self._vacuous(program, survivors, len(misses)))
        if rejected:
            found.append(self._over_tight(program, rejected, len(others)))
        score = 1.0 if not misses else (len(misses) - len(survivors)) / len(misses)
        figures: dict[str, Any] = {
            "score": round(score, 4),
            "near_misses": len(misses),
            "survivors": len(survivors),
            "other_goals": len(others),
            "rejected": len(rejected),
        }
        if survivors:
            figures["survived"] = [miss.what for miss in survivors]
        return GateReport.of(self.name, found, **figures)

    def _vacuous(self, program: Program, survivors: list[NearMiss], total: int) -> Diagnostic:
        what = "; ".join(miss.what for miss in survivors[:MOST_NAMED])
        message = f"the goal holds in {len(survivors)} of {total} states that only nearly satisfy it: {what}"
        first = subgoals(program.task, survivors[0].state)
        facts = {"survivors": [miss.what for miss in survivors], "poses": poses(survivors[0].state), **first.facts()}
        return failure(self.name, "goal-vacuous", "goal", message, span=first.span, **facts)

    def _over_tight(self, program: Program, rejected: list[BlockState], total: int) -> Diagnostic:
        message = f"the goal does not hold in {len(rejected)} of {total} other states that satisfy the instruction"
        first = subgoals(program.task, rejected[0])
        facts = {"poses": poses(rejected[0]), **first.facts()}
        return failure(self.name, "goal-over-tight", "goal", message, span=first.span, **facts)


def _begun(state: BlockState, history: tuple[BlockState, ...]) -> BlockState:
    """A state in the episode that passed through `history`."""
    return state.since(history[0].since(None)) if history else state


def surviving(task: BlockTask, past: tuple[BlockState, ...], misses: list[NearMiss]) -> list[NearMiss]:
    """The near-misses in which the code's goal holds at the end of an episode that passed through these scenes."""
    judged = judge_each(task, past, [miss.state for miss in misses])
    return [miss for miss, judgement in zip(misses, judged, strict=True) if judgement.success]


def unsettled(goal: BlockState) -> list[NearMiss]:
    """The goal state while a block still moves, and while one is held."""
    if not goal.position:
        return []
    last = max(goal.position, key=lambda name: (goal.position[name][2], name))
    block = frozenset({last})
    return [
        NearMiss(f"{last} still moves", replace(goal, moving=block)),
        NearMiss(f"{last} is still held", replace(goal, held=block)),
    ]


def other_goals(program: Program, bench: Bench) -> Iterator[BlockState]:
    """Further goal states: others than the program's own, then its own and these a little shaken."""
    assert bench.trace is not None
    history, rng = bench.trace.history, Random(f"other goals of {program.task.name}")
    solver = Solver(program.task.goal, bench.world, history[0] if history else None, TRIES, ANYHOW)
    known = [bench.trace.authored]
    for _ in range(bench.measures.other_goals):
        drawn = solver.solve(rng, vary=True)
        if drawn is not None:
            known.append(drawn)
            yield drawn
    for state in known:
        shaken = shake(program, state, rng)
        if shaken is not None:
            yield shaken


def shake(program: Program, state: BlockState, rng: Random) -> BlockState | None:
    """`state` with every block moved and turned a little, as far as the schema's goal still holds with some slack."""
    moves = {name: [rng.uniform(-1.0, 1.0) for _ in range(3)] for name in state.position}
    for reach in SHAKES:
        poses = {
            name: (
                (x + reach * moves[name][0], y + reach * moves[name][1], z),
                turned(state.orientation[name], 10 * reach * moves[name][2]),
            )
            for name, (x, y, z) in state.position.items()
        }
        shaken = state.moved(poses)
        verdict = evaluate(program.task.goal, shaken) & settled(shaken)
        if verdict.value and verdict.margin > SLACK:
            return shaken
    return None


def turned(orientation: Quat, angle: float) -> Quat:
    """An orientation turned further about the vertical (radians)."""
    c, s = math.cos(angle / 2), math.sin(angle / 2)
    w, x, y, z = orientation
    return (c * w - s * z, c * x - s * y, c * y + s * x, c * z + s * w)
