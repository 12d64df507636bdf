"""Words beside a figure that are no part of it: "the one" is no number, "all of them" are not the blocks of each, what
a letter has lies on it, and "than" compares."""

from __future__ import annotations

import pytest

from tests.language.meaning import assert_means, code_of, means

_WORD = {"B": 1, "I": 1, "R": 1, "D": 1, "green": 1}


def test_the_one_is_no_layer_of_a_pyramid() -> None:
    code_of("I'd like a purple pyramid like the one in the hall with a base of three")
    assert "three rows and three columns" in means("a 3x3 grid of green cubes, the one in the center is pink")


@pytest.mark.parametrize(
    "text",
    ["build exactly two towers from seven green blocks and use all of them",
     "make two towers of six pink cubes and use all of them"],
)  # fmt: skip
def test_all_of_them_are_not_the_blocks_of_each(text: str) -> None:
    assert code_of(text)


def test_what_a_letter_has_lies_on_it() -> None:
    assert_means(
        "Spell BIRD. The R has a green cube on it",
        {"assets": _WORD, "hold": ["B I R^green D"], "miss": ["B I R D", "B I^green R D"]},
    )
    assert "green B block" in means("Spell BIRD, the first letter has a green body")


def test_than_behind_a_comparison_is_not_mended() -> None:
    assert code_of("A row of three blocks, and a tower with two more blocks than the row.")
    assert "Then, the green block" in means("put red on blue, than green on red")
