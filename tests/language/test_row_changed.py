"""Rows that are there, with a block put into them or two of them swapped."""

import pytest

from tests.language.meaning import code_of, start_and_end

BEGUN = "At the start, the red, white and blue blocks are in a row from left to right in the order red, white, blue"
SWAPPED = "The five blocks must be in a row from left to right in the order 5, 2, 3, 4, 1."


@pytest.mark.parametrize(
    ("text", "order"),
    [
        ("Add a green block at the left end of the row red, white, blue.", "green, red, white, blue"),
        ("There is a row red, white, blue. Append a green block.", "red, white, blue, green"),
        (
            "Insert a green block between the white and the red one of the row red, white, blue.",
            "red, green, white, blue",
        ),
        ("There is a row red, white, blue. Insert a green block between white and blue.", "red, white, green, blue"),
    ],
)
def test_a_block_is_put_into_a_row(text: str, order: str) -> None:
    start, end = start_and_end(text)
    assert start == BEGUN
    assert end == f"The four blocks must be in a row from left to right in the order {order}."


def test_the_middle_of_a_row_of_an_even_number() -> None:
    _, end = start_and_end("Insert a red block in the middle of the row of four white ones.")
    assert end.endswith("in the order white, white, red, white, white.")
    assert code_of("There is a row A, B, C. Insert a D in the middle.") == "ambiguous"


def test_what_is_at_the_ends_is_swapped() -> None:
    for text in ("Swap the first and the last block of the row 1, 2, 3, 4, 5.",
                 "In the row 1, 2, 3, 4, 5 swap the two outer blocks."):  # fmt: skip
        assert start_and_end(text)[1] == SWAPPED
    _, end = start_and_end("There is a row A, B, C, D. Swap the two blocks in the middle.")
    assert end.endswith("in the order A, C, B, D.")


def test_no_neighbours_of_which_one_is_told_apart() -> None:
    assert code_of("There is a row red, blue, red, white. Insert a green block between red and blue.") == "ambiguous"
