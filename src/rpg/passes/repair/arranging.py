"""Goal states arranged anew; patches grown where there is no room otherwise."""

from __future__ import annotations

from collections.abc import Iterator
from random import Random

from rpg.core.diagnostics import Refusal
from rpg.ir.artifact import Program
from rpg.ir.assets import Asset, GoalPatch
from rpg.ir.schema import TaskSchema
from rpg.passes.repair.record import Proposal, Tools, relowered

SEEDS = 3
GROWTH = (1.25, 1.5, 2.0, 3.0, 5.0)


def rearranged(program: Program, tools: Tools) -> Iterator[Proposal]:
    """The same task with other goal states; where it has none at all, with the least larger patches that have one."""
    for seed in range(1, SEEDS + 1):
        try:
            path = tools.arrange(program.task, Random(f"repair {seed}"))
        except Refusal:
            yield from _grown(program, tools)
            return
        yield Proposal(f"arrange another goal state ({seed})", relowered(program, tools, path=path))


def _grown(program: Program, tools: Tools) -> Iterator[Proposal]:
    """A patch grows so that what must lie on it fits."""
    for factor in GROWTH if program.task.patches else ():
        task = grow(program.task, factor)
        try:
            path = tools.arrange(task, Random(f"repair {factor}"))
        except Refusal:
            continue
        yield Proposal(f"grow the patches by {factor:g}", relowered(program, tools, task=task, path=path))


def grow(task: TaskSchema, factor: float) -> TaskSchema:
    """The task with larger patches, in whole millimetres."""
    assets: list[Asset] = []
    for asset in task.assets:
        if isinstance(asset, GoalPatch):
            x, y = (round(side * factor, 3) for side in asset.size)
            asset = asset.model_copy(update={"size": (x, y)})
        assets.append(asset)
    return task.model_copy(update={"assets": tuple(assets)})
