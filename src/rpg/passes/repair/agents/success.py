"""SuccessCheckFixAgent: goals that hold too soon, too often, or not where they should."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from rpg.core.diagnostics import Diagnostic
from rpg.ir.artifact import FailureClass
from rpg.passes.repair.arranging import rearranged
from rpg.passes.repair.record import Case, Proposal, Tools
from rpg.passes.repair.sources import CODE, regenerated, with_method, with_source


@dataclass(frozen=True)
class SuccessCheckFixAgent:
    """Writes the success check anew from the conditions of the schema; arranges another goal state.

    It never changes what the conditions are.
    """

    name: str = "SuccessCheckFixAgent"
    handles: FailureClass = "goal"

    def propose(self, case: Case, failures: tuple[Diagnostic, ...], tools: Tools) -> Iterator[Proposal]:
        """The check first, then the goal state, then everything."""
        program = case.program
        fresh = tools.lower(program.task)
        text = program.code
        for hook in ("_success", "_fail"):
            text = with_method(text, fresh, hook) or text
        if text != program.code:
            yield Proposal("write the success check anew", with_source(program, CODE, text))
        yield from regenerated(program, tools)
        if case.gate.name != "unsolved":
            yield from rearranged(program, tools)
