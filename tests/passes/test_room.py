"""Where blocks have to stay where they start, every start leaves room for the goal."""

from __future__ import annotations

from random import Random

import pytest

from rpg.blocks.arrange import Impossible
from rpg.blocks.state import BlockState
from rpg.blocks.waypoints import waypoints
from rpg.ir.schema import TaskSchema
from rpg.passes.validate.load import load
from rpg.pipeline import CompileOptions, compile_instruction

SEEDS = 200
STAYING = (
    "Put the red block to the right of the blue block without moving the blue block",
    "Never move the black cube. Build a tower of three green cubes to the right of it.",
    "Put the red block behind the blue block without moving the blue block",
    "Put red to the left of blue and green to the right of blue. Blue stays where it is.",
    "Leave the yellow block where it is and build a row of three red blocks behind it",
    "Swap the red and the blue block, then put the green block to the left of the red block",
    "Build a row of four blocks to the left of the white block. The white block must not be moved.",
    "The black block stays where it is. Put the white block 15 cm to the left of it.",
    "The red and the blue block stay where they are. Put the green block to the right of both of them.",
    "Put the orange block at least 20 cm away from the pink block without moving the pink block",
)
"""Of the starts that are only drawn, up to a third leave no room for these goals."""


@pytest.mark.parametrize("text", STAYING)
def test_the_goal_can_be_reached_from_every_start(text: str) -> None:
    program = compile_instruction(text, CompileOptions(paraphrases=0)).program
    assert program is not None
    task = load(program.code, program.goal_code)[0]()
    for seed in range(SEEDS):
        assert _reached(program.task, task.reset(seed).since(None)), seed


def _reached(task: TaskSchema, start: BlockState) -> bool:
    """Is there a way to a goal state? Where there is little room it takes some luck to find it."""
    for luck in range(5):
        try:
            return bool(waypoints(task.goal, task.init, start.world, Random(luck), start))
        except Impossible:
            continue
    return False
