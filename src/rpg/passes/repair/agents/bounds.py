"""GeometricBoundsFixAgent: blocks outside of the workspace, at the goal or at the start; patches that are too small."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from random import Random

from rpg.blocks.evaluate import evaluate
from rpg.blocks.state import World
from rpg.core.diagnostics import Diagnostic, Refusal
from rpg.ir.artifact import FailureClass
from rpg.ir.assets import Asset, GoalPatch
from rpg.ir.schema import TaskSchema
from rpg.passes.repair.placing import inside, state_of, with_last
from rpg.passes.repair.record import Case, Proposal, Tools, relowered
from rpg.passes.repair.sources import regenerated
from rpg.passes.repair.starts import brought_in

SEEDS = 2
GROWTH = (1.25, 1.5, 2.0)


@dataclass(frozen=True)
class GeometricBoundsFixAgent:
    """Moves the whole arrangement back in, arranges anew, grows a patch."""

    name: str = "GeometricBoundsFixAgent"
    handles: FailureClass = "bounds"

    def propose(self, case: Case, failures: tuple[Diagnostic, ...], tools: Tools) -> Iterator[Proposal]:
        """Moving before arranging anew, and sizes last."""
        program = case.program
        task = brought_in(program.task)
        if task is not None:
            yield Proposal("move the starts into the workspace", relowered(program, tools, task=task))
        yield from regenerated(program, tools)
        if program.path:
            state = inside(state_of(program.path[-1], World(program.task.assets)))
            if state is not None and evaluate(program.task.goal, state):
                path = with_last(program.path, state)
                yield Proposal("move the arrangement into the workspace", relowered(program, tools, path=path))
        yield from self._arranged(program.task, case, tools)

    def _arranged(self, task: TaskSchema, case: Case, tools: Tools) -> Iterator[Proposal]:
        grown = [(f"grow the patches by {factor:g}", grow(task, factor)) for factor in GROWTH if task.patches]
        again = [(f"arrange another goal state ({seed})", task) for seed in range(1, SEEDS + 1)]
        for strategy, changed in (*again, *grown):
            try:
                path = tools.arrange(changed, Random(f"repair {strategy}"))
            except Refusal:
                continue
            yield Proposal(strategy, relowered(case.program, tools, task=changed, path=path))


def grow(task: TaskSchema, factor: float) -> TaskSchema:
    """The task with larger patches, in whole millimetres."""
    assets: list[Asset] = []
    for asset in task.assets:
        if isinstance(asset, GoalPatch):
            x, y = (round(side * factor, 3) for side in asset.size)
            asset = asset.model_copy(update={"size": (x, y)})
        assets.append(asset)
    return task.model_copy(update={"assets": tuple(assets)})
