"""A task's code tells the goal that it was lowered from."""

from __future__ import annotations

from random import Random

import pytest

from rpg.blocks.evaluate import evaluate
from rpg.blocks.verdict import Verdict
from rpg.env import BlockTask
from rpg.env.told import Asked, Told
from rpg.ir import goal as g
from rpg.ir.assets import ColoredCube
from tests.blocks.random_goals import random_state, random_world
from tests.env.test_namings import random_goal, task_of


@pytest.mark.parametrize("seed", range(40))
def test_what_is_told_holds_where_the_goal_does(seed: int) -> None:
    rng = Random(seed)
    world = random_world(rng)
    goal = random_goal(world, rng)
    task = task_of(goal, world)
    start = random_state(world, rng)
    task.judge_states([start])
    told, _ = task._answer(Asked.TOLD)
    assert isinstance(told, Told)
    for state in (random_state(world, rng).since(start) for _ in range(6)):
        assert evaluate(told.goal, state).value == evaluate(goal, state).value


def test_counts_are_told_as_counts() -> None:
    class Counting(BlockTask):
        def _initialize_env(self) -> None:
            for k in range(4):
                self.add(ColoredCube(name=f"red_{k}", color="red"))

        def _success(self) -> Verdict:
            on = [self.on(f"red_{k}", "red_3") for k in range(3)]
            return self.count(on, at_least=1, at_most=2) & self.at_rest()

    task = Counting()
    task.reset(0)
    told, _ = task._answer(Asked.TOLD)
    count = g.Count(over=("red_0", "red_1", "red_2"), at_least=1, at_most=2, goal=g.On(a="each", b="red_3"))
    assert isinstance(told, Told)
    assert told.goal == g.All(goals=(count, g.All(goals=())))


def test_code_that_looks_at_verdicts_tells_nothing() -> None:
    class Looking(BlockTask):
        def _initialize_env(self) -> None:
            self.add(ColoredCube(name="red", color="red"))
            self.add(ColoredCube(name="blue", color="blue"))

        def _success(self) -> Verdict:
            return self.stayed("red") if self.on("red", "blue") else self.on("blue", "red")

    task = Looking()
    task.reset(0)
    assert task._answer(Asked.TOLD)[0] is None
