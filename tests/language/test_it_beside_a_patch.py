""" "It" behind a structure that stands beside a patch, and behind structures with a block that is told apart."""

from __future__ import annotations

import pytest

from tests.language.meaning import code_of, means


def test_on_the_other_side_of_it_is_of_the_patch() -> None:
    told = means("Put a tower of two to the left of the red patch and another to its right.")
    assert "The tower of red block 3 and red block 4 must be to the right of the red patch." in told
    told = means("Put a row of three red blocks behind the patch and a blue block in front of it.")
    assert "The blue block must be in front of the gray patch." in told


@pytest.mark.parametrize("place", ["next to it", "to the left of it", "behind it"])
def test_beside_it_may_be_beside_the_patch_too(place: str) -> None:
    assert code_of(f"Put a tower of two red blocks next to the patch and a blue block {place}.") == "ambiguous"


def test_it_is_the_tower_on_the_patch() -> None:
    told = means("Put a tower of two red blocks on the patch and a blue block behind it.")
    assert "The blue block must be behind the tower of the two red blocks." in told


@pytest.mark.parametrize("line", ["tower of two red blocks", "row of three red blocks"])
def test_what_does_not_touch_it_may_touch_itself(line: str) -> None:
    assert code_of(f"Put a {line} next to the patch, but not touching it.") == "misplaced"
    told = means(f"Put a {line} next to D, but not touching it.")
    assert "red blocks must not touch the D block." in told


@pytest.mark.parametrize(
    "text",
    [
        "There is a row of three blue blocks with a red one at the left end. Move it to the right end.",
        "There is a row of four blocks with one red block at the left end. Put it in the middle.",
        "There is a column of three blue blocks with a red one at the front. Move it to the back.",
        "There is a tower of three blue blocks with a red one on top. Put it on the patch.",
        "Make a row of three red blocks and a tower of two blue blocks. Put it on the patch.",
    ],
)
def test_it_may_be_the_whole_or_a_block_of_it(text: str) -> None:
    assert code_of(text) == "ambiguous"


def test_it_is_the_one_structure_that_was_mentioned() -> None:
    told = means("There is a tower of three blue blocks. Put it on the patch.")
    assert "The three blue blocks must form a tower of exactly three on the gray patch." in told
    told = means("Build a row of three blue blocks with a red one at the left end. Put it on the patch.")
    assert "The three blue blocks and the red block must be on the gray patch." in told
