"""What is said of so many of several structures, whichever they are, and of one that is told by the others."""

from __future__ import annotations

import pytest

from tests.language.meaning import code_of, means

_TWO = "Build a tower of two red blocks and a tower of three blue blocks."
_RED, _BLUE = "the two red blocks must be on the gray patch", "the three blue blocks must be on the gray patch"


def test_exactly_one_of_two_towers_leaves_the_other_one_out() -> None:
    for said in ("Exactly one of the towers is", "One of the two towers stands"):
        told = means(f"{_TWO} {said} on the patch.")
        assert f"Either {_RED}, blue block 1 must not be on the gray patch, " in told
        assert f"or {_BLUE}, red block 1 must not be on the gray patch and red block 2 must not" in told


def test_at_least_one_of_them_leaves_open_where_the_other_one_is() -> None:
    told = means(f"{_TWO} At least one of the towers must be in the left half.")
    assert "red blocks must be in the left half of the table or the three blue blocks must be" in told
    assert "must not" not in told


@pytest.mark.parametrize("said", ["None of the towers may stand", "Neither of the two towers is"])
def test_none_of_them_is_there_with_any_of_its_blocks(said: str) -> None:
    assert means(f"{_TWO} {said} on the patch.").count("must not be on the gray patch") == 5


@pytest.mark.parametrize("said", ["Each of the two towers is", "Both of the towers are", "All of the towers stand"])
def test_what_is_said_of_each_is_said_of_all(said: str) -> None:
    assert "The two red blocks and the three blue blocks must be on the gray patch." in means(
        f"{_TWO} {said} on the patch."
    )


def test_two_of_three_towers_that_look_alike() -> None:
    told = means("Build three towers of two blocks. Two of the three towers are on the patch.")
    assert "There are six red blocks." in told
    assert told.count("red block 5 must not be on the gray patch") == 1


def test_the_taller_of_two_is_one_of_them() -> None:
    told = means(f"{_TWO} Put a green block on the shorter of the two towers.")
    assert "The green block must be on the tower of the two red blocks." in told
    assert code_of(f"{_TWO} The taller of the three towers is on the patch.") == "count-mismatch"


def test_a_place_behind_one_of_them_is_its_own() -> None:
    told = means("Build two towers of three red blocks, the left one on the patch.")
    assert "Red block 1, red block 2 and red block 3 must be on the gray patch." in told
    assert "six red blocks must be on the gray patch" not in told


def test_more_than_there_are_and_what_only_blocks_do() -> None:
    assert code_of(f"{_TWO} Three of the towers are on the patch.") == "count-mismatch"
    assert code_of(f"{_TWO} Put A on one of the towers.") == "ambiguous"
    assert code_of(f"{_TWO} Turn one of the towers upside down.") == "misplaced"
