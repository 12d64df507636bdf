"""A task as a Gymnasium environment: 7-D end-effector delta actions at 20 Hz."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from typing import Any

import gymnasium
import numpy as np
from gymnasium import spaces
from numpy.typing import NDArray

from rpg.blocks import camera, opengl, raycast
from rpg.blocks.judgement import Judgement
from rpg.env.embodiment import Embodiment
from rpg.env.gripper import STEP_LIMIT, TURN_LIMIT, FloatingGripper
from rpg.env.task import BlockTask

CAMERAS = (camera.NAME, "wrist")

Observation = dict[str, NDArray[Any]]
TaskFactory = Callable[..., BlockTask]


class BlockEnv(gymnasium.Env[Observation, NDArray[np.float32]]):  # type: ignore[misc]
    """One task, one robot.

    Action: Box(7): translation (m) and rotation vector (rad) of the gripper in the world frame over one control step,
    and the gripper (+1 opens by 2 cm, -1 closes by as much). All zeros holds the robot where it is.

    Observation: `proprioception`; with `cameras` an RGB image each; with `privileged` the poses of all blocks
    (position, quaternion), in the order of `block_names`.

    Reward is 1 in every step where the goal holds, else 0. An episode terminates when the goal holds or is lost for
    good; `info` has `instruction`, `is_success`, `ever_success`, `stage` and `conditions`.
    """

    metadata = {"render_modes": ["rgb_array"], "render_fps": 20}  # noqa: RUF012

    def __init__(
        self,
        task: TaskFactory,
        *,
        render_mode: str | None = None,
        cameras: Sequence[str] = (),
        image_size: tuple[int, int] = (camera.WIDTH, camera.HEIGHT),
        privileged: bool = False,
        terminate_on_success: bool = True,
        instruction: str | None = None,
        embodiment: Embodiment | None = None,
    ) -> None:
        if render_mode not in (None, "rgb_array"):
            raise ValueError(f"render_mode is None or 'rgb_array', not {render_mode!r}")
        unknown = sorted(set(cameras) - set(CAMERAS))
        if unknown:
            raise ValueError(f"there is no camera {unknown[0]!r}; the cameras are {', '.join(CAMERAS)}")
        self.render_mode = render_mode
        self.cameras, self.image_size, self.privileged = tuple(cameras), image_size, privileged
        self.terminate_on_success = terminate_on_success
        pictures = render_mode is not None or bool(cameras)
        self.task = task(embodiment or FloatingGripper(), textures=pictures)
        self.instruction = instruction or self.task.instruction
        self.block_names = tuple(self.task.world.blocks)
        self._canvas: opengl.Canvas | None = None
        self._ever = False
        self._told: Judgement | None = None
        self._facts: dict[str, Any] = {}
        self._conditions: dict[str, bool] = {}
        limit = np.array([STEP_LIMIT] * 3 + [TURN_LIMIT] * 3 + [1.0], dtype=np.float32)
        self.action_space = spaces.Box(-limit, limit, dtype=np.float32)
        self.observation_space = self._space()

    def _space(self) -> spaces.Dict:
        width, height = self.image_size
        inside: dict[str, spaces.Space[Any]] = {"proprioception": spaces.Box(-np.inf, np.inf, (8,), np.float64)}
        if self.privileged:
            inside["blocks"] = spaces.Box(-np.inf, np.inf, (len(self.block_names), 7), np.float64)
        for name in self.cameras:
            inside[name] = spaces.Box(0, 255, (height, width, 3), np.uint8)
        return spaces.Dict(inside)

    def reset(
        self, *, seed: int | None = None, options: dict[str, Any] | None = None
    ) -> tuple[Observation, dict[str, Any]]:
        """Begin the episode of `seed`; without one, a seed is drawn from the environment's own generator."""
        super().reset(seed=seed)
        episode = seed if seed is not None else int(self.np_random.integers(2**31))
        self.task.reset(episode)
        self._ever = False
        return self._observe(), self._info(self.task.judge())

    def step(self, action: NDArray[np.float32]) -> tuple[Observation, float, bool, bool, dict[str, Any]]:
        """One control step."""
        command = np.asarray(action, dtype=np.float64)
        # the sum of a list takes a sixth of the time of np.isfinite, which shows in steps of a tenth of a millisecond
        if command.shape != (7,) or not math.isfinite(sum(command.tolist())):
            raise ValueError(f"an action has 7 finite numbers, not {action!r}")
        self.task.step(1, command)
        judgement = self.task.judge()
        success = judgement.success.value
        self._ever = self._ever or success
        terminated = judgement.failed or (success and self.terminate_on_success)
        return self._observe(), float(success), terminated, False, self._info(judgement)

    def render(self) -> NDArray[np.uint8] | None:
        """What the viewer sees, as RGB pixels."""
        return self._image(camera.NAME) if self.render_mode == "rgb_array" else None

    def close(self) -> None:
        """Free the graphics memory."""
        if self._canvas is not None:
            self._canvas.close()
            self._canvas = None

    def _observe(self) -> Observation:
        robot, data = self.task.robot, self.task.data
        assert robot is not None
        seen: Observation = {"proprioception": robot.proprioception(data)}
        if self.privileged:
            count = len(self.block_names)
            seen["blocks"] = data.qpos[: 7 * count].reshape(count, 7).copy()
        for name in self.cameras:
            seen[name] = self._image(name)
        return seen

    def _info(self, judgement: Judgement) -> dict[str, Any]:
        if judgement is not self._told:
            self._told = judgement
            self._facts = {
                "instruction": self.instruction,
                "is_success": judgement.success.value,
                "failed": judgement.failed,
                "stage": judgement.stage,
            }
            self._conditions = {name: verdict.value for name, verdict in judgement.conditions}
        return {**self._facts, "ever_success": self._ever, "conditions": dict(self._conditions)}

    def _image(self, name: str) -> NDArray[np.uint8]:
        width, height = self.image_size
        if opengl.backend() is None:
            return raycast.draw(self.task.model, self.task.data, self.task.world, name, width, height)
        if self._canvas is None:
            self._canvas = opengl.Canvas(self.task.model, width, height)
        return self._canvas.draw(self.task.data, name)
