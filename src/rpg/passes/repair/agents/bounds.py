"""GeometricBoundsFixAgent: blocks outside of the workspace, at the goal or at the start; patches that are too small."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from rpg.blocks.evaluate import evaluate
from rpg.blocks.state import World
from rpg.core.diagnostics import Diagnostic
from rpg.ir.artifact import FailureClass
from rpg.passes.repair.arranging import rearranged
from rpg.passes.repair.placing import inside, state_of, with_last
from rpg.passes.repair.record import Case, Proposal, Tools, relowered
from rpg.passes.repair.sources import regenerated
from rpg.passes.repair.starts import brought_in


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
        yield from rearranged(program, tools)
