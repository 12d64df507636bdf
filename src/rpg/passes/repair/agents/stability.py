"""StructureStabilityFixAgent: goal states that fall, slide or tremble, and starts that overlap."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from rpg.blocks.evaluate import evaluate
from rpg.blocks.state import BlockState, World
from rpg.core.diagnostics import Diagnostic
from rpg.ir.artifact import FailureClass, Program
from rpg.passes.repair.arranging import rearranged
from rpg.passes.repair.placing import centred, levelled, spread, state_of, with_last
from rpg.passes.repair.record import Case, Proposal, Tools, relowered
from rpg.passes.repair.sources import regenerated
from rpg.passes.repair.starts import parted

GAPS = (1.05, 1.15, 1.3)


@dataclass(frozen=True)
class StructureStabilityFixAgent:
    """Puts blocks flat and squarely on what is under them, gives neighbours more room, or arranges anew."""

    name: str = "StructureStabilityFixAgent"
    handles: FailureClass = "instability"

    def propose(self, case: Case, failures: tuple[Diagnostic, ...], tools: Tools) -> Iterator[Proposal]:
        """Placements that were moved as little as possible come first."""
        program = case.program
        if case.gate.name == "unsolved":
            task = parted(program.task)
            if task is not None:
                yield Proposal("move the starts of overlapping blocks apart", relowered(program, tools, task=task))
            yield from regenerated(program, tools)
            return
        yield from self._moved(program, tools)
        yield from rearranged(program, tools)

    def _moved(self, program: Program, tools: Tools) -> Iterator[Proposal]:
        """Only where the goal still holds as placed: spacing is relaxed within what was asked."""
        if not program.path:
            return
        world = World(program.task.assets)
        here = state_of(program.path[-1], world)
        flat = levelled(here)
        tries: list[tuple[str, BlockState | None]] = [
            ("set the blocks down flat", flat),
            ("centre each block on what is under it", centred(flat)),
        ]
        tries += [(f"move neighbours apart by {factor:g}", spread(flat, factor)) for factor in GAPS]
        for strategy, state in tries:
            if state is not None and evaluate(program.task.goal, state):
                path = with_last(program.path, state)
                yield Proposal(strategy, relowered(program, tools, path=path))
