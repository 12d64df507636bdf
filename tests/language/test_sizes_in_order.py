"""Blocks in the order of their sizes, sizes that share a noun, and places in lines of which no more is said than how
many blocks they have."""

from __future__ import annotations

import pytest

from tests.language.meaning import code_of, means

BLUE = (
    "There are a 3 cm blue block, a blue block and a 5 cm blue block. The 3 cm blue block, the blue block and the 5 cm "
    "blue block must be in a row from left to right by increasing size."
)


@pytest.mark.parametrize(
    "text",
    [
        "Order the blocks by size: a small, a normal and a large blue one.",
        "Order the blocks by size: small, medium and large blue block.",
        "Arrange a small, a normal and a large blue block in ascending order of size from left to right.",
        "The blocks should get bigger from left to right: small, normal and large blue block.",
        "Make a row where every block is bigger than the one before: a small, a normal and a large blue one.",
    ],
)
def test_what_is_said_behind_the_last_size_is_said_of_all(text: str) -> None:
    assert means(text).replace("\n", " ") == BLUE


def test_sizes_that_share_no_noun() -> None:
    assert "3 cm blue block" in means("Put a small one and a large red one in a row.")
    assert "3 cm green block and a 5 cm red block" in means("Put a small green and a large red one in a row.")
    told = means("Sort three blocks by size in descending order.")
    assert "from left to right by decreasing size" in told


def test_one_place_of_a_line_that_has_so_many_blocks() -> None:
    told = means("A row of three blocks, the middle one green.")
    assert told.endswith("must be in a row in the order red, green, blue in either direction.")
    for text in (
        "The green block is in the centre of the row of three.",
        "In a row of three, green is in the middle.",
        "Center the green block in a row of three.",
    ):
        assert means(text) == told
    assert "exactly three with the red block at the bottom" in means("Red is at the bottom of a tower of three.")
    assert "must be on the tower of" in means("The red block is on top of a tower of three.")
    assert code_of("The green block is in the middle of a row of four.") == "count-mismatch"
    assert code_of("Put the red block in a row of three.") == "count-mismatch"


def test_both_sides_of_the_middle_are_all_the_others() -> None:
    told = means("A row of five with green in the middle and red on both sides.")
    assert told.endswith("in the order two red blocks, then the green block, then two red blocks.")
    assert code_of("A row of four with green in the middle and red on both sides.") == "count-mismatch"
    assert code_of("A row of five with a green block in the middle and a red block on either side.") == "count-mismatch"


def test_what_cannot_be_its_own_mirror_image() -> None:
    assert code_of("A palindrome row with red, blue and green.") == "contradiction"
    assert "mirrored" in means("A symmetric row of two red, two blue and one green block.")


@pytest.mark.parametrize(
    "text",
    [
        "Vowels first, then the consonants: A, B, E, C.",
        "Vowels before consonants: A, B, E, C.",
        "Put the vowels before the consonants in a row: A, B, E, C.",
    ],
)
def test_which_sort_comes_first_and_then_the_symbols(text: str) -> None:
    assert means(text) == means("A row of A, B, E and C, vowels first.")


def test_symbols_behind_the_sorts_stand_in_one_row() -> None:
    assert means("Even numbers before odd numbers, 1 to 4.") == means("A row of 1 to 4, even numbers first.")
    told = means("In a row, vowels left of consonants: A, B, E, C.")
    assert "The blocks A, B, E and C must be in a row." in told
    assert "to the left of the blocks B and C" in told
