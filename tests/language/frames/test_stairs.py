"""A staircase told part by part, in whatever order and syntax."""

from __future__ import annotations

import pytest

from tests.language.frames.told import told


@pytest.mark.parametrize(
    ("text", "plain"),
    [
        (
            "Staircase, 3 steps, six green cubes, rising to the right.",
            "Build a staircase of 3 steps from 6 green blocks rising to the right.",
        ),
        (
            "A flight of stairs made of ten white blocks, its highest column four blocks high.",
            "Build a staircase of 4 steps from 10 white blocks.",
        ),
        (
            "Build a staircase of three steps from six brown cubes. It descends to the right.",
            "Build a staircase of 3 steps from 6 brown blocks rising to the left.",
        ),
        (
            "stairs: one block, then two, then three, all blue",
            "Build a staircase of 3 steps from 6 blue blocks.",
        ),
        (
            "staircase, lowest step left, highest step right, three steps, white",
            "Build a staircase of 3 steps from 6 white blocks rising to the right.",
        ),
        (
            "An orange staircase, one cube high on the right and three cubes high on the left.",
            "Build a staircase from orange blocks rising to the left.",
        ),
        (
            "Staircase from right to left: 3 green, 2 blue, 1 red",
            "Build a staircase of 3 steps rising to the right. The first step is red, the second step is blue and the "
            "third step is green.",
        ),
        (
            "a staircase of six blocks, all cyan except for the top block of the highest step, which is gray",
            "Build a staircase of 3 steps from 6 blocks. The top block of the highest step is gray and the rest are "
            "cyan.",
        ),
        (
            "staircase with three steps out of six gray blocks, and put a red block on its highest step",
            "Build a staircase of 3 steps from 6 gray blocks. Put a red block on top of the staircase.",
        ),
        (
            "a staircase whose highest step is on the left and has three blocks, all white",
            "Build a staircase of 3 steps from 6 white blocks rising to the left.",
        ),
        (
            "The first step has one block, the second two, the third three: orange stairs, going up to the left, on "
            "the red mat",
            "Build a staircase of 3 steps from 6 orange blocks rising to the left. The staircase is on the red mat.",
        ),
        (
            "stairs going up to the right, 3 steps, first step green second red third blue",
            "Build a staircase of 3 steps rising to the right. The first step is green, the second step is red "
            "and the third step is blue.",
        ),
        (
            "make a stairs, the tallest column is 4 blocks and it is at the left",
            "Build a staircase of 4 steps rising to the left.",
        ),
        (
            "staircase that has one block then two blocks then three blocks and the colors go red yellow green",
            "Build a staircase of 3 steps. The first step is red, the second step is yellow and the third step "
            "is green.",
        ),
        (
            "four steps, each one block higher than the one before it, going up to the left, all white blocks",
            "Build a staircase of 4 steps from 10 white blocks rising to the left.",
        ),
        (
            "make stairs with three steps out of red (lowest), orange (middle) and yellow (highest) blocks",
            "Build a staircase of 3 steps. The lowest step is red, the middle step is orange and the highest "
            "step is yellow.",
        ),
        ("Build a flight of four steps, the lowest on the right.", "Build a staircase of 4 steps rising to the left."),
        (
            "The staircase consists of three columns with heights of one, two and three blocks from left to "
            "right, all in orange.",
            "Build a staircase of 3 steps from 6 orange blocks rising to the right.",
        ),
    ],
)
def test_parts_are_put_together(text: str, plain: str) -> None:
    assert told(text) == plain


@pytest.mark.parametrize(
    "text",
    [
        "a staircase of 4 steps and 3 layers",  # 4 or 3?
        "a staircase of three steps out of seven red blocks",
        "stairs going up to the left and then down to the right, six red blocks",
        "stairs going up to the left or the right",
        "a staircase of three steps rising to the right of the green block",
        "a staircase with steps of 1, 3 and 2 blocks",
        "stairs of heights 1, 3, 5",
        "two staircases of three steps",
        "a staircase of three steps with one red block per step",
        "a staircase rising to the left, highest step on the right, three steps",
        "a staircase of three steps from red, blue and green blocks",  # which steps?
        "three towers with heights 1, 2 and 3 from left to right",  # no stairs: they need not adjoin
        "staircase of three steps, not red",
        "a red block and a staircase of three steps",
        "a staircase of three steps, five gray blocks, with a red one on the highest step",  # is it on top of them?
        "The stairs rise to the left and have three steps",  # now, or in the end?
        "Build a staircase with four steps, each step a different color.",
        "stairs of three steps, fourth step red, the rest blue",
        "three steps of red, first step blue, lowest step white",
        "The staircase is red.",
    ],
)
def test_what_is_not_clear_is_not_told(text: str) -> None:
    assert told(text) is None
