"""BlockTask: starts, judgement, look-alikes, stages, standing conditions, goal scenes."""

from __future__ import annotations

import math
import os
import subprocess
import sys
from dataclasses import replace
from typing import Any

import pytest

from rpg.blocks.constants import TABLE_Z
from rpg.blocks.initial import sample_start
from rpg.blocks.state import IDENTITY, BlockState, Vec3, World
from rpg.core.diagnostics import Refusal
from rpg.env import BlockTask, GoalPatch, Verdict, drawing
from rpg.ir.schema import InitialState
from tests.env.sample_tasks import AlikeOnBlue, AlreadyDone, Farther, Heaped, PatchThenStack, RedOnYellow, Restack

LOW, HIGH = TABLE_Z + 0.02, TABLE_Z + 0.06


def state_of(task: BlockTask, **places: Vec3) -> BlockState:
    return BlockState(task.world, places, dict.fromkeys(places, IDENTITY))


@pytest.mark.parametrize("seed", range(5))
def test_a_reset_is_unsolved_and_does_not_move_by_itself(seed: int) -> None:
    task = RedOnYellow()
    start = task.reset(seed)
    assert not task.judge().success
    task.step(40)
    for name, place in start.position.items():
        assert task.state().position[name] == pytest.approx(place, abs=2e-4)
    assert not task.state().moving


def test_a_task_that_is_done_at_the_start_is_refused() -> None:
    with pytest.raises(Refusal) as refusal:
        AlreadyDone().reset(0)
    assert [d.code for d in refusal.value.diagnostics] == ["start-solves-goal"]


def test_starts_that_are_built_in_vain_are_built_so_that_the_goal_is_ahead(monkeypatch: pytest.MonkeyPatch) -> None:
    drawn = []

    def counted(init: InitialState, world: World, seed: int, attempt: int, *own: Any) -> BlockState:
        drawn.append((seed, attempt))
        return sample_start(init, world, seed, attempt, *own)

    monkeypatch.setattr(drawing, "sample_start", counted)
    task, other = Farther(), Farther()
    starts = [task.reset(seed) for seed in range(6)]
    assert len(drawn) <= drawing.IN_VAIN + 8
    for seed in (4, 0, 5):
        assert other.reset(seed).position == starts[seed].position
    for start in starts:
        assert 0.1 <= math.dist(start.position["red_block"][:2], start.position["blue_block"][:2]) < 0.15
    RedOnYellow().reset(0)
    assert drawn[-1] == (0, 0)


def test_conditions_are_told_in_words() -> None:
    task = RedOnYellow()
    task.reset(0)
    assert [name for name, _ in task.judge().conditions] == [
        "the red block is on the yellow block",
        "every block is at rest, released and supported",
    ]


def test_look_alikes_may_change_roles() -> None:
    task = AlikeOnBlue()
    good = {"on": (0.5, 0.0, HIGH), "behind": (0.6, 0.0, LOW)}
    for a, b in (("on", "behind"), ("behind", "on")):
        state = state_of(task, red_block_1=good[a], red_block_2=good[b], blue_block=(0.5, 0.0, LOW))
        assert task.judge_states([state])[0].success
    both = state_of(task, red_block_1=(0.5, 0, HIGH), red_block_2=(0.5, 0, HIGH + 0.04), blue_block=(0.5, 0, LOW))
    assert not task.judge_states([both])[0].success


def test_a_held_or_moving_block_is_no_success() -> None:
    task = RedOnYellow()
    state = state_of(task, red_block=(0.5, 0.0, HIGH), yellow_block=(0.5, 0.0, LOW))
    assert task.judge_states([state])[0].success
    assert not task.judge_states([replace(state, held=frozenset({"red_block"}))])[0].success
    assert not task.judge_states([replace(state, moving=frozenset({"red_block"}))])[0].success


GREEN = (0.45, -0.2, LOW)
ON_PATCH, AWAY = (0.6, 0.1, LOW), (0.45, 0.0, LOW)
ON_RED = (0.6, 0.1, HIGH)


def staged(task: BlockTask, red: Vec3, blue: Vec3, green: Vec3 = GREEN) -> BlockState:
    return state_of(task, red_block=red, blue_block=blue, green_block=green)


def test_stages_in_turn_succeed() -> None:
    task = PatchThenStack()
    start = staged(task, AWAY, (0.5, -0.1, LOW))
    middle, end = staged(task, ON_PATCH, (0.5, -0.1, LOW)), staged(task, ON_PATCH, ON_RED)
    verdicts = task.judge_states([start, middle, end])
    assert [(v.success.value, v.failed, v.stage) for v in verdicts] == [
        (False, False, 0),
        (False, False, 1),
        (True, False, 2),
    ]


def test_a_stage_met_early_loses_the_episode_even_if_the_end_looks_right() -> None:
    task = PatchThenStack()
    start = staged(task, AWAY, (0.5, -0.1, LOW))
    early = staged(task, AWAY, (AWAY[0], AWAY[1], HIGH))
    end = staged(task, ON_PATCH, ON_RED)
    verdicts = task.judge_states([start, early, end])
    assert [v.failed for v in verdicts] == [False, True, True]
    assert not verdicts[-1].success


def test_an_unsettled_state_meets_no_stage() -> None:
    task = PatchThenStack()
    start = staged(task, AWAY, (0.5, -0.1, LOW))
    carried = replace(staged(task, ON_PATCH, (0.5, -0.1, LOW)), held=frozenset({"red_block"}))
    assert [v.stage for v in task.judge_states([start, carried])] == [0, 0]


def test_a_standing_condition_that_lapses_once_loses_the_episode() -> None:
    task = PatchThenStack()
    start = staged(task, AWAY, (0.5, -0.1, LOW))
    nudged = staged(task, ON_PATCH, (0.5, -0.1, LOW), green=(0.5, -0.2, LOW))
    end = staged(task, ON_PATCH, ON_RED)
    verdicts = task.judge_states([start, nudged, end])
    assert [v.failed for v in verdicts] == [False, True, True]
    assert not verdicts[-1].success


def test_a_stage_that_holds_at_the_start_counts_when_its_turn_comes() -> None:
    task = Restack()
    stacked = state_of(task, red_block=(0.5, 0.0, HIGH), blue_block=(0.5, 0.0, LOW))
    apart = state_of(task, red_block=(0.6, 0.1, LOW), blue_block=(0.5, 0.0, LOW))
    assert [(v.success.value, v.stage) for v in task.judge_states([stacked, stacked, apart, stacked])] == [
        (False, 0),
        (False, 0),
        (False, 1),
        (True, 2),
    ]


def test_an_arranged_start_that_satisfies_a_later_stage_is_no_obstacle() -> None:
    task = Restack()
    start = task.reset(0)
    assert start.position["red_block"][2] == pytest.approx(HIGH, abs=1e-3)
    assert not task.judge().success


class Placed(PatchThenStack):
    """The goal, by way of its stages."""

    def _on_reset(self) -> None:
        self.place("green_block", GREEN)
        self.place("red_block", AWAY)
        self.place("blue_block", (0.5, -0.1, LOW), yaw=0.4)
        self.waypoint()
        self.place("red_block", ON_PATCH)
        self.waypoint()
        self.place("blue_block", ON_RED, quat=(0.0, 0.0, 0.0, 1.0))


def test_a_goal_scene_is_reached_by_its_waypoints_and_stays_reached() -> None:
    task = Placed()
    task.reset(0)
    assert task.judge().success
    for _ in range(20):
        task.step()
        assert task.judge().success
    assert task.state().start is not None
    assert task.state().start.position["red_block"] == AWAY


@pytest.mark.parametrize("axis", [1, 2])
def test_a_block_placed_on_its_edge_falls_however_exactly_it_is_placed(axis: int) -> None:
    class Balanced(RedOnYellow):
        def _on_reset(self) -> None:
            quat = [math.cos(math.pi / 8), 0.0, 0.0, 0.0]
            quat[axis] = math.sin(math.pi / 8)
            self.place(
                "red_block", (0.5, 0.0, TABLE_Z + 0.02 * math.sqrt(2)), quat=(quat[0], quat[1], quat[2], quat[3])
            )
            self.place("yellow_block", (0.6, 0.1, LOW))

    task = Balanced()
    start = task.reset(0)
    task.step(50)
    assert math.dist(task.state().position["red_block"], start.position["red_block"]) > 0.01


def test_placing_only_some_blocks_is_an_error() -> None:
    class Partial(RedOnYellow):
        def _on_reset(self) -> None:
            self.place("red_block", (0.5, 0.0, LOW))

    with pytest.raises(ValueError, match="yellow_block"):
        Partial().reset(0)


def test_an_unknown_block_is_an_error_that_names_the_known_ones() -> None:
    class Wrong(RedOnYellow):
        def _on_reset(self) -> None:
            self.scatter("green_block")

    with pytest.raises(ValueError, match="red_block, yellow_block"):
        Wrong().reset(0)


def test_a_condition_on_an_unknown_block_is_an_error_that_names_the_known_ones() -> None:
    class Wrong(RedOnYellow):
        def _success(self) -> Verdict:
            return self.on("green_block", "yellow_block")

    with pytest.raises(ValueError, match="'green_block'; it has red_block, yellow_block"):
        Wrong().reset(0)


def test_a_patch_needs_a_position() -> None:
    class Nowhere(RedOnYellow):
        def _initialize_env(self) -> None:
            self.add(GoalPatch(name="patch", color="red"))

    with pytest.raises(ValueError, match="no position"):
        Nowhere()


def test_a_heap_is_the_start_of_an_episode_at_rest() -> None:
    task = Heaped()
    start = task.reset(2)
    assert not task.judge().success
    task.step(20)
    for name, place in start.position.items():
        assert task.state().position[name] == pytest.approx(place, abs=1e-3)


SCRIPT = """
from tests.env.sample_tasks import Heaped, RedOnYellow
from rpg.env.gripper import FloatingGripper
import hashlib
digest = hashlib.sha256()
for task in (RedOnYellow(), Heaped(), RedOnYellow(FloatingGripper())):
    for seed in range(3):
        task.reset(seed)
        task.step(5)
        digest.update(repr(sorted(task.state().position.items())).encode())
print(digest.hexdigest())
"""


def test_the_same_seed_gives_the_same_bits_in_fresh_processes() -> None:
    digests = set()
    for hash_seed in ("1", "2"):
        environment = {**os.environ, "PYTHONHASHSEED": hash_seed, "MUJOCO_GL": "disable"}
        run = subprocess.run(
            [sys.executable, "-c", SCRIPT], capture_output=True, text=True, env=environment, check=True
        )
        digests.add(run.stdout)
    assert len(digests) == 1


def test_the_robot_does_not_change_the_start() -> None:
    from rpg.env.gripper import FloatingGripper

    assert Heaped().reset(1).position == Heaped(FloatingGripper()).reset(1).position
