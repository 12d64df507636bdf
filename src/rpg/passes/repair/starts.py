"""Starting poses moved apart, or back into the workspace."""

from __future__ import annotations

import math

from rpg.blocks.constants import WORKSPACE_X, WORKSPACE_Y
from rpg.ir.schema import Start, TaskSchema

CLEARANCE = 0.01
"""Gap (m) between blocks that were moved apart, beyond their jitter."""
ROUNDS = 50


def brought_in(task: TaskSchema) -> TaskSchema | None:
    """The task with every starting pose, jitter included, inside the workspace; None where all are."""
    poses = tuple(_clamped(pose) for pose in task.init.poses)
    return None if poses == task.init.poses else _with(task, poses)


def parted(task: TaskSchema) -> TaskSchema | None:
    """The task with starting poses far enough from each other, however the blocks are turned; None where they are."""
    size = {block.name: block.size for block in task.blocks}
    poses = list(task.init.poses)
    for _ in range(ROUNDS):
        clash = next(
            ((i, j) for j in range(len(poses)) for i in range(j) if _short(poses[i], poses[j], size) > 0), None
        )
        if clash is None:
            break
        i, j = clash
        poses[j] = _clamped(_away(poses[j], poses[i], _short(poses[i], poses[j], size)))
    return None if tuple(poses) == task.init.poses else _with(task, tuple(poses))


def _short(a: Start, b: Start, size: dict[str, float]) -> float:
    """How much closer two blocks start than they should (m)."""
    needed = (size[a.block] + size[b.block]) / math.sqrt(2) + math.sqrt(2) * (a.jitter + b.jitter) + CLEARANCE
    return needed - math.dist(a.position, b.position)


def _away(pose: Start, other: Start, by: float) -> Start:
    dx, dy = pose.position[0] - other.position[0], pose.position[1] - other.position[1]
    length = math.hypot(dx, dy)
    if length < 1e-6:
        dx, dy, length = 0.0, -1.0 if pose.position[1] > 0 else 1.0, 1.0
    step = (by + 1e-3) / length
    return pose.model_copy(
        update={"position": (round(pose.position[0] + dx * step, 4), round(pose.position[1] + dy * step, 4))}
    )


def _clamped(pose: Start) -> Start:
    x, y = (
        min(max(value, low + pose.jitter), high - pose.jitter)
        for value, (low, high) in zip(pose.position, (WORKSPACE_X, WORKSPACE_Y), strict=True)
    )
    return pose.model_copy(update={"position": (round(x, 4), round(y, 4))}) if (x, y) != pose.position else pose


def _with(task: TaskSchema, poses: tuple[Start, ...]) -> TaskSchema:
    return task.model_copy(update={"init": task.init.model_copy(update={"poses": poses})})
