"""Words that two people take for two things: a mat for each or one for all, not left alone, put right, what is kept out
of a line; what is left beside a tower that is only built, mats told in an order, another tower."""

from __future__ import annotations

from typing import Any

import pytest

from tests.language.meaning import assert_means, code_of, means


@pytest.mark.parametrize(
    "text",
    [
        "Do not leave the white block alone, put the black one beside it.",
        "Leave neither block alone: there are a pink and a cyan one.",
        "The row reads K M L. Put it right.",
        "A green block with the letter B on it.",
        "Add a block to the right of the row D E F with the letter G on it.",
        "There are two mats, a big yellow one and a small green one. Put the big block on the small one.",
        "Take three blocks, white, pink and black. Stack them but keep the pink one on the table.",
        "Stack white, cyan and pink but leave cyan next to the tower.",
        "Put pink, green and blue in a row, but keep the green one away from the others.",
        "A stack on each of two mats: pink on the left one, white on the right one, two high.",
        "Put the white and the black block on two mats, red and green, in that order, with a blue block behind them.",
        "A tower of white blocks, four, with the second black.",
        "A tower of pink blocks, five, the fourth one cyan.",
    ],
)
def test_what_could_be_two_things_is_asked(text: str) -> None:
    assert code_of(text) == "ambiguous"


@pytest.mark.parametrize(
    "text",
    [
        "Two towers of two white blocks, each on a mat.",
        "Three cyan blocks, each on a yellow mat.",
        "Move the white cube away from the black cube and put the yellow cube there.",
        "Add two white blocks to the tower of three black ones, one at the bottom and one on top.",
    ],
)
def test_what_is_not_told_is_refused(text: str) -> None:
    assert code_of(text) in ("misplaced", "misplaced-word", "no-referent", "support-cycle", "ambiguous")


@pytest.mark.parametrize(
    ("text", "meant"),
    [
        ("Put the pink and the white block on two mats, green and blue, in that order.",
         {"assets": {"pink": 1, "white": 1, "green_patch": 1, "blue_patch": 1}}),
        ("A tower of two on the mat, another one off it, all white.", {"assets": {"white": 4, "gray_patch": 1}}),
        ("Leave the pink block alone and put the white one on the mat.",
         {"assets": {"pink": 1, "white": 1, "gray_patch": 1}}),
        ("Two pink blocks, each on a white block.", {"assets": {"pink": 2, "white": 2}}),
    ],
)  # fmt: skip
def test_blocks_are_those_that_are_told(text: str, meant: dict[str, Any]) -> None:
    assert_means(text, meant)


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ("Put the pink and the white block on two mats, green and blue, in that order.",
         "The pink block must be on the green patch."),
        ("Stack the pink and the white block but leave the green one on the table.",
         "The pink and white blocks must be stacked. The green block must be on the table."),
        ("Stack D, E and F but put F at the bottom.", "stacked with the F block at the bottom"),
        ("The pink block is on the left. Put it on the right.", "must be in the right half of the table"),
        ("Put a pink block with the letter D on it on the mat.", "There is a pink D block."),
        ("Place the pink cube with the letter D on it on top of the white cube.",
         "The pink D block must be on the white block."),
        ("Two towers of three, the first of pink blocks, the second white.",
         "The three white blocks must form a tower of exactly three."),
    ],
)  # fmt: skip
def test_what_is_clear_is_read(text: str, told: str) -> None:
    assert told in means(text).replace("\n", " ")


@pytest.mark.parametrize(
    ("text", "begun"),
    [
        ("Take five white blocks. Make a tower of three, leave the other two next to it.", False),
        ("Use five pink blocks. Build a row of three and leave the other two behind it.", False),
        ("Take the white block from the stack white, pink, black.", True),
        ("Remove D from the tower D, E, F.", True),
        ("There is a tower of three white blocks. There are two pink blocks. Put one pink block on the tower and leave "
         "the other one next to it.", True),
    ],
)  # fmt: skip
def test_what_is_there_at_the_start(text: str, begun: bool) -> None:
    assert ("At the start" in means(text)) == begun
