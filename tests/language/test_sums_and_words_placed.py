"""Digits that are told as a calculation wherever a thing may stand, gaps in a word or a line, and two words on the
two sides."""

from __future__ import annotations

import pytest

from tests.language.meaning import code_of, means


@pytest.mark.parametrize(
    ("text", "end"),
    [
        ("Put the sum of 2 and 3 on the red block.", "The 5 block must be on the red block."),
        ("Put a number block that is the sum of 2 and 3 to the right of the equals sign.",
         "The 5 block must be to the right of the = block."),
        ("The difference between 9 and 4 is on the red patch.", "The 5 block must be on the red patch."),
        ("Put a digit equal to 7 minus 4 on the blue block.", "The 3 block must be on the blue block."),
    ],
)  # fmt: skip
def test_a_digit_is_told_as_a_calculation(text: str, end: str) -> None:
    assert means(text).replace("\n", " ").endswith(end)


@pytest.mark.parametrize("text", ["Put the sum of 7 and 8 on the patch.", "Write the sum of 2 and 3."])
def test_what_is_no_digit_or_no_place_is_no_cube(text: str) -> None:
    assert code_of(text) == "false-equation"


def test_gaps_in_a_word_or_a_line() -> None:
    told = means("Spell CAT with a gap between the letters.")
    assert "must spell the word CAT" in told
    assert told.endswith("The A block must not touch the T block.")
    assert "must not touch" in means("Put two red blocks and a blue one in a row, leaving some space between them.")
    assert "evenly spaced" in means("Spell CAT with equal gaps between the letters.")
    assert code_of("Two rows of three with a gap between them.") == "misplaced-word"


def test_words_on_two_sides() -> None:
    told = means("Write ON on the left side of the table and OFF on the right side.")
    assert "must be in the left half of the table" in told
    assert "must be in the right half of the table" in told
    assert means("Write HI on the left and YO on the right.").endswith(
        "The blocks H and I must be to the left of the blocks Y and O."
    )
    assert code_of("Spell CAT. Spell DOG on the right.") == "ambiguous"


def test_a_sign_by_its_bare_name_is_no_figure() -> None:
    assert means("Put the plus between 2 and 3.").endswith("The + block must be between the 2 block and the 3 block.")
    assert "form a plus sign" in means("Make a plus of 5 red blocks.")


@pytest.mark.parametrize(
    "text", ["Spell CAT with DOG underneath, as two rows.", "Write CAT in one row and DOG in the row below."]
)
def test_the_row_below_is_nearer(text: str) -> None:
    assert means(text) == means("Write CAT in the far row and DOG in the near row.")
