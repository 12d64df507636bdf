"""One block in two places that no block can be in at once, and blocks together in a line that are no further ones."""

from __future__ import annotations

import pytest

from tests.language.meaning import code_of, means


@pytest.mark.parametrize(
    ("text", "code"),
    [
        ("The red block should have a blue block on top and next to it.", "contradiction"),
        ("Put a blue block on top of the red one and next to it.", "contradiction"),
        ("The tower of three red blocks should have a blue block at the top and at the bottom.", "support-cycle"),
    ],
)
def test_one_block_is_not_on_and_beside_nor_on_and_below(text: str, code: str) -> None:
    assert code_of(text) == code


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ("The red block should have a blue block on top and another one next to it.", "There are two blue blocks"),
        ("The red block should have a blue block on top and a blue block next to it.", "There are two blue blocks"),
        ("First put red next to blue, then put red on blue.", "Then, the red block must be on the blue block."),
        (
            "Put the tower of three red blocks on the blue block and the green one on top of the tower.",
            "The green block must be on the tower of the three red blocks.",
        ),
    ],
)
def test_two_blocks_or_one_after_the_other_are(text: str, told: str) -> None:
    assert told in means(text)


@pytest.mark.parametrize(
    "text",
    [
        "Make a row of three red and two blue blocks with the blue ones together.",
        "A row of three red, one green and two blue blocks with the blue ones together.",
        "A row of two green and one red block with all the green ones together.",
        "A row of three red and two blue blocks with both blue ones together.",
    ],
)
def test_the_blue_ones_together_are_no_further_blocks(text: str) -> None:
    assert code_of(text) == "ambiguous"


@pytest.mark.parametrize(
    ("text", "told"),
    [
        (
            "Make a row of three red and two blue blocks with the blue ones side by side.",
            "two blue blocks must be next",
        ),
        ("A row of two red and two blue blocks, the red ones together and the blue ones together.", "same color"),
        (
            "Put three red and two blue blocks together in a row: red, red, blue, red, blue.",
            "red, red, blue, red, blue",
        ),
    ],
)
def test_side_by_side_and_all_colors_together_in_a_row(text: str, told: str) -> None:
    assert told in means(text)
