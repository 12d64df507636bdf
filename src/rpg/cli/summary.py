"""What a compile came to, as people read it."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

from rich.padding import Padding
from rich.table import Table
from rich.text import Text

from rpg.cli.report import print_diagnostics
from rpg.cli.tree import goal_tree

if TYPE_CHECKING:
    from rich.console import Console

    from rpg.cli.output import Output
    from rpg.ir.artifact import GateReport
    from rpg.pipeline import Outcome
    from rpg.store import Written

UNITS = {"_mm_s": "mm/s", "_m_s": "m/s", "_mm": "mm", "_m": "m", "_deg": "°", "_s": "s"}


def print_outcome(out: Output, outcome: Outcome, place: Written | Path | None) -> None:
    """The result on stdout, what stands in its way on stderr. With --quiet, the directory alone."""
    if out.as_json:
        return
    if outcome.status == "admitted" and place is not None and not isinstance(place, Path):
        if out.quiet:
            out.result.print(str(place.version.directory), soft_wrap=True)
        else:
            _print_admitted(out.result, outcome, place)
    print_diagnostics(
        out.errors, [d for d in outcome.diagnostics if _worth_saying(outcome, d.severity)], outcome.instruction
    )
    if outcome.status == "failed":
        _print_failed(out.errors, outcome, place)


def _worth_saying(outcome: Outcome, severity: str) -> bool:
    return outcome.status != "admitted" or severity != "error"


def _print_admitted(console: Console, outcome: Outcome, place: Written) -> None:
    version = place.version
    title = Text.assemble(("✓ ", "bold green"), (str(version), "bold"), (f"  {version.short_hash}", "dim"))
    if place.existed:
        title.append("  was there already", "dim")
    console.print(title)
    console.print(Text(f"  {version.directory}"), soft_wrap=True)
    console.print()
    _print_understood(console, outcome)
    console.print(Padding.indent(gate_table(outcome.gates), 2))
    console.print()
    pictures = [name for name in outcome.pictures if (version.directory / name).exists()]
    console.print(Text(f"  pictures: {', '.join(pictures) or 'none drawn'}", "dim"))


def _print_understood(console: Console, outcome: Outcome) -> None:
    """The goal in words, as a tree where it has parts, and what was assumed."""
    from rpg.explain import goal_outline

    console.print(Padding.indent(Text(outcome.goal_text), 2))
    console.print()
    if outcome.schema:
        goal = goal_outline(outcome.schema)
        if goal.parts:
            console.print(Padding.indent(goal_tree(goal), 2))
            console.print()
    for assumption in outcome.assumptions:
        console.print(Text.assemble(("  assumed: ", "yellow"), assumption))
    if outcome.assumptions:
        console.print()


def _print_failed(console: Console, outcome: Outcome, place: Written | Path | None) -> None:
    console.print()
    console.print(Padding.indent(gate_table(outcome.gates), 2))
    console.print()
    console.print(Text.assemble(("✗ not admitted", "bold red"), f"; kept for looking into: {place}"), soft_wrap=True)


def gate_table(gates: tuple[GateReport, ...]) -> Table:
    """The gates that ran, each with what it measured."""
    table = Table(box=None, pad_edge=False, show_header=False)
    table.add_column()
    table.add_column(style="bold", no_wrap=True)
    table.add_column(style="dim")
    for gate in gates:
        sign = Text("✓", "green") if gate.passed else Text("✗", "bold red")
        table.add_row(sign, gate.name.replace("_", " "), _figures(gate.figures))
    return table


def _figures(figures: Mapping[str, Any]) -> str:
    """Measured figures in a line."""
    return ", ".join(_figure(name, value) for name, value in figures.items() if not isinstance(value, list | dict))


def _figure(name: str, value: Any) -> str:
    """One figure with its unit, which stands at the end of its name."""
    number = f"{value:.3g}" if isinstance(value, float) else str(value)
    for ending, unit in UNITS.items():
        if name.endswith(ending):
            return f"{name.removesuffix(ending).replace('_', ' ')} {number} {unit}"
    return f"{name.replace('_', ' ')} {number}"
