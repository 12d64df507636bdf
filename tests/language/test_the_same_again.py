"""What is built like a structure told before it, and what is told of towers that were told before."""

from __future__ import annotations

import pytest

from tests.language.meaning import code_of, means


@pytest.mark.parametrize(
    "text",
    [
        "Build a row of red, blue and green and the same row behind it.",
        "Build a row of red, blue and green. Build the same row behind it.",
    ],
)
def test_the_same_row_is_a_further_one_and_it_is_the_one_that_is_placed(text: str) -> None:
    told = means(text)
    assert "There are two red blocks, two blue blocks and two green blocks." in told
    assert (
        "Red block 2, blue block 2 and green block 2 must be behind red block 1, blue block 1 and green block" in told
    )


def test_the_same_tower_on_another_patch_is_a_further_one_in_the_same_order() -> None:
    told = means(
        "Build a tower of red and blue from bottom to top on the red patch. Build the same tower on the blue patch."
    )
    assert "There are two red blocks and two blue blocks." in told
    assert told.count("from bottom to top in the order red, blue") == 2
    told = means("Build a tower of A on B on the red patch and the same tower on the blue patch.")
    assert 'There are two blocks labelled "A" and two blocks labelled "B".' in told


def test_another_tower_of_the_same_letters_is_not_the_same_blocks_elsewhere() -> None:
    told = means("Build a tower of A on B on the red patch. Build another tower of A on B on the blue patch.")
    assert 'There are two blocks labelled "A" and two blocks labelled "B".' in told


@pytest.mark.parametrize("kind, told_of", [("tower", "two"), ("tower", "three"), ("row", "three")])
def test_the_same_of_other_blocks_has_as_many(kind: str, told_of: str) -> None:
    told = means(f"There is a {kind} of {told_of} red blocks. Build the same {kind} from blue blocks.")
    assert f"There are {told_of} red blocks and {told_of} blue blocks." in told


def test_the_same_of_other_blocks_is_refused_where_their_number_is_open() -> None:
    assert code_of("There is a tower of red and blue. Build the same tower from green blocks.") == "ambiguous"


def test_the_same_tower_that_is_there_is_no_further_one() -> None:
    told = means("Build a tower of two red blocks. Put the same tower on the mat.")
    assert "There are two red blocks." in told
    told = means("There is a tower of red, blue and green. Build the same tower on the blue patch.")
    assert "There are a red block, a blue block and a green block." in told


@pytest.mark.parametrize(
    "text",
    [
        "Build a row of three red blocks. Build a blue one behind it.",
        "Build a 2x2 grid of red blocks. Build a blue one behind it.",
        "There is a tower of two red blocks. Make a blue one next to it.",
    ],
)
def test_what_is_built_is_no_block(text: str) -> None:
    assert code_of(text) == "ambiguous"


def test_what_is_put_behind_a_row_is_a_block() -> None:
    assert "The blue block must be behind the three" in means(
        "Build a row of three red blocks. Put a blue one behind it."
    )


@pytest.mark.parametrize(
    "text",
    [
        "Put A on B and C on D and stack the two towers.",
        "There are two towers of two. Stack the two towers.",
        "Build a red tower of two and a blue tower of two and stack them.",
    ],
)
def test_towers_that_are_stacked_do_not_stand_by_themselves(text: str) -> None:
    assert code_of(text) in ("ambiguous", "contradiction")


def test_blocks_may_be_stacked_in_towers() -> None:
    assert "must form two towers" in means("Take four red blocks and stack them in two towers.")
    assert "must be on the tower of" in means(
        "There is a tower of two red blocks and a tower of two blue blocks. Put the first tower on the second."
    )


def test_like_which_of_several_is_asked_where_they_differ() -> None:
    start = "There is a tower of two red blocks and a tower of three blue blocks. "
    assert code_of(start + "Build the same tower from green blocks.") == "ambiguous"
    told = means(start.replace("three", "two") + "Build the same tower from green blocks.")
    assert "two green blocks." in told
    told = means("Build a tower of two red blocks, a tower of two blue blocks and the same tower of green blocks.")
    assert "The two green blocks must form a tower of exactly two." in told
