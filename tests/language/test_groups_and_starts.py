"""Blocks that are told in groups, by size or by what they show, rows one on the other, and what is on what at first."""

from __future__ import annotations

import pytest

from tests.language.meaning import code_of, means


@pytest.mark.parametrize(
    "text",
    [
        "Put six red blocks in two rows, one on top of the other.",
        "Put four red blocks in two rows, one above the other.",
        "Put six red blocks in two rows on top of each other.",
        "Put four red blocks in two towers, one on top of the other.",
    ],
)
def test_rows_on_each_other_do_not_both_lie_on_the_table(text: str) -> None:
    assert code_of(text) == "ambiguous"


def test_rows_behind_each_other_and_blocks_on_each_other_are_read() -> None:
    assert "must be behind red block 4" in means("Put six red blocks in two rows, one behind the other.")
    assert "must be stacked" in means("Put two red blocks one on top of the other.")


@pytest.mark.parametrize("lines", ["three rows", "three columns"])
def test_the_number_of_its_lines_is_not_that_of_the_blocks_of_a_grid(lines: str) -> None:
    assert code_of(f"Build a grid with {lines}: red, blue and green.") == "ambiguous"
    assert "a grid of three rows and three columns" in means(f"Build a 3x3 grid with {lines}: red, blue and green.")


@pytest.mark.parametrize(
    "text",
    [
        "Stack two large red and two small blue blocks, large at the bottom.",
        "Build a row of two large and two small red blocks, large on the left.",
        "Stack three large and two small blocks, small on top.",
    ],
)
def test_one_of_some_size_or_all_is_asked(text: str) -> None:
    assert code_of(text) == "ambiguous"


def test_all_of_a_size_or_the_only_one_are_read() -> None:
    told = means("Stack two large red and two small blue blocks, the large ones at the bottom.")
    assert "the two 5 cm red blocks, then the two 3 cm blue blocks" in told
    told = means("Stack two large and two small blocks, large at the bottom and small on top.")
    assert "the two 5 cm red blocks, then the two 3 cm red blocks" in told
    assert "5 cm red block, the 3 cm blue" in means("Stack a large red and a small blue block, large at the bottom.")


@pytest.mark.parametrize(
    ("text", "there"),
    [
        ("Build a tower of two big blocks, one red and one blue.", "There are a 5 cm red block and a 5 cm blue block."),
        ("Build a row of four 3 cm blocks, two red and two blue.", "two 3 cm red blocks and two 3 cm blue blocks."),
        ("Stack three small cubes, two red and one blue.", "There are two 3 cm red blocks and a 3 cm blue block."),
        ("Build a tower of two letter blocks, one red and one blue.", "There are a red A block and a blue B block."),
        ("Line up three red blocks with the letters A, B and C.", "a red A block, a red B block and a red C block."),
        ("Build a row of two red cubes with the digits 1 and 2.", "There are a red 1 block and a red 2 block."),
    ],
)
def test_what_was_counted_is_told_apart(text: str, there: str) -> None:
    assert there in means(text)


def test_further_blocks_are_further_blocks() -> None:
    told = means("Build a tower of two big blocks and a red one and a blue one.")
    assert "a red block and a blue block" in told
    assert told.count("5 cm") == 4
    assert "There are three red blocks, an A block" in means("Line up three red blocks and the letters A, B and C.")


@pytest.mark.parametrize(
    "patches",
    [
        "a red patch with a blue block and a blue patch with a red block",
        "a red patch with a blue block on it and a blue patch with a red block on it",
    ],
)
def test_what_is_on_patches_that_are_there_is_there_at_first(patches: str) -> None:
    told = means(f"There is {patches}. Swap the blocks.")
    assert "At the start, the blue block is on the red patch. At the start, the red block is on the blue patch." in told
    assert "must be on" not in told


def test_what_is_on_the_last_thing_of_a_list_is_there_at_first() -> None:
    told = means("There is a blue block with a red one on it and a patch with a green one on it. Swap red and green.")
    assert "At the start, the green block is on the gray patch." in told
    assert "must be on" not in told
    told = means("There is a red block and a patch with a green block on it. Put the red block on the green one.")
    assert "At the start, the green block is on the gray patch." in told
    assert "must be on the gray patch" not in told


def test_it_is_asked_what_a_patch_has_where_more_is_listed() -> None:
    text = "There is a red patch with a blue block and a green block. Put the green block on the blue one."
    assert code_of(text) == "ambiguous"


def test_blocks_around_a_patch_are_not_on_it() -> None:
    told = means(
        "There is a white mat with a red, a blue and a green block around it. The green block should be on the mat."
    )
    assert "At the start, the green block is on" not in told
