"""What a robot must offer so that a task can run with it. A task knows nothing else about its robot."""

from __future__ import annotations

from typing import Protocol

import mujoco
import numpy as np
from numpy.typing import NDArray

Action = NDArray[np.float64]
"""End-effector delta: dx, dy, dz (m), rotation vector (rad), gripper in [-1, 1] (positive opens, negative closes)."""
ACTION_SIZE = 7


class Robot(Protocol):
    """A robot bound to one compiled model. Everything it remembers between steps is cleared by `reset`."""

    proprioception_size: int

    def reset(self, data: mujoco.MjData) -> None:
        """Put the robot in its home pose; called after the blocks are in place."""

    def command(self, data: mujoco.MjData, action: Action) -> None:
        """Take over the action of the next control step. All zeros holds the robot where it is."""

    def held(self, data: mujoco.MjData) -> frozenset[str]:
        """The blocks that the robot holds."""

    def proprioception(self, data: mujoco.MjData) -> NDArray[np.float64]:
        """What the robot senses of itself."""


class Embodiment(Protocol):
    """A kind of robot: hashable, so that compiled models can be shared."""

    def attach(self, spec: mujoco.MjSpec) -> None:
        """Add the robot's bodies and actuators to a scene, after all blocks."""

    def bind(self, model: mujoco.MjModel, blocks: tuple[str, ...]) -> Robot:
        """The robot of a compiled scene."""

    def __hash__(self) -> int: ...
