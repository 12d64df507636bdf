"""The Gymnasium side of a task."""

from __future__ import annotations

import subprocess
import sys
import warnings

import gymnasium
import numpy as np
import pytest
from gymnasium.utils.env_checker import check_env

import rpg.registration  # noqa: F401
from rpg.env.gym import BlockEnv
from tests.env.sample_tasks import PatchThenStack, RedOnYellow

STILL = np.zeros(7, dtype=np.float32)


def test_gymnasiums_own_checks_pass() -> None:
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        check_env(BlockEnv(RedOnYellow, privileged=True), skip_render_check=True)


def test_made_by_name() -> None:
    env = gymnasium.make("rpg/Task-v0", task=RedOnYellow)
    _, info = env.reset(seed=0)
    assert info["instruction"] == "put the red block on the yellow block"
    assert info["is_success"] is False and info["stage"] == 0
    assert info["conditions"]["the red block is on the yellow block"] is False


def test_many_at_once() -> None:
    envs = gymnasium.make_vec("rpg/Task-v0", num_envs=3, task=RedOnYellow)
    first, _ = envs.reset(seed=5)
    again, _ = envs.reset(seed=5)
    assert first["proprioception"].shape == (3, 8)
    assert np.array_equal(first["proprioception"], again["proprioception"])
    envs.close()


def test_the_seed_decides_the_episode() -> None:
    env = BlockEnv(RedOnYellow, privileged=True)
    first, same, other = (env.reset(seed=seed)[0]["blocks"] for seed in (1, 1, 2))
    assert np.array_equal(first, same)
    assert not np.array_equal(first, other)
    drawn = [env.reset()[0]["blocks"] for _ in range(2)]
    assert not np.array_equal(*drawn)


def test_doing_nothing_is_no_success_and_no_end() -> None:
    env = BlockEnv(RedOnYellow)
    env.reset(seed=0)
    for _ in range(20):
        _, reward, terminated, truncated, info = env.step(STILL)
        assert (reward, terminated, truncated, info["is_success"]) == (0.0, False, False, False)


def test_a_bad_action_is_named() -> None:
    env = BlockEnv(RedOnYellow)
    env.reset(seed=0)
    with pytest.raises(ValueError, match="7 finite numbers"):
        env.step(np.full(7, np.nan, dtype=np.float32))


def test_pictures_on_request() -> None:
    env = BlockEnv(RedOnYellow, render_mode="rgb_array", cameras=("viewer", "wrist"), image_size=(160, 120))
    seen, _ = env.reset(seed=0)
    assert env.observation_space.contains(seen)
    frame = env.render()
    assert frame is not None and frame.shape == (120, 160, 3) and frame.std() > 10
    assert not np.array_equal(seen["viewer"], seen["wrist"])
    env.close()


def test_an_unknown_camera_is_named() -> None:
    with pytest.raises(ValueError, match="viewer, wrist"):
        BlockEnv(RedOnYellow, cameras=("ceiling",))


def test_a_lost_episode_ends() -> None:
    env = BlockEnv(PatchThenStack)
    env.reset(seed=0)
    green = env.task.model.joint("green_block").qposadr[0]
    env.task.data.qpos[green] += 0.05
    _, _, terminated, _, info = env.step(STILL)
    assert terminated and info["failed"] and not info["is_success"]


def test_importing_the_package_stays_light() -> None:
    code = "import rpg, sys; print([m for m in ('mujoco', 'gymnasium', 'numpy') if m in sys.modules])"
    run = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert run.stdout.strip() == "[]"
