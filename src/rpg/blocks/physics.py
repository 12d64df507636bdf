"""A compiled scene with its state: block poses in and out, and steps of the fixed physics."""

from __future__ import annotations

import math
from collections import deque
from collections.abc import Callable
from copy import copy
from functools import lru_cache

import mujoco
import numpy as np

from rpg.blocks.constants import REST_SPEED, SUBSTEPS
from rpg.blocks.scene import compiled
from rpg.blocks.state import BlockState, Quat, Vec3, World

SETTLE_STEPS = 100
"""Control steps after which a start that still moves is given up."""
QUIET_SPEED = 0.002
"""Speed (m/s) below which every block has settled for good."""
QUIET_STEPS = 4
SLOW = 0.05
"""Speed (m/s) from which nothing climbs on anything any more: it is worth a tenth of a millimetre."""
SLEEPS_BELOW = 1e-4
"""Speed (m/s) below which blocks fall asleep where they may. No verdict on marginal scenes depends on it: see
benchmarks/sleeping.py."""
SAME_POSE, SAME_SPEED = 1e-6, 0.01
"""Poses this close (m, and parts of quaternions) at such speeds (m/s, rad/s) at most count as the same state."""


class Physics:
    """One episode's simulation. Blocks come first in the model's coordinates, in the order of the world.

    `data`: what an earlier simulation of the same model ran in, and runs in no more; making it anew takes as long as
    several control steps.
    """

    def __init__(self, world: World, model: mujoco.MjModel | None = None, data: mujoco.MjData | None = None) -> None:
        self.world = world
        self.model = model or compiled(tuple(world.assets.values()))
        self.data = mujoco.MjData(self.model) if data is None else data
        self.names = tuple(world.blocks)
        self.count = len(self.names)
        self._poses, self._velocities = self.data.qpos[: 7 * self.count], self.data.qvel[: 6 * self.count]
        self._read = np.zeros(7 * self.count)
        self._reach = tuple(world.edge[name] * math.sqrt(3) / 2 for name in self.names)
        for index, name in enumerate(self.names):
            joint = mujoco.mj_name2id(self.model, mujoco.mjtObj.mjOBJ_JOINT, name)
            if self.model.jnt_qposadr[joint] != 7 * index:
                raise ValueError(f"the model does not have block {name!r} in place {index} of its coordinates")

    def write(self, state: BlockState) -> None:
        """Put every block at rest where `state` has it; everything else goes to its default."""
        mujoco.mj_resetData(self.model, self.data)
        flat: list[float] = []
        for name in self.names:
            flat += state.position[name]
            flat += state.orientation[name]
        self._poses[:] = flat
        mujoco.mj_forward(self.model, self.data)

    def read(self, start: BlockState | None = None, held: frozenset[str] = frozenset()) -> BlockState:
        """Where every block is now, and which of them move."""
        self._read[:] = self._poses
        q: list[float] = self._read.tolist()
        v: list[float] = self._velocities.tolist()
        position: dict[str, Vec3] = {}
        orientation: dict[str, Quat] = {}
        moving = []
        for index, name in enumerate(self.names):
            i, j = 7 * index, 6 * index
            position[name] = (q[i], q[i + 1], q[i + 2])
            orientation[name] = (q[i + 3], q[i + 4], q[i + 5], q[i + 6])
            if _speed(v[j : j + 6], self._reach[index]) >= REST_SPEED:
                moving.append(name)
        return BlockState(self.world, position, orientation, frozenset(moving), held, start)

    def unchanged(self) -> bool:
        """Is every block where it was at the last `read`, to within SAME_POSE, and at rest?"""
        velocities, way = self._velocities, self._poses - self._read
        return bool(velocities.dot(velocities) < SAME_SPEED**2 and way.dot(way) < SAME_POSE**2)

    def let_sleep(self, below: float = SLEEPS_BELOW) -> None:
        """Blocks that rest may sleep from now on, until something touches them: steps pass them over.

        Contacts of blocks that sleep are not listed.
        """
        self.model = _sleepy(self.model, below)

    def asleep(self) -> bool:
        """Do all blocks sleep, so that no further step would move anything?"""
        return int(self.data.ntree_awake) == 0

    def step(self, control_steps: int = 1) -> None:
        """Advance by control steps of 1/20 s."""
        mujoco.mj_step(self.model, self.data, SUBSTEPS * control_steps)

    def settle(self, hopeless: Callable[[], bool] | None = None) -> bool:
        """Step until nothing moves any more; False where something still does after SETTLE_STEPS, or where it is
        `hopeless`, which is asked while everything is slow."""
        quiet = 0
        for _ in range(SETTLE_STEPS):
            self.step()
            speed = self.fastest()
            quiet = quiet + 1 if speed < QUIET_SPEED else 0
            if quiet >= QUIET_STEPS:
                return True
            if hopeless is not None and speed < SLOW and hopeless():
                return False
        return False

    def fastest(self) -> float:
        """Greatest speed (m/s) of any point of any block."""
        v: list[float] = self._velocities.tolist()
        if not any(v):
            return 0.0
        return max([_speed(v[6 * k : 6 * k + 6], reach) for k, reach in enumerate(self._reach)])

    def heights(self) -> dict[str, float]:
        """How high the centre of every block is now."""
        return dict(zip(self.names, self._poses[2::7].tolist(), strict=True))

    def sane(self) -> bool:
        """Are all numbers finite?"""
        return all(map(math.isfinite, (*self.data.qpos.tolist(), *self.data.qvel.tolist())))


_left: deque[Physics] = deque(maxlen=1)


def leave(physics: Physics) -> None:
    """Nobody uses this simulation any more: the next one of its model may run in its data."""
    _left.append(physics)


def left(model: mujoco.MjModel) -> mujoco.MjData | None:
    """The data of the simulation that was left last, if it is of this model: for one taker alone."""
    try:
        physics = _left.pop()
    except IndexError:
        return None
    return physics.data if physics.model is model else None


@lru_cache(maxsize=16)
def _sleepy(model: mujoco.MjModel, below: float) -> mujoco.MjModel:
    """A copy of a scene, which is shared, in which blocks that rest may sleep; it is shared too."""
    made = copy(model)
    made.opt.enableflags |= int(mujoco.mjtEnableBit.mjENBL_SLEEP)
    made.opt.sleep_tolerance = below
    return made


@lru_cache(maxsize=1)
def _of(world: World) -> Physics:
    """The simulation that the starts of one task settle in, one after the other: making one takes as long as that."""
    return Physics(world)


def settled_state(state: BlockState, physics: Physics | None = None) -> BlockState | None:
    """`state` after it has come to rest by itself, in a simulation of its world if there is one at hand; None where it
    does not."""
    physics = physics or _of(state.world)
    physics.write(state)
    return physics.read(state.start) if physics.settle() and physics.sane() else None


def _speed(velocity: list[float], reach: float) -> float:
    """Bound on the speed of a block's points from its linear and angular velocity."""
    vx, vy, vz, wx, wy, wz = velocity
    return math.sqrt(vx * vx + vy * vy + vz * vz) + reach * math.sqrt(wx * wx + wy * wy + wz * wz)
