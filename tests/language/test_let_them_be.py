"""Blocks that are let be a row, a tower or a rainbow, colour by colour behind a colon: all of them are in it."""

from __future__ import annotations

import pytest

from tests.language.meaning import means

SIX = "There are a red block, an orange block, a yellow block, a green block, a blue block and a purple block."


@pytest.mark.parametrize(
    ("text", "told"),
    [
        (
            "Let the blocks be a rainbow: red, orange, yellow, green, blue, purple standing side by side in this order",
            f"{SIX} The red, orange, yellow, green, blue and purple blocks must be in a row in rainbow order in "
            "either direction.",
        ),
        (
            "Make a rainbow: red, orange, yellow, green standing side by side in that order.",
            "There are a red block, an orange block, a yellow block and a green block. The red, orange, yellow and "
            "green blocks must be in a row in rainbow order in either direction.",
        ),
        (
            "Let the blocks be a tower: red, green, blue.",
            "There are a red block, a green block and a blue block. The three blocks must be stacked from bottom to "
            "top in the order red, green, blue.",
        ),
    ],
)
def test_all_that_are_listed_are_in_it(text: str, told: str) -> None:
    """None of them is told of alone."""
    assert means(text) == told
