"""Lines along an edge that they lead away from, and distances that are less than blocks side by side have."""

from __future__ import annotations

import pytest

from tests.language.meaning import code_of, means


@pytest.mark.parametrize(
    "text",
    [
        "A row of four red blocks along the left edge.",
        "Put A, B and C in a row at the left edge of the table.",
        "A row of three red blocks at the right edge.",
        "Spell CATS along the right edge.",
        "Put a column of four red blocks along the near edge.",
    ],
)
def test_a_line_that_leads_away_from_an_edge_is_not_all_at_it(text: str) -> None:
    assert code_of(text) == "ambiguous"


def test_where_a_whole_row_is_is_no_place_in_it() -> None:
    assert code_of("A row of three red blocks on the left.") == "misplaced"
    assert "in the right half of the table" in means("A row of three red blocks on the right side of the table.")
    told = means("A row with three red blocks on the left and a blue one on the right.")
    assert "with the blue block at the right end" in told


@pytest.mark.parametrize(
    "text",
    [
        "A row of four red blocks from front to back along the left edge.",
        "A column of four red blocks along the left edge.",
        "A line of four red blocks along the left edge.",
        "A row of four red blocks along the near edge.",
        "A row of two red blocks along the left edge.",
    ],
)
def test_a_line_along_an_edge_is_all_at_it(text: str) -> None:
    assert "red blocks must be at the" in means(text)


@pytest.mark.parametrize(
    "text",
    [
        "Put the red block exactly 3 cm to the left of the blue one.",
        "A row of four blocks, 3 cm apart, on a long blue mat.",
        "A row of four blocks, 3.5 cm apart.",
        "Red and blue are 3.5 cm apart.",
    ],
)
def test_centers_are_not_nearer_than_blocks_that_touch(text: str) -> None:
    assert code_of(text) == "does-not-fit"


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ("Red and blue are 4 cm apart.", "must be 4 cm from the blue block"),
        ("Red and blue should be between 2 and 5 cm apart.", "between 2 cm and 5 cm"),
        ("Two blocks of 3 cm, 3 cm apart.", "must be 3 cm from the 3 cm blue block"),
        ("A row of four 3 cm blocks, 3 cm apart.", "3 cm between centers"),
        ("Put the red block to the left of the blue one with a gap of 3 cm.", "There must be a gap of 3 cm"),
        ("Put red 3 cm from the mat.", "must be 3 cm from the gray patch"),
    ],
)
def test_distances_that_blocks_side_by_side_can_have(text: str, told: str) -> None:
    assert told in means(text)
