""" "The left one" and "the other" of two blocks of which it is said how they lie at first."""

from __future__ import annotations

import pytest

from tests.language.meaning import code_of, means


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ("Red is left of blue. Put the green block on the left one.", "green block must be on the red block."),
        ("Red stands behind green. Put the black block on the nearer one.", "black block must be on the green block."),
        (
            "A red block is on the left and a blue one on the right. Put the green block on the right one.",
            "green block must be on the blue block.",
        ),
        (
            "A red block is on the left and a blue one on the right. Leave the left one where it is and put the other "
            "behind it.",
            "The red block must stay where it is. The blue block must be behind the red block.",
        ),
    ],
)
def test_one_of_two_is_told_by_its_side(text: str, told: str) -> None:
    assert means(text).endswith(told)


@pytest.mark.parametrize(
    "text",
    [
        "Red is left of blue and blue is left of green. Put the white block on the left one.",
        "The red block is left of the blue one, and there is a yellow block. Put the yellow block on the left one.",
        "Red is left of blue. Put red right of blue and green on the left one.",
        "Red is left of blue. Put the green block on the front one.",
        "Put red left of blue and the other behind it.",
    ],
)
def test_it_must_be_clear_which_one_is_there(text: str) -> None:
    assert code_of(text)
