"""Figures on or beside each of several patches or blocks, and what goes into a tower that is there."""

from __future__ import annotations

import pytest

from tests.language.meaning import code_of, means


@pytest.mark.parametrize("which", ["both patches", "each of two patches", "all two patches"])
def test_a_tower_on_both_patches_is_one_on_each(which: str) -> None:
    told = means(f"Put a tower of two red blocks on {which}.")
    assert "Two red blocks must form a tower of exactly two on the gray patch." in told
    assert "The other two red blocks must form a tower of exactly two on the blue patch." in told


def test_towers_on_all_three_patches_are_three() -> None:
    told = means("Put a tower of two green blocks on all three patches.")
    assert "There are six green blocks." in told
    assert told.count("must form a tower of exactly two on the") == 3


@pytest.mark.parametrize(
    "text",
    [
        "Put a tower of two red blocks and a tower of two blue blocks on each of two patches.",
        "Put two towers of two on each of two patches.",
        "Put a row of three in front of each of two patches.",
        "Put a tower of two red blocks next to each of two blue blocks.",
        "There are two patches. Put a row of three red blocks behind each.",
        "There are two patches. Put a tower of two on both.",
        "Put each of two red blocks on a tower of two blue ones.",
        "There are two red blocks. Put every red block on a tower of two blue blocks.",
    ],
)
def test_it_is_asked_whether_there_is_one_for_all_or_one_for_each(text: str) -> None:
    assert code_of(text) == "ambiguous"


def test_one_for_each_is_read_where_it_is_said() -> None:
    assert "or the two red blocks must be on the blue patch" in means("Build two towers of two, one on each patch.")
    told = means("Build two towers of two blue blocks, with a red block on each.")
    assert "There are four blue blocks and two red blocks." in told
    assert "must be in front of the gray patch and the blue patch" in means(
        "Build a row of three in front of both patches."
    )


@pytest.mark.parametrize("where", ["in the middle of it", "in the middle of the tower", "between B and C"])
def test_the_middle_of_a_tower_is_between_the_two_blocks_there(where: str) -> None:
    told = means(f"There is a tower of A, B, C and D from bottom to top. Put a red block {where}.")
    assert "in the order the A block, the B block, the red block, the C block, the D block." in told


@pytest.mark.parametrize(
    "text",
    [
        "There is a tower of A, B and C. Insert a red block in the middle.",
        "There is a tower of four red blocks. Put a blue block in the middle of it.",
        "There is a tower of A, B and C from bottom to top. Put a red block in the middle of it.",
        "There is a tower of A, B, C and D from bottom to top. Insert a red block below the top two.",
        "There is a tower of A, B, C and D from bottom to top. Insert a red block below D.",
    ],
)
def test_it_is_asked_where_in_the_tower(text: str) -> None:
    assert code_of(text) == "ambiguous"


def test_the_middle_of_the_table_and_what_is_below_a_tower_are_still_read() -> None:
    told = means("There is a tower of A, B and C. Put a red block in the middle of the table.")
    assert "The red block must be in the middle of the table." in told
    told = means("There is a tower of A on B. Put a red block below B.")
    assert "The B block must be somewhere above the red block." in told
    told = means("There is a tower of A, B and C. Put it in the middle.")
    assert "must be in the middle of the table" in told


def test_what_rests_on_both_blocks_below_it_is_a_pyramid() -> None:
    told = means("A pyramid of three: two red at the bottom, a blue one on top resting on both.")
    assert "must form a pyramid with a base of two blocks" in told
