"""What is at one place of each of several towers or rows of which no other look is told."""

from __future__ import annotations

import pytest

from tests.language.meaning import code_of, means

_TOPS = "must form a tower of exactly three from bottom to top in the order two blue blocks, "


@pytest.mark.parametrize(
    "text",
    [
        "Build two towers of three blocks, each with a red block on top.",
        "Build two towers of three blocks. The top block of each tower is red.",
        "Two stacks of three with red tops.",
        "I want two towers of three blocks, each of the two towers ends in a red block.",
    ],
)
def test_each_of_them_has_a_red_top(text: str) -> None:
    told = means(text)
    assert "There are two red blocks and four blue blocks." in told
    assert _TOPS + "then a red block." in told


def test_the_bottom_and_the_middle_and_the_ends_of_rows() -> None:
    assert "in the order a red block, then two blue blocks" in means("Two towers of three. Both have a red base.")
    assert "in the order red, yellow, red" in means("Two stacks of three, each with a yellow block in the middle.")
    told = means("Build two rows of three blocks. The first block of each row is red.")
    assert told.count("in a row from left to right in the order a red block, then two blue blocks") == 2


def test_towers_side_by_side() -> None:
    told = means("Two towers of three blocks, each with a green block on top, side by side.")
    assert "There are two green blocks and four red blocks." in told
    assert "The tower of green block 1, red block 1 and red block 2 must be next to the tower of green block 2" in told


def test_one_and_the_other() -> None:
    told = means("Two towers of two; the bottom block of one is red, the bottom block of the other is blue.")
    assert "in the order red, green" in told
    assert "in the order blue, green" in told
    told = means("Build two towers of three blocks. The left tower has a red top, the right tower a blue top.")
    assert "must be to the left of the tower of the blue block, " in told


def test_of_blocks_of_a_told_look_it_is_one_more() -> None:
    told = means("Build two towers of two blue blocks, each with a red block on top.")
    assert "A red block must be on the tower of blue block 1 and blue block 2." in told


@pytest.mark.parametrize(
    "text",
    [
        "Build two towers of three blocks. Every tower has a red block on top.",  # one of the three, or one more
        "Build two towers of four blocks, each with a red block in the middle.",
        "Build two towers of three blocks, each with a red block on top, on the patch.",
    ],
)
def test_what_is_left_open_is_asked(text: str) -> None:
    assert code_of(text)
