"""Digits and letters in a row: which of them come first, in whatever words, and not as they are named."""

from __future__ import annotations

import pytest

from tests.language.meaning import means

_DIGITS = "from left to right in the order the blocks 1 and 2 in no fixed order, then the blocks A and B"
_LETTERS = "from left to right in the order the blocks A and B in no fixed order, then the blocks 1 and 2"


@pytest.mark.parametrize(
    "text",
    [
        "Put A, B, 1 and 2 in a row, digits before letters.",
        "Arrange A, B, 1, 2 in a row so that the digits come before the letters.",
        "Arrange A, B, 1, 2 in a row so that the letters come after the digits.",
        "Line up A, B, 1 and 2 with the digits before the letters.",
        "Line up A, B, 1 and 2, first the digits, then the letters.",
        "Make a row of A, B, 1 and 2, digits first, then letters.",
        "Make a row of A, B, 1 and 2, numbers before letters.",
        "Put A, B, 1 and 2 in a row. The digits come before the letters.",
    ],
)
def test_digits_come_first(text: str) -> None:
    assert _DIGITS in means(text)


@pytest.mark.parametrize(
    "text",
    [
        "Put A, B, 1 and 2 in a row, letters before digits.",
        "Line up A, B, 1 and 2 with the digits after the letters.",
    ],
)
def test_letters_come_first(text: str) -> None:
    assert _LETTERS in means(text)


def test_behind_is_a_place_and_before_without_a_row_a_time() -> None:
    assert "must be behind the blocks 1 and 2" in means(
        "Put A, B, 1 and 2 in a row with the letters behind the digits."
    )
    assert "First, the blocks A" in means("Line up the letters before the digits.")
