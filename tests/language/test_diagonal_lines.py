"""Lines that lie diagonally on the table."""

from __future__ import annotations

import pytest

from tests.language.meaning import code_of, means, start_and_end


@pytest.mark.parametrize(
    ("text", "meaning"),
    [
        ("A diagonal line of four red cubes running from the near left to the far right.",
         "must be in a diagonal line from the near left to the far right."),
        ("A diagonal of two red and two blue cubes from the far left to the near right, alternating, with red at the "
         "far left end.",
         "must be in a diagonal line from the far left to the near right in the order red, blue, red, blue."),
        ("Line up A, B and C diagonally.", "The blocks A, B and C must be in a diagonal line."),
        ("Four blue cubes form a diagonal.", "The four blue blocks must be in a diagonal line."),
        ("Arrange the blocks 1, 2, 3 diagonally from the near left to the far right of the table.",
         "must be in a diagonal line from the near left to the far right in the order 1, 2, 3."),
        ("Make a diagonal from the near right to the far left with red, blue and green blocks in that order.",
         "must be in a diagonal line from the near right to the far left in the order red, blue, green."),
        ("A diagonal line from near left to far right: black first, then blue, and white at the far end.",
         "must be in a diagonal line from the near left to the far right in the order black, blue, white."),
    ],
)  # fmt: skip
def test_a_diagonal_is_told_by_its_ends(text: str, meaning: str) -> None:
    assert means(text).endswith(meaning)
    assert means(means(text)) == means(text)


@pytest.mark.parametrize(
    ("text", "code"),
    [
        ("Spell CAT diagonally.", "unsupported-structure"),
        ("Stack three red blocks diagonally.", "misplaced"),
        ("A diagonal line of red, blue and green with red at the near end.", "ambiguous"),  # which of the two?
        ("A column of three blocks from the near left to the far right.", "contradiction"),
    ],
)
def test_what_does_not_lie_diagonally_is_refused(text: str, code: str) -> None:
    assert code_of(text) == code


def test_a_diagonal_can_be_there_at_first() -> None:
    begun, ended = start_and_end("There are five red blocks in a diagonal. Move them into a row.")
    assert "in a diagonal line" in begun and "in a row" in ended


def test_the_last_of_several_that_are_told_in_turn_is_the_one_at_the_end() -> None:
    told = means("A row from left to right: black first, then purple, blue, cyan, and white at the right end.")
    assert told.endswith("in a row from left to right in the order black, purple, blue, cyan, white.")
