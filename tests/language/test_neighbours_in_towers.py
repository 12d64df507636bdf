"""Blocks of a tower that are next to each other: one lies on the other."""

from __future__ import annotations

import pytest

from tests.language.meaning import means


@pytest.mark.parametrize(
    "text",
    [
        "Stack A, B, C and D so that A and B are next to each other.",
        "Stack A, B, C and D. A and B must be next to each other.",
        "Build a tower of A, B, C and D with A directly next to B.",
    ],
)
def test_neighbours_in_a_tower_lie_on_each_other(text: str) -> None:
    assert "The A block must touch the B block." in means(text)


@pytest.mark.parametrize("told", ["the blue blocks not next to each other", "no two blue ones next to each other"])
def test_blocks_of_a_tower_that_are_no_neighbours_do_not_touch(told: str) -> None:
    assert "The two blue blocks must not touch each other." in means(
        f"Build a tower of three red and two blue blocks with {told}."
    )


def test_what_is_next_to_a_tower_is_beside_it() -> None:
    assert "The A block must not be next to the D block." in means("Stack A, B and C. A must not be next to D.")
    assert "must be next to the tower" in means("Build two towers of two blue blocks next to each other.")
