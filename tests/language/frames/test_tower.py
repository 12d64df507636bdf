"""A tower told part by part, in whatever order and syntax."""

from __future__ import annotations

import pytest

from tests.language.frames.told import told

THREE = "Build a tower from 1 orange block and 1 brown block and 1 cyan block."


@pytest.mark.parametrize(
    ("text", "plain"),
    [
        (
            "I want the tower with orange block in the middle, one brown block is under it and one cyan block is "
            "over it.",
            f"{THREE} The orange block is in the middle. The brown block is at the bottom. The cyan block is at the "
            f"top.",
        ),
        (
            "tower: bottom: red, top: blue",
            "Build a tower from 1 red block and 1 blue block. The red block is at the bottom. The blue block is at "
            "the top.",
        ),
        ("tower of 3 green cubes", "Build a tower from 3 green blocks."),
        ("Green cubes, a stack, four high.", "Build a tower from 4 green blocks."),
        (
            "make a stack, alternating black and white, 6 blocks tall, with black at the bottom",
            "Build a tower of alternating colors from 3 black blocks and 3 white blocks. A black block is at the "
            "bottom.",
        ),
        (
            "On the blue mat a tower, bottom to top red, green, green",
            "Build a tower from 1 red block and 2 green blocks, from bottom to top: red, green, green. "
            "The tower is on the blue mat.",
        ),
        (
            "a tower of 5 blocks, each one a different colour",
            "Build a tower from 5 blocks, each a different color.",
        ),
        (
            "From two pink and one white block make tower, white is lowest",
            "Build a tower from 2 pink blocks and 1 white block. The white block is at the bottom.",
        ),
    ],
)
def test_parts_are_put_together(text: str, plain: str) -> None:
    assert told(text) == plain


@pytest.mark.parametrize(
    "text",
    [
        "a tower of four blocks, blue with a red one on top",  # is the red one among the four?
        "a tower of two green and two pink blocks with green on top",  # both, or one?
        "a tower of three red and two blue blocks, four high",
        "a tower of red and blue blocks, five high",
        "two red blocks and a tower of two blue blocks between them",
        "a tower with red, green, blue and yellow, red at the bottom",  # is the list the order?
        "The tower has red at the bottom and blue on top",  # now, or in the end?
        "stack red and blue, and green and yellow",
        "a red blue tower of four blocks",
        "a tower of three blocks, none of them red",
        "a tower of red, or of blue, three high",
        "a tower of three red blocks, one on the blue mat and one on the green mat",
        "a tower of two red blocks with the red one at the bottom",
        "build a tower of red and blue. blue is under it",
    ],
)
def test_what_is_not_clear_is_not_told(text: str) -> None:
    assert told(text) is None
