"""What is told behind a list of what there is, is told of the whole list, and what is said of it is not lost."""

from __future__ import annotations

import pytest

from tests.language.meaning import code_of, means

FOUR = "There are two red blocks and two blue blocks."
BOTH = "The two red blocks and the two blue blocks must"


@pytest.mark.parametrize(
    ("text", "meaning"),
    [
        ("There are two red and two blue blocks: a row in alternating colours.",
         f"{FOUR} {BOTH} be in a row with alternating colors."),
        ("On the table are two red and two blue blocks: a tower.", f"{FOUR} {BOTH} form a tower of exactly four."),
        ("Given are two red and two blue blocks: a tower.", f"{FOUR} {BOTH} form a tower of exactly four."),
        ("There are two red and two blue blocks, all of them on the mat.",
         f"{FOUR} There is a gray patch. {BOTH} be on the gray patch."),
        ("There are three red, two blue and two black blocks: one tower for each colour.",
         "There are three red blocks, two blue blocks and two black blocks. The three red blocks, the two blue blocks "
         "and the two black blocks must form three towers, each of a different color."),
        ("You get a red block, a blue block and two green ones: they should be in a line.",
         "There are a red block, a blue block and two green blocks. The red block, the blue block and the two green "
         "blocks must be in a line."),
        ("There is a red block, and a blue block on the mat.",
         "There are a red block and a blue block. There is a gray patch. The red and blue blocks must be on the gray "
         "patch."),
        # what comes behind a list all the same
        ("There is a red block, and a blue block must be on the mat.",
         "There is a blue block. There is a gray patch. There is also a red block as a distractor. The blue block must "
         "be on the gray patch."),
        ("At first 3, 2, 1 stand in a row from left to right, at the end they should be 1, 2, 3 from left to right.",
         "There are a 3 block, a 2 block and a 1 block. At the start, the three blocks are in a row from left to right "
         "in the order 3, 2, 1. The three blocks must be in a row from left to right in the order 1, 2, 3."),
        ("A red block in the middle of the table, with a blue one on each of its four sides.",
         "There are a red block and four blue blocks. The red block and the four blue blocks must form a plus sign in "
         "the order two blue blocks, then the red block, then two blue blocks. The red block must be in the middle of "
         "the table."),
        ("A tower of three red blocks, centred on the gray patch.",
         "There are three red blocks. There is a gray patch. The three red blocks must form a tower of exactly three "
         "on the gray patch. The tower of the three red blocks must be at most 2 cm from the gray patch."),
    ],
)  # fmt: skip
def test_the_whole_list_is_meant(text: str, meaning: str) -> None:
    assert means(text) == meaning


@pytest.mark.parametrize(
    "text",
    [
        "There should be a red tower and a blue tower, standing on the gray patch.",  # one of them, or both
        "Make a 2x2 square of green blocks, centred on the gray patch.",
        "Put the block 20 cm to the left of the patch, in line with it.",
        "A square of eight red blocks with a blue one in the middle, three layers high.",
        "The blocks A and B are in a row. The block A is C.",
    ],
)
def test_what_would_be_lost_is_refused(text: str) -> None:
    assert code_of(text)
