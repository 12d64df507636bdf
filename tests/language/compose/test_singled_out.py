"""Some of several, singled out by where they are, by what they are worth, or by what is said behind."""

from __future__ import annotations

import pytest

from tests.language.compose.test_meanings import told
from tests.language.meaning import code_of

MEANINGS = {
    "Exactly one of the blocks 4, 5 and 6 must be on the black one, and it must not be the 5.": (
        "The 5 block must not be on the black block Either the 6 block must not be on the black block and the 4 "
        "block must be on the black block, or the 4 block must not be on the black block and the 6 block must be "
        "on the black block."
    ),
    "Stand the blue block to the left of the green one, and lay the red block on the right-hand one of the two.": (
        "The blue block must be to the left of the green block The red block must be on the green block."
    ),
    "Both A and B go left of the green block, C goes right of it, and D goes on it.": (
        "The A block and the B block must be to the left of the green block The C block must be to the right of "
        "the green block The D block must be on the green block."
    ),
    "Of the cubes numbered 1 to 6, put the three lowest numbers on the blue mat and the rest on the orange mat.": (
        "The 1 block, the 2 block and the 3 block must be on the blue patch The 4 block, the 5 block and the 6 "
        "block must be on the orange patch."
    ),
    "Make three separate two-high stacks of purple blocks, and cap all but one of them with a yellow block.": (
        "Purple block 1 and purple block 2 must be stacked Purple block 3 and purple block 4 must be stacked "
        "Purple block 5 and purple block 6 must form a tower of exactly two Yellow block 1 must be on the tower "
        "of purple block 1 and purple block 2 Yellow block 2 must be on the tower of purple block 3 and purple "
        "block 4."
    ),
    "Make a row of three yellow blocks and put a green block on each of them except the leftmost.": (
        "Yellow block 1, yellow block 2 and yellow block 3 must be in a row from left to right in the order "
        "yellow block 1, yellow block 2, yellow block 3 Green block 1 must be on yellow block 2 Green block 2 "
        "must be on yellow block 3."
    ),
    "Place exactly two of the letters P, Q and R on the gray patch, but not both P and Q.": (
        "Either the Q block and the R block must be on the gray patch and the P block must not be on the gray "
        "patch, or the P block and the R block must be on the gray patch and the Q block must not be on the gray "
        "patch."
    ),
    "Keep the blue block where it is and bring the red and green blocks over so that both are next to it.": (
        "The blue block must stay where it is The red block and the green block must be next to the blue block."
    ),
    "Put a blue block on the leftmost block of the back row of a 2x3 grid of red blocks.": (
        "Red block 1, red block 2, red block 3, red block 4, red block 5 and red block 6 must form a grid of two "
        "rows and three columns row by row in the order red block 1, red block 2, red block 3, red block 4, red "
        "block 5, red block 6 The blue block must be on red block 1."
    ),
    "Two white towers, each two blocks high, and a single brown block to the left of both towers.": (
        "White block 1 and white block 2 must form a tower of exactly two White block 3 and white block 4 must "
        "form a tower of exactly two The brown block must be to the left of the tower of white block 1 and white "
        "block 2 The brown block must be to the left of the tower of white block 3 and white block 4."
    ),
    "Build two green stacks, one two high and the other three high, and put a yellow block on the lower of the two.": (
        "Green block 1 and green block 2 must be stacked Green block 3, green block 4 and green block 5 must form a "
        "tower of exactly three The yellow block must be on the tower of green block 1 and green block 2."
    ),
    "Of four white blocks one lies on the red block and the others form a tower.": (
        "White block 2, white block 3 and white block 4 must form a tower of exactly three White block 1 must be on "
        "the red block."
    ),
}


@pytest.mark.parametrize("text", MEANINGS)
def test_told_again(text: str) -> None:
    assert told(text) == [MEANINGS[text]]


@pytest.mark.parametrize(
    "text",
    [
        "Put A left of B and C on it.",  # on which one
        "Build a tower of red on blue. Left of it stands a green block, and on it a yellow one.",  # on which one
        "There are a red and a blue block. One of the blocks is on the patch and it is red.",  # the block, or the patch
        "Arrange the letters from A to D in a row.",  # in this order, or in any
        "Put A or B on the red block, but not C.",  # C was none of those
        "Two red blocks are on the mat. The blue block is not on either of them.",  # on none of them, or not on one
        "Put A next to B. Put C on the left one of the two.",  # which one is on the left
    ],
)
def test_not_told_again(text: str) -> None:
    assert told(text) == []


def test_what_is_on_top_of_a_tower_is_one_of_its_blocks() -> None:
    assert code_of("Build a tower of four red blocks, the one on top being blue.") == "contradiction"
