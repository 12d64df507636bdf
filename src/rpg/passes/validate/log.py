"""validation.log: what the gates measured, as text that is the same on every machine."""

from __future__ import annotations

import re
from collections.abc import Sequence
from contextlib import suppress
from typing import Any

from rpg.core.diagnostics import Diagnostic
from rpg.ir.artifact import GateReport, Program
from rpg.passes.validate.runner import admitted

_GATE = re.compile(r"\d+ (?P<name>[\w-]+) +(?P<verdict>pass|FAIL)(?:  (?P<figures>.*))?")


def render_log(program: Program, reports: Sequence[GateReport]) -> str:
    """One line a gate, findings below it."""
    task = program.task
    lines = [f"task {task.name}", f"instruction {' '.join(task.instruction.split())}", ""]
    for number, report in enumerate(reports, 1):
        figures = ", ".join(f"{name} {_figure(value)}" for name, value in report.figures.items())
        lines.append(f"{number} {report.name:<12} {'pass' if report.passed else 'FAIL'}  {figures}".rstrip())
        for diagnostic in report.diagnostics:
            lines += _finding(diagnostic, task.instruction)
    lines += ["", "admitted" if admitted(reports) else "not admitted"]
    return "\n".join(lines) + "\n"


def read_log(text: str) -> tuple[GateReport, ...]:
    """The gates that a log tells of, with their figures as it has them; findings are left to the log."""
    found = []
    for line in text.splitlines():
        match = _GATE.fullmatch(line)
        if match:
            figures = (item.partition(" ") for item in (match["figures"] or "").split(", ") if item)
            told = {name: _number(value) for name, _, value in figures}
            found.append(GateReport(name=match["name"], passed=match["verdict"] == "pass", figures=told))
    return tuple(found)


def _number(text: str) -> Any:
    for kind in (int, float):
        with suppress(ValueError):
            return kind(text)
    return text


def _figure(value: Any) -> str:
    if isinstance(value, float):
        return f"{value:g}"
    if isinstance(value, list | tuple):
        return "[" + "; ".join(_figure(item) for item in value) + "]"
    return str(value)


def _finding(diagnostic: Diagnostic, instruction: str) -> list[str]:
    kind = diagnostic.facts.get("class", diagnostic.severity)
    lines = [f"    {kind}: {diagnostic.message} ({diagnostic.code})"]
    if diagnostic.span:
        start, end = diagnostic.span
        lines.append(f"      asked for in: {' '.join(instruction[start:end].split())!r}")
    for key, title in (("subgoals_passed", "holds"), ("subgoals_failed", "does not hold")):
        lines += [f"      {title}: {text}" for text in diagnostic.facts.get(key, ())]
    for name, place in diagnostic.facts.get("poses", {}).items():
        lines.append(f"      at: {name} {' '.join(f'{value:.4f}' for value in place)}")
    lines += [f"      | {line}" for line in str(diagnostic.facts.get("traceback", "")).splitlines()]
    if diagnostic.hint:
        lines.append(f"      hint: {diagnostic.hint}")
    return lines
