"""Figures put together of parts: a frame around a rectangle, squares on top of each other, limbs that are joined."""

from __future__ import annotations

import pytest

from tests.language.frames.told import told
from tests.language.meaning import code_of, means

_FRAMED = (
    "black, black, black, black, black, white, white, black, black, white, white, black, black, black, black, black"
)


@pytest.mark.parametrize(
    "text",
    [
        "Make a frame of twelve black cubes around a 2x2 block of white cubes.",
        "A 2x2 block of white cubes surrounded by a frame of twelve black cubes.",
        "Surround a 2x2 square of white cubes with twelve black ones.",
        "Twelve black blocks surround a 2x2 square of four white blocks.",
    ],
)
def test_a_frame_around_a_rectangle_is_the_border_of_a_larger_one(text: str) -> None:
    assert told(text) == f"Build a grid of 4 rows and 4 columns, in reading order: {_FRAMED}."


@pytest.mark.parametrize(
    "text",
    [
        "A frame of ten black cubes around a 2x2 block of white cubes.",
        "Twelve black cubes around a 3x2 block of white cubes.",
        "A frame of twelve black cubes around a 2x2 block of five white cubes.",
    ],
)
def test_a_frame_that_does_not_fit_is_none(text: str) -> None:
    assert told(text) is None


def test_squares_on_top_of_each_other_are_a_pyramid() -> None:
    plain = "Build a pyramid with a 3x3 base, layers from bottom to top: blue, green, red."
    assert told("A square of 3x3 blue cubes, a 2x2 square of green cubes on top of it, and a red one on that.") == plain
    assert told("A 3x3 layer of nine blue cubes, on it a 2x2 layer of green cubes, on top a red cube.") == plain
    assert told("A 3x3 square of blue cubes with a 2x2 square of green cubes on top of it.") is None
    assert told("A 3x3 square of blue cubes, a 2x2 square of green cubes next to it, and a red one.") is None


@pytest.mark.parametrize(
    ("text", "plain"),
    [
        (
            "A U: two arms of three cubes each and a base of one cube joining them.",
            "Build a U, 3 blocks wide and 3 blocks deep, from 7 blocks.",
        ),
        (
            "A U of nine cubes: three on each side and a base of three connecting the two sides.",
            "Build a U, 5 blocks wide and 3 blocks deep, from 9 blocks.",
        ),
        ("A U of eight cubes: three on each side and one to close the bottom.", None),
        ("A U: its two legs are three cubes long, with a base of three cubes joining them.", None),
        (
            "A letter L made of five cubes: a vertical stroke of three cubes and a foot of two more to the right.",
            "Build an L with each arm of 3 blocks from 5 blocks with its foot to the right.",
        ),
        (
            "An L shape, three blocks up and three across, where the stroke and the foot share the corner cube.",
            "Build an L with each arm of 3 blocks from 5 blocks.",
        ),
        ("An L shape, three blocks up and three across.", None),
        (
            "A T of seven blocks: the bar along the top has five and the stem hangs down from its middle with two.",
            "Build a T with a bar of 5 blocks and a stem of 2 blocks from 7 blocks with its stem to the front.",
        ),
        (
            "A filled triangle: three blocks in the back row, two in front of them and one at the tip.",
            "Build a filled triangle with 3 blocks per side from 6 blocks with its tip to the front.",
        ),
        ("A filled triangle: three blocks in the back row, two in front of them.", None),
    ],
)
def test_limbs_and_rows_of_flat_figures(text: str, plain: str | None) -> None:
    assert told(text) == plain


def test_a_row_on_a_row() -> None:
    assert means("A row of two red cubes with a row of two blue cubes stacked on top of it.").endswith(
        "Blue block 1 must be on red block 1. Blue block 2 must be on red block 2."
    )
    assert code_of("A row of three red cubes with a row of two blue cubes stacked on top of it.")


def test_rows_behind_each_other() -> None:
    rows = "The three red blocks must be in front of the three white blocks. The three white blocks must be in front of"
    text = "Three rows of three: red ones in front, white ones behind them, blue ones at the very back."
    assert f"{rows} the three blue blocks." in means(text).replace("\n", " ")
    text = "Put nine blocks in three rows of three, red in the front row, white in the middle row and blue in the back "
    text += "row."
    assert f"{rows} the three blue blocks." in means(text).replace("\n", " ")


@pytest.mark.parametrize(
    ("text", "plain"),
    [
        ("A T with a red bar and a blue stem.", "Build a T. The bar is red. The stem is blue."),
        (
            "A plus with a red center and blue arms, each arm being two blocks.",
            "Build a plus with each arm of 2 blocks from 1 red block and 8 blue blocks. The center is red.",
        ),
        (
            "Blocks in rows: one in the front row, two in the second row and three in the third, as a triangle.",
            "Build a filled triangle with 3 blocks per side from 6 blocks with its tip to the front.",
        ),
        (
            "The viewer should be able to read a capital L: three cubes vertical and one more for the foot.",
            "Build an L with a long arm of 3 blocks and a short arm of 2 blocks from 4 blocks with its "
            "foot to the right.",
        ),
        (
            "A checkered wall, four wide and two high, in red and white.",
            "Build a wall 4 blocks wide and 2 blocks high of red and white blocks in a checkerboard pattern.",
        ),
        (
            "A pyramid which has three cubes as the ground row and gets one cube narrower with each row.",
            "Build a pyramid with a base of 3 blocks from 6 blocks.",
        ),
        (
            "A pyramid: four blocks in a square on the bottom and one block on top, the bottom blue and the top white.",
            "Build a pyramid with a 2x2 base, layers from bottom to top: blue, white.",
        ),
        (
            "In a 3x3 grid, place X in the middle and O in the other eight places.",
            "Build a grid of 3 rows and 3 columns in the order O, O, O, O, X, O, O, O, O.",
        ),
        ("In a 3x3 grid, place X in the middle and O in the other seven places.", None),
    ],
)
def test_parts_in_other_words(text: str, plain: str | None) -> None:
    assert told(text) == plain


def test_a_square_ring_is_no_circle() -> None:
    assert "outline of a square" in means("A square ring of sixteen gray blocks on the red mat.")
    assert code_of("A square ring of nine blocks.")
