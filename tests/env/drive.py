"""A scripted gripper: enough of a controller to pick a block up and put it down."""

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy as np

from rpg.blocks.state import Vec3
from rpg.env import BlockTask
from rpg.env.gripper import GRIP_STEP, OPENING, REACH_Z, STEP_LIMIT, TURN_LIMIT, BoundGripper

OPEN, CLOSE, KEEP = 1.0, -1.0, 0.0
HOVER = 0.12


def yaw_of(task: BlockTask, name: str) -> float:
    """Turn of a level block about the vertical."""
    w, _, _, z = task.state().orientation[name]
    return 2 * math.atan2(z, w)


def move(task: BlockTask, target: Vec3, yaw: float | None = None, limit: int = 80) -> Iterator[None]:
    """Bring the grasp centre to `target`, the fingers square to a block turned by `yaw`; one control step at a time."""
    assert isinstance(task.robot, BoundGripper)
    for _ in range(limit):
        sensed = task.robot.proprioception(task.data)
        way = np.array(target) - np.array(task.robot.target)
        turn = 0.0
        if yaw is not None:
            turn = (yaw - 2 * math.atan2(sensed[6], sensed[3]) + math.pi / 4) % (math.pi / 2) - math.pi / 4
        if np.linalg.norm(way) < 1e-6 and np.linalg.norm(np.array(target) - sensed[:3]) < 0.003 and abs(turn) < 0.02:
            return
        action = np.zeros(7)
        action[:3] = np.clip(way, -STEP_LIMIT, STEP_LIMIT)
        action[5] = np.clip(turn, -TURN_LIMIT, TURN_LIMIT)
        task.step(1, action)
        yield


def grip(task: BlockTask, command: float, steps: int = 8) -> Iterator[None]:
    """Open, close or keep the fingers for some control steps."""
    for _ in range(steps):
        task.step(1, np.array([0.0, 0.0, 0.0, 0.0, 0.0, 0.0, command]))
        yield


def over(place: Vec3, height: float = HOVER) -> Vec3:
    """The point above a place."""
    return (place[0], place[1], place[2] + height)


def pick(task: BlockTask, name: str) -> Iterator[None]:
    """Grasp a block from above, fingers opened little more than it needs, and lift it."""
    (x, y, z), yaw = task.state().position[name], yaw_of(task, name)
    grasp = (x, y, max(z, REACH_Z[0] + 0.001))
    yield from move(task, over(grasp), yaw)
    yield from grip(task, CLOSE, int((OPENING - task.world.edge[name] - 0.02) / GRIP_STEP))
    yield from move(task, grasp, yaw)
    yield from grip(task, CLOSE)
    yield from move(task, over(grasp))


def put_on(task: BlockTask, name: str, onto: str) -> Iterator[None]:
    """Put the held block on another one, let go, and withdraw."""
    assert task.robot is not None
    hand = task.robot.proprioception(task.data)[2] - task.state().position[name][2]
    x, y, z = task.state().position[onto]
    yaw = yaw_of(task, onto)
    rest = (x, y, z + hand + (task.world.edge[name] + task.world.edge[onto]) / 2)
    yield from move(task, over(rest, HOVER / 2), yaw)
    yield from move(task, over(rest, 0.001), yaw)
    yield from grip(task, OPEN)
    yield from move(task, over(rest))
    yield from grip(task, KEEP)
