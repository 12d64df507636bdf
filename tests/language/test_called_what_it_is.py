"""What blocks are called, or what they make up, stands for what is told of it; a shape that is not told does not."""

from __future__ import annotations

import pytest

from tests.language.meaning import code_of, means

LIGHT = "Red is on top, yellow in the middle, green at the bottom."
CALLED = (
    (f"Imagine a traffic light made of blocks. {LIGHT}", LIGHT),
    (f"Can you build a traffic light? {LIGHT}", LIGHT),
    (f"Can you build a little traffic light? {LIGHT}", LIGHT),
    ("Build a lighthouse, red at the bottom and white on top.", "red at the bottom and white on top"),
    ("Make a snowman, a tower of three white blocks.", "a tower of three white blocks"),
    ("Make a chimney, i.e. five red blocks stacked.", "five red blocks stacked"),
    ("Build a convoy of four red blocks in a row.", "Build four red blocks in a row."),
    ("I need a rack of 12 cubes, 3 rows by 4 columns.", "12 cubes, 3 rows by 4 columns"),
    ("A totem pole made of four blocks stacked on top of each other", "four blocks stacked on top of each other"),
    (
        "The green blocks are the frogs and the blue mat is the pond. Put all four frogs in the pond.",
        "Put four green blocks on the blue mat.",
    ),
    ("Four green blocks are frogs. Put the frogs on the blue mat.", "Put four green blocks on the blue mat."),
    ("Let's say the white blocks are sheep. Put three sheep on the mat.", "Put three white blocks on the mat."),
    ("The red mat is lava. Put the green block on the lava.", "Put the green block on the red mat."),
)
NOT_TOLD = (
    "Make a crescent. Red is on the left, blue on the right.",
    "Make a snowman. Put it on the mat. Red is on top, blue at the bottom.",
    "Make a lighthouse. A red block stands on the left.",
    "I want a lighthouse. A red block stands on the left.",
    "We need a lighthouse. A red block stands on the left.",
    "A lighthouse would be nice. A red block stands on the left.",
    "Build a lighthouse with a red block at the bottom. White in the middle, red on top.",
    "Build two lighthouses. Red at the bottom, white on top.",
    "Make a hat. Red on top, blue at the bottom. The hat stands on the mat.",
    "Make a snowman, a tower of three white blocks and a row of two red blocks.",
    "Do not build a lighthouse. Red on top, blue at the bottom.",
    "A crescent of three towers in a row",
    "A fan of three towers from left to right 4, 3 and 2 blocks tall",
    "A train of four red blocks on the mat",
    "A facade of 12 cubes, 3 rows by 4 columns",
    "The green blocks are the frogs. Put one frog on the blue mat.",
    "The red mat is dirty. Put the green block on the dirty one.",
)


@pytest.mark.parametrize(("text", "plain"), CALLED)
def test_a_name_stands_for_what_is_told(text: str, plain: str) -> None:
    assert means(text) == means(plain)


@pytest.mark.parametrize("text", NOT_TOLD)
def test_a_name_may_tell_more_than_is_told(text: str) -> None:
    assert code_of(text) == "unknown-word"
