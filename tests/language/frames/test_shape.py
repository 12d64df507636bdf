"""A flat figure told part by part, in whatever order and syntax."""

from __future__ import annotations

import pytest

from tests.language.frames.told import told


@pytest.mark.parametrize(
    ("text", "plain"),
    [
        (
            "plus sign: center brown, the other four pink",
            "Build a plus from 4 pink blocks and 1 brown block. The center is brown.",
        ),
        (
            "One cyan block lies in the middle and on each of its four sides lies a white block, which makes a cross.",
            "Build a plus from 1 cyan block and 4 white blocks. The center is cyan.",
        ),
        (
            "Cross of 9 black blocks, each arm two blocks long, in the left half of the table.",
            "Build a plus with each arm of 2 blocks from 9 black blocks. The plus is in the left half of the table.",
        ),
        (
            "We want eight blocks lying in a circle, four of them white and four of them black, alternating.",
            "Build a circle of alternating colors from 4 white blocks and 4 black blocks.",
        ),
        (
            "Eight brown cubes should encircle one purple cube.",
            "Build a circle from 8 brown blocks. A purple block is in the middle of the circle.",
        ),
        (
            "L shape: long arm four cubes, short arm two, shared corner, five blue cubes.",
            "Build an L with a long arm of 4 blocks and a short arm of 2 blocks from 5 blue blocks.",
        ),
        (
            "letter L, 5 gray, foot must go to left",
            "Build an L from 5 gray blocks with its foot to the left.",
        ),
        (
            "T with red bar of three blocks and blue stem of two blocks",
            "Build a T with a bar of 3 blocks and a stem of 2 blocks from 3 red blocks and 2 blue blocks. The bar is "
            "red.",
        ),
        (
            "Use five orange cubes for a T, the leg of which points away from the robot.",
            "Build a T from 5 orange blocks with its stem to the back.",
        ),
        (
            "make a V out of seven blue cubes that opens to the back",
            "Build a V from 7 blue blocks with its opening to the back.",
        ),
        (
            "U, seven yellow, each leg three counting the corner",
            "Build a U, 3 blocks wide and 3 blocks deep, from 7 yellow blocks.",
        ),
        (
            "Make just the outline of a square, three red blocks along each side, nothing in the middle.",
            "Build a hollow 3x3 square from 8 red blocks.",
        ),
        (
            "Make a 3 by 3 square: green in the middle, white at the corners, red on the sides.",
            "Build a filled 3x3 square from 9 blocks. The center is green. The corners are white. The rest are red.",
        ),
        (
            "hollow rectangle, long sides 4 blocks, short sides 3 blocks, ten green blocks",
            "Build a hollow rectangle, 4 blocks long and 3 blocks wide, from 10 green blocks.",
        ),
        (
            "A filled triangle of brown cubes, three cubes along the base, then two, then one.",
            "Build a filled triangle with 3 blocks per side from 6 brown blocks.",
        ),
        (
            "Circle on the green mat, six blue blocks",
            "Build a circle from 6 blue blocks. The circle is on the green mat.",
        ),
    ],
)
def test_parts_are_put_together(text: str, plain: str) -> None:
    assert told(text) == plain


@pytest.mark.parametrize(
    "text",
    [
        "a plus or a circle from five green blocks",
        "a circle of eight blocks, none red",
        "a plus of five red blocks but not with a blue center",
        "a plus of five red blocks and a circle of eight blue blocks",
        "two plus shapes, each of five red blocks",
        "The circle of eight red blocks is on the left",  # now, or in the end?
        "an L of five red blocks, and a blue block at its corner",  # is it among the five?
        "an L of green blocks whose foot points to the right and has three blocks",
        "a T with a bar of three and a stem of two from six red blocks",
        "square of seven red blocks, 3 per side",
        "a U of seven blocks open to the left or to the right",
        "a triangle of six blocks, two corners red",  # which two?
        "two white blocks and a circle of red ones",
        "eight red blocks surround two blue ones in a ring",  # there is room for one
        "a circle of eight red blocks with blue blocks in the middle",
        "a square of eight red blocks, one of them blue",
        "a T of five blocks with a red bar",  # how does the stem look?
        "by the red block, a circle of eight blue ones",
        "a circle of eight red blocks, and nothing in it but a blue block",
        "an L, three blocks one way and two the other",  # is the corner one of both?
    ],
)
def test_what_is_not_clear_is_not_told(text: str) -> None:
    assert told(text) is None
