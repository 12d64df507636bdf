"""Several structures of which it is told what each has: how many they are, and what is asked where that is open."""

from __future__ import annotations

import pytest

from tests.language.meaning import code_of, means

PAIRS = "A red block and a blue block must be in one group and the other red block and the other blue block must be in"


@pytest.mark.parametrize(
    "text",
    [
        "Sort the blocks into two groups so that every group contains one red and one blue block.",
        "Make two groups of one red and one blue block.",
        "There are two red and two blue blocks. Make groups of one red and one blue block.",
        "Group two red and two blue blocks so that each group has one red and one blue.",
    ],
)
def test_each_group_has_what_is_told_of_it(text: str) -> None:
    assert PAIRS in means(text)
    assert "two red blocks and two blue blocks" in means(text)


@pytest.mark.parametrize(
    "text",
    [
        "Group the blocks so that each group has one red and one blue.",
        "Make groups of one red and two blue blocks.",
        "Make towers of one red and one blue block.",
    ],
)
def test_how_many_groups_is_asked(text: str) -> None:
    assert code_of(text) == "ambiguous"


def test_so_many_of_each_color_are_all_that_is_sorted() -> None:
    text = "Make groups of three red and three blue blocks."
    assert "must be sorted by color into two groups" in means(text)
    more = f"There are six red and six blue blocks. {text}"
    assert "must be in one group" in means(more)


def test_towers_of_less_than_two_blocks_each_have_that_each() -> None:
    assert means("Build two towers of a red and a blue block.").count("must form a tower of exactly two") == 2
    assert code_of("Build two towers of two red and two blue blocks.") == "ambiguous"
