"""What the parser reads of sizes, gaps, symbols, and of all that was told."""

from __future__ import annotations

import pytest

from tests.language.compose.test_meanings import told


@pytest.mark.parametrize(
    ("text", "meaning"),
    [
        ("Of the two pink blocks, the small one must be left of the big one.",
         "The small pink block must be to the left of the big pink block."),
        ("A tower of two big cyan cubes and a small cyan cube behind it.",
         "Big cyan block 1 and big cyan block 2 must form a tower of exactly two The small cyan block must be behind "
         "the tower of big cyan block 1 and big cyan block 2."),
        ("A row of three white blocks with 2 cm gaps between them is in front of the mat.",
         "White block 1, white block 2 and white block 3 must be in a row with gaps of 2 cm White block 1, white block "
         "2 and white block 3 must be in front of the gray patch."),
        ("The digits 1, 2 and 3 in an evenly spaced row, and a pink block on the 2.",
         "The 1 block, the 2 block and the 3 block must be in a row, evenly spaced The pink block must be on the 2 "
         "block."),
        ("The cube with the letter K on it goes behind the block that shows a 4.",
         "The K block must be behind the 4 block."),
        ("The pink block is between the green and the brown one, all three on the table.",
         "The pink block must be between the green block and the brown block The pink block must be on the table The "
         "green block must be on the table The brown block must be on the table."),
        ("Put two pink blocks on the black mat and leave the white mat empty.",
         "Pink block 1 and pink block 2 must be on the black patch The white patch must be empty."),
        ("Each of the two green blocks must have a pink block on top of it.",
         "Pink block 1 must be on green block 1 Pink block 2 must be on green block 2."),
        ("Both pink blocks are to the right of both brown blocks.",
         "Pink block 1 and pink block 2 must be to the right of brown block 1 and brown block 2."),
        ("The pink block lies on the brown one, and nothing lies on the pink one.",
         "The pink block must be on the brown block Nothing must be on the pink block."),
        ("The word GO is written behind the pink block, and the pink block must not be moved.",
         "The G block and the O block must spell the word GO The G block and the O block must be behind the pink block "
         "The pink block must stay where it is."),
        ("Pink must be about 9 cm from brown.", "The pink block must be about 9 cm from the brown block."),
        ("At least two of the four pink blocks are in the far half of the table.",
         "Pink block 1 and pink block 2 must be in the far half of the table."),
    ],
)  # fmt: skip
def test_it_is_read(text: str, meaning: str) -> None:
    assert told(text) == [meaning]


@pytest.mark.parametrize(
    "text",
    [
        "There are three pink blocks. The small one goes on the big one.",  # which of the others?
        "A big pink block and a green block. The small block goes on the green block.",
        "A 2x2 grid of pink blocks and a green block in the far left corner.",  # of the grid, or of the table
        "A pink and a green block. There is a brown block. Pink is left of green, all on the table.",
        "Pink is to the left of green. Put brown on pink.",  # so now, or to be so
        "About three of the pink blocks are on the mat.",
    ],
)
def test_what_may_be_meant_otherwise_is_not_read(text: str) -> None:
    assert told(text) == []


@pytest.mark.parametrize(
    ("text", "meaning"),
    [
        ("Three pink ones in a row behind a tower of two white ones",
         "Pink block 1, pink block 2 and pink block 3 must be in a row White block 1 and white block 2 must form a "
         "tower of exactly two Pink block 1, pink block 2 and pink block 3 must be behind the tower of white block "
         "1 and "
         "white block 2."),
        ("The word GO on the table, with the word HI behind it.",
         "The G block and the O block must spell the word GO The H block and the I block must spell the word HI The G "
         "block must be on the table The O block must be on the table The H block and the I block must be behind the G "
         "block and the O block."),
        ("Put K, C and F in alphabetical order.",
         "The C block, the F block and the K block must be in a row from left to right in alphabetical order."),
        ("Put a pink block on the white block and another pink block behind the white block",
         "Pink block 1 must be on the white block Pink block 2 must be behind the white block."),
        ("The block to the left of D is the K, and the block on top of D is the pink one.",
         "The K block must be to the left of the D block The pink block must be on the D block."),
        ("Write YES with letter cubes to the left of the pink block",
         "The Y block, the E block and the S block must spell the word YES The Y block, the E block and the S block "
         "must be to the left of the pink block."),
    ],
)  # fmt: skip
def test_what_is_told_of_lines_and_of_what_is_somewhere(text: str, meaning: str) -> None:
    assert told(text) == [meaning]
