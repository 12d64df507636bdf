"""Sides of a pair, what is left over, and what nobody has stacked yet, told with few words; what is denied of looks
alone; and what is there of the last of several things, or of all of them."""

from __future__ import annotations

import pytest

from tests.language.meaning import code_of, means, start_and_end


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ("Put X and Y side by side, Y right.", "The Y block must be to the right of the X block."),
        ("Put pink and white beside each other, white left, and green on pink.",
         "The white block must be to the left of the pink block."),
        ("white=left, pink=right, green=middle, all in one line", "in the order white, green, pink"),
        ("pink=top, green=bottom", "stacked from bottom to top in the order green, pink"),
        ("One row of four white blocks, and one pink block left over.", "There is also a pink block as a distractor."),
        ("A tower of four white blocks, and two pink ones are left.", "two pink blocks as distractors"),
        ("Four blocks, none of them green, on the green mat.", "blocks must be on the green patch."),
        ("Three blocks, none of which is blue, on the blue mat.", "blocks must be on the blue patch."),
        ("A tower of three blocks, none of them pink, on the pink mat.", "exactly three on the pink patch."),
        ("Put red left and blue right.", "The red block must be to the left of the blue block."),
        ("A row of red, blue and green, the red one left.", "in a row with the red block at the left end"),
    ],
)  # fmt: skip
def test_in_few_words(text: str, told: str) -> None:
    assert told in means(text)


@pytest.mark.parametrize(
    ("text", "start", "end"),
    [
        ("Initially, nothing is stacked. There are six white blocks. Make two towers.",
         "At the start, nothing is on the six white blocks",
         "The six white blocks must form two towers."),
        ("Nothing is stacked at first. There are four white blocks. Build a tower of three.",
         "At the start, nothing is on the four white blocks",
         "Three white blocks must form a tower of exactly three."),
        ("There are two white blocks in a row and a pink block all by itself. Put the pink block on a white one.",
         "At the start, the two white blocks are in a row. At the start, the pink block is apart from white block 1. "
         "At the start, the pink block is apart from white block 2",
         "The pink block must be on white block 1."),
        ("From: a row of red, white and pink. To: a row of pink, white and red.",
         "At the start, the three blocks are in a row from left to right in the order red, white, pink",
         "The three blocks must be in a row from left to right in the order pink, white, red."),
        ("Take the white block off the mat and leave the pink one on it.",
         "At the start, the white block is on the gray patch. At the start, the pink block is on the gray patch",
         "The white block must not be on the gray patch. The pink block must be on the gray patch."),
        ("At the start there are two white blocks on two pink blocks. Take the white blocks off the pink ones.",
         "At the start, white block 1 is on pink block 1 and white block 2 is on pink block 2",
         "White block 1 must not be somewhere above pink block 1. White block 2 must not be somewhere above pink block "
         "1. White block 1 must not be somewhere above pink block 2. White block 2 must not be somewhere above pink "
         "block 2."),
    ],
)  # fmt: skip
def test_what_is_there_at_the_start(text: str, start: str, end: str) -> None:
    assert start_and_end(text) == (start, end)


@pytest.mark.parametrize(
    "text",
    [
        "white = left, pink = right",
        "Put white next to pink, white left.",
        "A white and a pink tower of two, the pink one right.",
        "Put white on the mat; the pink block is left.",
        "There is a white tower of three and a pink block on the mat. Put the pink block on the tower.",
        "There is a tower of white on pink and a green block by itself on the mat. Swap green and white.",
        "At the start a pink block is on the mat. Put a white one on that one.",
        "Four blocks of the same colour. Stack them, with a different one on top.",
        "A row of white and pink, the green block to one side.",
        "Take the pink blocks off the white ones. There are two of each.",
    ],
)
def test_of_which_it_is_said(text: str) -> None:
    assert code_of(text) == "ambiguous"


@pytest.mark.parametrize(
    "text",
    [
        "Leave one pink block on the mat and take the other two off.",
        "Take one of the two pink blocks off the mat and leave the other one.",
        "The white block is left on the mat, the pink one is taken off.",
        "The pink block comes off the white one and the white one off the mat.",
        "On the left a tower of two pink blocks, on the right the same thing in white.",
        "e is on a, and i is on e",
        "from: white pink green in a row. to: green pink white",
    ],
)
def test_what_is_not_told(text: str) -> None:
    assert code_of(text) in ("misplaced", "misplaced-word", "no-goal")
