"""A task as data and as people read it: what `rpg show` says."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from rich.table import Table
from rich.text import Text

from rpg.blocks.english import describe
from rpg.blocks.state import IDENTITY, BlockState, World
from rpg.cli.tree import clause, goal_tree
from rpg.ir.assets import Asset, GoalPatch, SemanticCube
from rpg.ir.goal import Goal, Sequence
from rpg.ir.walk import children
from rpg.loading import Task
from rpg.store.taskfile import plain

if TYPE_CHECKING:
    from rich.console import Console


def explained(task: Task, seed: int) -> dict[str, Any]:
    """The task as one JSON document, its assets where the reset of `seed` has them."""
    schema = task.schema
    state = task.task_class().reset(seed)
    return {
        "name": schema.name,
        "instruction": schema.instruction,
        "version": task.version.number,
        "hash": task.version.hash,
        "assets": [_asset(asset, state) for asset in schema.assets],
        "init": plain(schema.init),
        "goal": plain(schema.goal),
        "goal_text": describe(schema),
        "assumptions": list(schema.assumptions),
        "stages": [clause(stage, state.world) for stage in _stages(schema.goal)],
    }


def print_task(console: Console, task: Task, data: dict[str, Any]) -> None:
    """The task for people: what was said, what was understood, what there is."""
    schema, version = task.schema, task.version
    console.print(Text.assemble((str(version), "bold"), (f"  {version.short_hash}", "dim")))
    console.print(Text(f"“{schema.instruction}”", "italic"))
    console.print()
    console.print(data["goal_text"])
    console.print()
    console.print(goal_tree(schema.goal, World(schema.assets)))
    console.print()
    console.print(_assets(data["assets"]))
    for assumption in schema.assumptions:
        console.print(Text.assemble(("assumed: ", "dim"), assumption))


def _assets(assets: list[dict[str, Any]]) -> Table:
    table = Table(box=None, pad_edge=False, header_style="dim")
    for title in ("asset", "what", "extent (cm)", "starts at (m)"):
        table.add_column(title)
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


def _asset(asset: Asset, state: BlockState) -> dict[str, Any]:
    if isinstance(asset, GoalPatch):
        return {
            "name": asset.name,
            "type": asset.type,
            "color": asset.color,
            "shape": asset.shape,
            "size": list(asset.size),
            "extent": [*asset.size, 0.0],
            "fixed": True,
            "position": list(state.where(asset.name)),
            "orientation": list(IDENTITY),
        }
    found: dict[str, Any] = {"name": asset.name, "type": asset.type, "color": asset.color}
    if isinstance(asset, SemanticCube):
        found |= {"labels": asset.labels.model_dump()} if asset.labels else {"label": asset.label}
    return found | {
        "shape": "cube",
        "size": asset.size,
        "extent": [asset.size] * 3,
        "fixed": False,
        "position": list(state.position[asset.name]),
        "orientation": list(state.orientation[asset.name]),
    }


def _stages(goal: Goal) -> list[Goal]:
    """The goals of every sequence, in order."""
    if isinstance(goal, Sequence):
        return [stage.goal for stage in goal.stages]
    return [stage for child in children(goal) for stage in _stages(child)]
