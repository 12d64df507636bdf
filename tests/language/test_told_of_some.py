"""What is told of some of a whole: the whole stays whole, and so many of it are what is said."""

from __future__ import annotations

import pytest

from tests.language.meaning import code_of, means


@pytest.mark.parametrize(
    ("text", "whole", "some"),
    [
        ("Line up five red blocks, all but one on the mat.", "The five red blocks must be in a line",
         "Exactly four of the five red blocks must be on the gray patch"),
        ("Line up five red blocks, all but two of them on the mat.", "The five red blocks must be in a line",
         "Exactly three of the five red blocks must be on the gray patch"),
        ("Stack four blue blocks, all but one in the left half.", "The four blue blocks must be stacked",
         "Exactly three of the four blue blocks must be in the left half"),
        ("Put five red blocks in a row, all but one on the mat.", "The five red blocks must be in a row",
         "Exactly four of the five red blocks must be on the gray patch"),
        ("Line up five red blocks, two of them on the mat.", "The five red blocks must be in a line",
         "Exactly two of the five red blocks must be on the gray patch"),
        ("Line up six red blocks, half of them on the mat.", "The six red blocks must be in a line",
         "Exactly three of the six red blocks must be on the gray patch"),
    ],
)  # fmt: skip
def test_the_whole_is_built_and_some_of_it_is_there(text: str, whole: str, some: str) -> None:
    told = means(text)
    assert whole in told
    assert some in told


def test_what_is_told_of_all_of_them_is_as_it_was() -> None:
    assert "The five red blocks must be on the gray patch" in means("Line up five red blocks, all on the mat.")
    assert "There are five blue blocks" in means("Make a row of five blocks, all of them blue.")


@pytest.mark.parametrize("whole", ["row of five", "tower of four", "line of six"])
def test_how_the_one_that_is_left_out_looks_is_asked(whole: str) -> None:
    assert code_of(f"Make a {whole} blocks, all but one of them blue.") == "ambiguous"


@pytest.mark.parametrize(
    ("many", "them"),
    [("At least two", "them"), ("Exactly two", "them"), ("Exactly one", "it"), ("All but one", "them")],
)
def test_each_of_so_many_has_a_block_of_its_own(many: str, them: str) -> None:
    told = means(f"There are three red and three blue blocks. {many} of the red blocks must have a blue block on top.")
    said = many.replace("All but one", "Exactly two")
    assert f"{said} of the three red blocks must have a blue block on {them}." in told


@pytest.mark.parametrize(
    "ends",
    [
        "at most one red one at the ends",
        "exactly one red one at the ends",
        "only one red block at an end",
        "a red one at only one end",
        "at least one red one at the ends",
    ],
)
def test_ends_that_are_counted_are_told_one_by_one(ends: str) -> None:
    assert code_of(f"Line up three red and three blue blocks with {ends}.") == "ambiguous"


def test_ends_that_are_told_plainly_are_as_they_were() -> None:
    assert "a red block, then" in means("Line up three red and three blue blocks with a red one at one end.")
    assert "then a red block" in means("Line up three red and three blue blocks with red ones at the ends.")
    assert "the red block, then" in means("Line up one red and three blue blocks with exactly one red one at an end.")


@pytest.mark.parametrize(
    "text",
    [
        "Exactly one of the two mats must have a red block on it; there are two red blocks.",
        "There are two red blocks and two mats. Exactly one of the mats must have a block on it.",
        "There are two red blocks and two mats. Put a red block on exactly one of the mats.",
    ],
)
def test_the_other_mat_has_none(text: str) -> None:
    told = means(text)
    assert "at least one of the two red blocks must be on the gray patch" in told
    assert "red block 1 must not be on the blue patch and red block 2 must not be on the blue patch" in told


def test_on_one_of_the_mats_is_on_either() -> None:
    told = means("There are two red blocks and two mats. One of the mats must have a red block on it.")
    assert "must be on the gray patch or" in told
    assert "must not" not in told


@pytest.mark.parametrize("each", ["two of each color", "two of each colour", "three of each", "two per color"])
def test_the_colors_of_which_there_are_several_each_are_asked(each: str) -> None:
    assert code_of(f"Line up six blocks, {each}.") == "ambiguous"
    assert code_of(f"There are six blocks, {each}. Put them in a row.") == "ambiguous"


def test_so_many_of_each_that_is_named() -> None:
    told = means("Line up red, blue and green blocks, two of each color.")
    assert "There are two red blocks, two blue blocks and two green blocks." in told
