"""Blocks that get smaller or grow, where that is in size and where in numbers; and staying in the same place."""

from __future__ import annotations

import pytest

from tests.language.meaning import code_of, means


@pytest.mark.parametrize(
    ("text", "way"),
    [
        ("Stack three blocks so that they get smaller from bottom to top.", "from bottom to top by decreasing size"),
        ("Stack three blocks so that they get bigger from bottom to top.", "from bottom to top by increasing size"),
        ("A row of three cubes growing from left to right.", "from left to right by increasing size"),
        ("Three cubes in a row, shrinking from left to right.", "from left to right by decreasing size"),
        ("A row of three digits growing from left to right.", "from left to right in ascending numerical order"),
        ("A row of the blocks 2, 4 and 6 growing from left to right.", "from left to right in ascending numerical"),
    ],
)
def test_blocks_without_numbers_grow_in_size(text: str, way: str) -> None:
    assert way in means(text)


@pytest.mark.parametrize("place", ["in same place", "at the same spot", "in own place", "at its original position"])
def test_who_stays_in_place_is_on_no_patch(place: str) -> None:
    told = means(f"Put red on green. The blue block stays {place}.")
    assert "The blue block must stay where it is" in told
    assert "patch" not in told


def test_staying_in_place_alone_is_no_task() -> None:
    assert code_of("Let the blue block stay in same place.") == "start-solves-goal"


def test_one_of_several_with_the_same_letter_is_told_by_its_place() -> None:
    told = means("Make a row of three T blocks and turn the middle one upside down.")
    assert "in the order T, T, T" in told
    assert "A T block must be upside down" in told
