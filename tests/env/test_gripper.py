"""The free-flying gripper: it holds still, goes where it is told, and carries blocks."""

from __future__ import annotations

from itertools import chain

import numpy as np
import pytest

from rpg.env import ColoredCube
from rpg.env.gripper import HOME, OPENING, REACH_Z, FloatingGripper
from tests.env.drive import CLOSE, grip, move, over, pick, put_on
from tests.env.sample_tasks import RedOnYellow


def task_with_gripper(seed: int = 0) -> RedOnYellow:
    task = RedOnYellow(FloatingGripper())
    task.reset(seed)
    return task


def position(task: RedOnYellow) -> np.ndarray:
    assert task.robot is not None
    return task.robot.proprioception(task.data)[:3]


def test_zero_action_holds_the_robot_and_the_blocks() -> None:
    task = task_with_gripper()
    before = task.state()
    task.step(100)
    assert position(task) == pytest.approx(HOME, abs=1e-3)
    for name, place in before.position.items():
        assert task.state().position[name] == pytest.approx(place, abs=1e-4)


def test_an_action_moves_the_gripper_by_its_delta() -> None:
    task = task_with_gripper()
    start = position(task)
    for delta in ([0.02, 0, 0], [0, 0.02, 0], [0, 0, -0.02]):
        task.step(1, np.array([*delta, 0, 0, 0, 0]))
    task.step(10)
    assert position(task) - start == pytest.approx([0.02, 0.02, -0.02], abs=2e-3)


def test_a_rotation_is_a_rotation_vector_in_the_world_frame() -> None:
    task = task_with_gripper()
    assert task.robot is not None
    for _ in range(4):
        task.step(1, np.array([0, 0, 0, 0, 0, 0.2, 0]))
    task.step(10)
    quat = task.robot.proprioception(task.data)[3:7]
    assert quat == pytest.approx([np.cos(0.4), 0, 0, np.sin(0.4)], abs=5e-3)


def test_the_fingers_keep_off_the_table() -> None:
    task = task_with_gripper()
    for _ in range(60):
        task.step(1, np.array([0, 0, -0.03, 0, 0, 0, 0]))
    task.step(10)
    assert position(task)[2] == pytest.approx(REACH_Z[0], abs=2e-3)


def test_pushing_against_something_does_not_wind_up() -> None:
    task = task_with_gripper()
    place = task.state().position["red_block"]
    for _ in move(task, over(place, 0.05)):
        pass
    for _ in grip(task, CLOSE):
        pass
    for _ in range(40):
        task.step(1, np.array([0, 0, -0.03, 0, 0, 0, 0]))
    stuck = position(task)[2]
    for _ in range(3):
        task.step(1, np.array([0, 0, 0.03, 0, 0, 0, 0]))
    task.step(5)
    assert position(task)[2] > stuck + 0.03


@pytest.mark.parametrize("seed", range(4))
def test_success_comes_only_after_release_and_rest(seed: int) -> None:
    task = task_with_gripper(seed)
    held, success = [], []
    for _ in chain(pick(task, "red_block"), put_on(task, "red_block", "yellow_block")):
        held.append("red_block" in task.state().held)
        success.append(task.judge().success.value)
    first = success.index(True)
    last_held = max(k for k, value in enumerate(held) if value)
    assert first > last_held
    assert success[-1]
    assert all(success[first + 5 :])


def test_a_block_is_carried_upright_and_without_slipping() -> None:
    task = task_with_gripper(1)
    for _ in pick(task, "red_block"):
        pass
    offset = np.array(task.state().position["red_block"]) - position(task)
    task.step(60)
    assert task.state().held == {"red_block"}
    assert np.array(task.state().position["red_block"]) - position(task) == pytest.approx(offset, abs=2e-3)
    assert task.state().tilt("red_block") < 3.0


def test_the_fingers_open_and_close_all_the_way() -> None:
    task = task_with_gripper()
    assert task.robot is not None
    assert task.robot.proprioception(task.data)[7] == pytest.approx(OPENING, abs=1e-3)
    for _ in grip(task, CLOSE, 15):
        pass
    assert task.robot.proprioception(task.data)[7] < 0.003


def test_the_fingers_open_by_steps_and_stay_where_they_are_left() -> None:
    task = task_with_gripper()
    assert task.robot is not None
    for _ in grip(task, CLOSE / 2, 3):
        pass
    task.step(20)
    assert task.robot.proprioception(task.data)[7] == pytest.approx(OPENING - 0.03, abs=2e-3)


@pytest.mark.parametrize("edge", [0.015, 0.03, 0.06, 0.08])
def test_blocks_of_all_sizes_are_stacked(edge: float) -> None:
    class Sized(RedOnYellow):
        def _initialize_env(self) -> None:
            self.add(ColoredCube(name="red_block", color="red", size=edge))
            self.add(ColoredCube(name="yellow_block", color="yellow", size=edge))

    task = Sized(FloatingGripper())
    task.reset(1)
    for _ in chain(pick(task, "red_block"), put_on(task, "red_block", "yellow_block")):
        pass
    assert task.judge().success


def test_the_same_actions_give_the_same_states_to_the_bit() -> None:
    ends = []
    for _ in range(2):
        task = task_with_gripper(3)
        for _ in pick(task, "red_block"):
            pass
        ends.append(task.data.qpos.tobytes())
    assert ends[0] == ends[1]
