"""A task as people read it."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from rich.table import Table
from rich.text import Text

from rpg.cli.tree import goal_tree

if TYPE_CHECKING:
    from rich.console import Console

    from rpg.explain import Outline
    from rpg.loading import Task


def print_task(console: Console, task: Task, data: dict[str, Any], goal: Outline) -> None:
    """The task for people: what was said, what was understood, what there is."""
    schema, version = task.schema, task.version
    console.print(Text.assemble((str(version), "bold"), (f"  {version.short_hash}", "dim")))
    console.print(Text(f"“{schema.instruction}”", "italic"))
    console.print()
    console.print(data["goal_text"])
    console.print()
    console.print(goal_tree(goal))
    console.print()
    console.print(_assets(data["assets"]))
    if schema.assumptions:
        console.print()
    for assumption in schema.assumptions:
        console.print(Text.assemble(("assumed: ", "dim"), assumption))


def _assets(assets: list[dict[str, Any]]) -> Table:
    table = Table(box=None, pad_edge=False, header_style="dim")
    table.add_column("asset", no_wrap=True, min_width=max(len(asset["name"]) for asset in assets))
    for title in ("what", "extent (cm)", "starts at (m)"):
        table.add_column(title, overflow="fold")
    for asset in assets:
        place = ", ".join(f"{number:.3f}" for number in asset["position"])
        extent = " × ".join(f"{100 * number:g}" for number in asset["extent"] if number)
        table.add_row(asset["name"], _what(asset), extent, place)
    return table


def _what(asset: dict[str, Any]) -> str:
    if asset["type"] == "GoalPatch":
        return f"{asset['color']} {asset['shape']} on the table"
    if asset["type"] == "ColoredCube":
        return f"{asset['color']} cube"
    symbols = asset["label"] if "label" in asset else ", ".join(f"{f} {s}" for f, s in asset["labels"].items() if s)
    return f"{asset['color']} cube with {symbols}"
