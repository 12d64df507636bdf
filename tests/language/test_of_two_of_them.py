"""What is told of two blocks and their tower, of one that is not so, and of a place that something was at."""

from __future__ import annotations

import pytest

from tests.language.meaning import code_of, means, start_and_end


def test_a_block_on_it_makes_a_tower_of_the_two() -> None:
    told = means("Two blocks: a red one and a blue one on it.")
    assert told.endswith("must be stacked from bottom to top in the order red, blue.")


def test_what_lies_there_is_the_one_that_is_moved() -> None:
    begun, ended = start_and_end("The block that is on the mat is the red one. Move it onto the blue block.")
    assert "the red block is on the gray patch" in begun
    assert ended.endswith("The red block must be on the blue block.") and "patch" not in ended


@pytest.mark.parametrize(
    ("text", "code"),
    [
        ("There's a red, a blue and a yellow cube. Place the one that is not red on the mat.", "ambiguous"),
        ("Build two towers of 2 blocks each with one red and one blue.", "ambiguous"),  # no tower of each colour
        ("Clear the red mat but not the blue one.", "ambiguous"),  # a mat or a block?
        ("Rebuild this tower with green on top.", "no-referent"),
        ("The red block was on the mat. Put it back.", "ambiguous"),  # is it not there at the start?
    ],
)
def test_what_is_not_told_is_refused(text: str, code: str) -> None:
    assert code_of(text) == code


def test_the_one_that_is_not_so_is_one() -> None:
    assert "must be on the gray patch" in means(
        "There are two cubes, red and blue. Put the one that is not red on the mat."
    )
