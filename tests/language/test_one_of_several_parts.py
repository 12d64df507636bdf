"""One corner is not all of them, one block no layer, each is not all together; whose "that has" is; what is turned."""

from __future__ import annotations

import pytest

from tests.language.meaning import assert_means, code_of, means


@pytest.mark.parametrize(
    "text",
    [
        "A square of blocks, one corner is white and the others are gray.",
        "A triangle of blocks, two corners are pink, the rest is brown.",
        "A wall 3 wide and 2 high: one top block pink, the rest brown.",
        "A pyramid with a base of four, one bottom block is cyan, the rest is black.",
        "There are three pink blocks in a row and three gray blocks in a row. Stack them separately.",
        "At the start there is a pink tower of three and a gray tower of two. Make a row out of each.",
        "There's a pink block with a gray block to its left that has a white block behind it.",
        "There's a pink block with a gray block behind it which has a white block on it.",
        "Build a tower with a pink bottom block, a pink top block and two blocks in between that are gray.",
        "At the start there's a tower of pink on gray on white. Turn it round and put it on the mat.",
    ],
)
def test_what_may_be_of_another_one_is_not_guessed(text: str) -> None:
    assert code_of(text)


def test_all_corners_are_told_by_their_number() -> None:
    assert "four pink" in means("A square of eight blocks, the four corners are pink and the rest is gray.")


def test_each_of_two_towers_is_laid_in_a_row() -> None:
    assert_means(
        "At the start there's a pink tower of three and a gray tower of three. Lay each in a row.",
        {"assets": {"pink": 3, "gray": 3}, "hold": ["pink pink pink at=0,0 ; gray gray gray at=-4,0"],
         "miss": ["pink^pink^pink ; gray gray gray", "pink gray pink at=0,0 ; gray pink gray at=-4,0"]},
    )  # fmt: skip
