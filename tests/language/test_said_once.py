"""What is said once of two things: both ends of a row, "a blue one of three", what lies in between."""

from __future__ import annotations

import pytest

from tests.language.meaning import code_of, means


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ("Put a white block on the left and on the right end of a row of two red blocks.",
         "in a row in the order a white block, then the two red blocks, then a white block"),
        ("Lay a red block at the back and one at the front end of a column of three white blocks.",
         "in the order a red block, then the three white blocks, then a red block"),
        ("Put a white block at the beginning and at the end of a line of two red blocks.",
         "in a line in the order a white block, then the two red blocks, then a white block"),
        ("Put a white block on the bottom and on the top of a stack of two black blocks.",
         "stacked from bottom to top in the order a white block, then the two black blocks, then a white block"),
    ],
)  # fmt: skip
def test_both_ends(text: str, told: str) -> None:
    assert told in means(text)


def test_what_is_beside_a_row_is_at_no_end_of_it() -> None:
    assert "must be to the left of the two red blocks" in means(
        "Lay a green block to the left and to the right of a row of two red blocks."
    )
    assert "There are a green block and two red blocks" in means(
        "Put a green block on the left end of a row of two red blocks."
    )


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ("A yellow tower of three behind a white one of two.", "The two white blocks must form a tower of"),
        ("Build a column of three red blocks, and to its right a white one of two.",
         "The two white blocks must be in a column"),
        ("On the red mat is a green row of two, on the green mat is a white one of three.",
         "The three white blocks must be in a row"),
    ],
)  # fmt: skip
def test_one_of_so_many_is_a_structure(text: str, told: str) -> None:
    assert told in means(text)


def test_one_of_those_there_are() -> None:
    assert "Exactly one of the three red blocks must be on" in means(
        "There are three red blocks. Put a red one of the three on the mat."
    )


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ("White on the left, black on the right, in between two red blocks.",
         "A red block must be between the white block and the black block."),
        ("On the red mat lies a blue block, on the green mat lies a white block, and in between two yellow ones.",
         "A yellow block must be between the blue block and the white block."),
        ("Put a black tower of two on the red mat, a white tower of two on the green mat and in between a row of three "
         "blue blocks.", "The three blue blocks must be between the tower of the two black blocks and the tower of"),
    ],
)  # fmt: skip
def test_in_between(text: str, told: str) -> None:
    assert told in means(text)


def test_between_two_ones() -> None:
    assert "The red block must be between the two green blocks." in means(
        "Put the red block on the mat, in between two green blocks."
    )
    assert "in a row with the red block at the left end and the blue block at the right end" in means(
        "Make a row: a red block first, a blue block last, and in between two green blocks."
    )
    assert code_of("First a white block, then a black block, in between two red ones.") == "ambiguous"


def test_one_beside_a_tower() -> None:
    assert code_of("Put a green tower of two on the green mat and a white one on the white mat.") == "ambiguous"
    assert "The white block must be on the white patch." in means(
        "Put a green block on the green mat and a white one on the white mat."
    )
