"""Texts that are set in another way than sentences mean what the sentences mean; what is told besides is not lost."""

from __future__ import annotations

import pytest

from rpg.passes.schema.ambiguity import same
from rpg.passes.schema.frontend import BuiltinFrontEnd

SET = [
    ("GIVEN a tower of three red blocks WHEN the episode ends THEN all red blocks are on the table",
     "At the start there is a tower of three red blocks. All red blocks must be on the table."),
    ("Given the red block is on the blue block, when the robot finishes, then the blue block is on the red block.",
     "At the start the red block is on the blue block. The blue block must be on the red block."),
    ("The tower (four brown blocks) should be behind the row (three red blocks).",
     "The tower of four brown blocks should be behind the row of three red blocks."),
    ("Sort by colour. Reds to the red zone, blues to the blue zone. Two of each.",
     "Put the two red blocks on the red zone and the two blue blocks on the blue zone."),
    ("Get me a wall going, four bricks long and three high, all red.",
     "Build a wall four blocks wide and three blocks high from twelve red blocks."),
    ("Build a ring of eight blocks, four cyan and four pink, with the two colours alternating all the way around.",
     "Build a circle of four cyan and four pink blocks with alternating colors."),
    ("There should be two towers of three, one all red and one all blue.",
     "A tower of three red blocks and a tower of three blue blocks."),
]  # fmt: skip
REFUSED = [
    "Given red is on blue, when blue is on green, then red is on the mat.",
    "Sort by colour. Three red, three blue. When is it done?",
]


@pytest.mark.parametrize(("said", "plainly"), SET)
def test_means_the_same(said: str, plainly: str) -> None:
    task, _ = BuiltinFrontEnd().read(said)
    expected, _ = BuiltinFrontEnd().read(plainly)
    assert task is not None and expected is not None and same(task, expected)


@pytest.mark.parametrize("said", REFUSED)
def test_is_not_guessed(said: str) -> None:
    assert BuiltinFrontEnd().read(said)[0] is None
