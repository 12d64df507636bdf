"""RuntimeFixAgent: code that loads and then breaks down, hangs, or has no start."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from rpg.core.diagnostics import Diagnostic
from rpg.ir.artifact import FailureClass, Program
from rpg.passes.repair.record import Case, Proposal, Tools
from rpg.passes.repair.sources import CODE, method_lines, regenerated, sources, with_method, with_source

HOOKS = ("_initialize_env", "_on_reset", "_on_step", "_success", "_fail")


@dataclass(frozen=True)
class RuntimeFixAgent:
    """Lowers the method that broke down again, then whole files."""

    name: str = "RuntimeFixAgent"
    handles: FailureClass = "runtime"

    def propose(self, case: Case, failures: tuple[Diagnostic, ...], tools: Tools) -> Iterator[Proposal]:
        """From the smallest rewrite to the largest."""
        yield from self._methods(case.program, failures, tools)
        yield from regenerated(case.program, tools)

    def _methods(self, program: Program, failures: tuple[Diagnostic, ...], tools: Tools) -> Iterator[Proposal]:
        fresh = tools.lower(program.task)
        for failure in failures:
            line = failure.facts.get("line")
            if failure.facts.get("file") != CODE or not isinstance(line, int):
                continue
            for hook in HOOKS:
                lines = method_lines(program.code, hook)
                text = with_method(sources(program)[CODE], fresh, hook)
                if lines and lines[0] <= line <= lines[1] and text not in (None, program.code):
                    yield Proposal(f"lower {hook} again", with_source(program, CODE, str(text)))
