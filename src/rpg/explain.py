"""A task as data that explains it: what `rpg show` says, and what trees of goals are drawn from."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from rpg.blocks.english import clause, describe
from rpg.blocks.state import IDENTITY, BlockState, World
from rpg.ir import goal as g
from rpg.ir.assets import Asset, GoalPatch, SemanticCube
from rpg.ir.schema import TaskSchema
from rpg.ir.walk import children
from rpg.loading import Task
from rpg.store.taskfile import plain


@dataclass(frozen=True)
class Outline:
    """A goal as a tree of words: a connective with its parts, or a condition in English."""

    text: str
    parts: tuple[Outline, ...] = ()


def goal_outline(schema: TaskSchema) -> Outline:
    """The goal of a task as a tree of words."""
    return outline(schema.goal, World(schema.assets))


def outline(goal: g.Goal, world: World) -> Outline:
    """The tree that the connectives of `goal` make of its conditions."""
    words = _connective(goal)
    if words is None:
        return Outline(clause(goal, world))
    return Outline(words, tuple(outline(part, world) for part in children(goal)))


def _connective(goal: g.Goal) -> str | None:
    """What a connective says of its parts; None for what is read as one condition."""
    match goal:
        case g.All():
            return "all of"
        case g.Any():
            return "any of"
        case g.Not():
            return "not"
        case g.Always():
            return "at every step"
        case g.Sequence():
            return "one after the other"
    return None


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


def _stages(goal: g.Goal) -> list[g.Goal]:
    """The goals of every sequence, in order."""
    if isinstance(goal, g.Sequence):
        return [stage.goal for stage in goal.stages]
    return [stage for child in children(goal) for stage in _stages(child)]
