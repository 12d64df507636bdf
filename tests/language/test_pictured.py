"""What people say around what they tell of a picture: it is read as the same text without it, or in plain words."""

from __future__ import annotations

import pytest

from rpg.passes.schema.ambiguity import same
from rpg.passes.schema.frontend import BuiltinFrontEnd

THE_SAME = [
    ("could you build it like the photo? its a stack of three, red at the bottom, then blue, then red again on top",
     "a stack of three, red at the bottom, then blue, then red on top"),
    ("Put a pink block on a gray one like in my drawing.", "Put a pink block on a gray one."),
    ("a pyramid like the one i see: 3 blocks at the bottom, then 2, then 1 at the top. all of them green",
     "a green pyramid with 3 blocks at the bottom, then 2, then 1 at the top"),
    ("one wall of 6 gray blocks, three wide. nothing else is there", "a wall of 6 gray blocks, three wide"),
    ("build a staircase of three steps. use whatever cubes you like", "build a staircase of three steps"),
    ("Use any blocks. Make a row of four.", "Make a row of four blocks."),
    ("a row of a red, a black and a pink block, and between neighbors there is a gap as wide as one cube",
     "a row of a red, a black and a pink block with a gap of one block between neighbors"),
    ("three cyan blocks in a row. the gap between them is as big as a block",
     "three cyan blocks in a row with a gap of one block between them"),
    ("the red block is'nt on the table. its on the white block",
     "the red block is not on the table. it is on the white block"),
    ("i want to be able to read the word LAMP on the table", "spell LAMP"),
    ("two black blocks side by side and one white block on top resting on both of them, like a small roof",
     "two black blocks side by side and one white block on top resting on both of them"),
    ("make me a frame like around a picture. 12 brown blocks in a square", "12 brown blocks in a square"),
]  # fmt: skip
OTHERWISE = [
    ("There is a blue patch with a red block on it. There is also a green block. Nothing else is there.",
     "There is a blue patch with a red block on it. There is also a green block."),
    ("Put the red block on the blue one, then again on the green one.",
     "Put the red block on the blue one, then on the green one."),
]  # fmt: skip
"""Here the words tell something."""


@pytest.mark.parametrize(("said", "plainly"), THE_SAME)
def test_the_same(said: str, plainly: str) -> None:
    task, notes = BuiltinFrontEnd().read(said)
    expected, _ = BuiltinFrontEnd().read(plainly)
    assert task is not None, notes
    assert expected is not None and same(task, expected)


@pytest.mark.parametrize(("said", "plainly"), OTHERWISE)
def test_otherwise(said: str, plainly: str) -> None:
    task, _ = BuiltinFrontEnd().read(said)
    other, _ = BuiltinFrontEnd().read(plainly)
    assert task is None or other is None or not same(task, other)
