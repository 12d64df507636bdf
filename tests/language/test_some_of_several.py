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


def test_shares_of_them() -> None:
    three = "Build three towers of two red blocks."
    told = means(f"{three} All but one of the towers are on the patch.")
    assert "red block 3 and red block 4 must be on the gray patch, red block 5 must not be on" in told
    told = means(f"{three} Not all of the towers are on the patch.")
    assert "Either red block 1 must not be on the gray patch and red block 2 must not be" in told
    assert "must be on the gray patch" not in told
    assert code_of(f"{three} Most of the towers are on the patch.") == "misplaced"


def test_more_than_there_are_and_what_only_blocks_do() -> None:
    assert code_of(f"{_TWO} Three of the towers are on the patch.") == "count-mismatch"
    assert code_of(f"{_TWO} Put A on one of the towers.") == "misplaced"
    assert code_of(f"{_TWO} One of the towers must not be on the patch.") == "misplaced"
    assert code_of(f"{_TWO} Turn one of the towers upside down.") == "misplaced"


def test_so_many_of_them_told_behind_in_short() -> None:
    told = means("Two towers of three, one of the towers on the green patch.")
    assert "red block 3 must be on the green patch, red block 4 must not be on the green patch" in told
    told = means("Build two towers of two red blocks. At most one of the towers may be on the blue patch.")
    assert "Either red block 1 must not be on the blue patch and red block 2 must not" in told


@pytest.mark.parametrize(
    "said", [", the shorter on the patch", ". The shorter is on the patch", ". The shorter one is on the patch"]
)
def test_the_shorter_is_that_tower(said: str) -> None:
    told = means(f"Build a tower of three red blocks and a tower of two blue blocks{said}.")
    assert "The two blue blocks must form a tower of exactly two on the gray patch." in told


def test_which_of_them_is_the_taller() -> None:
    told = means("Two towers of two and three blocks, the left one the taller.")
    assert "tower of red block 1, red block 2 and red block 3 must be to the left of" in told
    assert "must be between" in means("Three towers of two, three and four blocks, the middle one the tallest.")


def test_identical_towers_of_no_look_are_not_made_up() -> None:
    assert code_of("Build two identical towers of three.")
    assert "six red blocks" in means("Build two identical towers of three red blocks.")


def test_a_place_of_all_towers_is_not_that_of_the_last_one() -> None:
    text = "Build a tower of red on blue and a tower of green on yellow. Both towers are on the blue patch."
    assert code_of(text)
