"""A row of letters and digits told part by part."""

from __future__ import annotations

import pytest

from tests.language.frames.told import told


@pytest.mark.parametrize(
    ("text", "plain"),
    [
        ("A, B and C in a row", "Lay the blocks A, B and C in a row."),
        ("c a b in a row from left to right", "Lay the blocks C, A and B in a row from left to right: C, A, B."),
        (
            "red next to blue, blue next to green, in a row",
            "Lay 1 red block and 1 blue block and 1 green block in a row. The red block is next to the blue block. "
            "The blue block is next to the green block.",
        ),
        (
            "Put B directly to the left of A and C to the right of A, all in a row.",
            "Lay the blocks B, A and C in a row from left to right: B, A, C.",
        ),
        ("Row. Letters. C, B, A. Left to right.", "Lay the blocks C, B and A in a row from left to right: C, B, A."),
        (
            "line up alphabetically: M, A, R, K",
            "Lay the blocks M, A, R and K in a line in alphabetical order.",
        ),
        (
            "letters m, k, l sorted a-z front to back",
            "Lay the blocks M, K and L in a column in alphabetical order from front to back.",
        ),
        (
            "digits 1 through 6 in a row, even ones first, then the odd ones, ascending within each part",
            "Lay the blocks 1, 2, 3, 4, 5 and 6 in a row in ascending order from left to right with the even numbers "
            "before the odd numbers.",
        ),
        (
            "consonants on the left, vowels on the right, one row: E, B, C",
            "Lay the blocks E, B and C in a row from left to right with the consonants before the vowels.",
        ),
        (
            "numeric order, biggest on the left: 3 8 1 6, all in a row",
            "Lay the blocks 3, 8, 1 and 6 in a row in ascending order from right to left.",
        ),
        (
            "Z to V, letters, in a row",
            "Lay the blocks Z, Y, X, W and V in a row in reverse alphabetical order.",
        ),
        (
            "put the numbers one to four in a row, 5 cm apart",
            "Lay the blocks 1, 2, 3 and 4 in a row. The blocks are 5 cm apart.",
        ),
        (
            "I put digits 2, 4, 6 in a row with smallest at right side and biggest at left side.",
            "Lay the blocks 2, 4 and 6 in a row in ascending order from right to left.",
        ),
        (
            "The letters A, B, C and D stand in a row, but D comes first and A comes last, and B is to the left of C.",
            "Lay the blocks A, B, C and D in a row from left to right: D, B, C, A.",
        ),
        (
            "Row of A, B and a red block, with the red block in the middle.",
            "Lay the blocks A and B and 1 red block in a row with the red block in the middle.",
        ),
        (
            "Place letter C between letters A and B in a row.",
            "Lay the blocks C, A and B in a row with A and B at the ends.",
        ),
        ("the letters A to E in a row except C", "Lay the blocks A, B, D and E in a row."),
        ("row letters: A x2, B x1", "Lay the blocks A, A and B in a row from left to right: A, A, B."),
        (
            "In one row, the vowels A and E on the right, the consonants B, C and D on the left",
            "Lay the blocks A, E, B, C and D in a row from left to right with the consonants before the vowels.",
        ),
        (
            "Five digits in a row, descending, starting with 8 and ending with 4",
            "Lay the blocks 4, 5, 6, 7 and 8 in a row in descending order from left to right.",
        ),
        (
            "P, Q and R in a row in the order named",
            "Lay the blocks P, Q and R in a row from left to right: P, Q, R.",
        ),
        (
            "3 letters and 2 digits in a line, A 1 B 2 C",
            "Lay the blocks A, 1, B, 2 and C in a line from left to right: A, 1, B, 2, C.",
        ),
        ("even numbers from 2 to 8 in a row, ascending", "Lay the blocks 2, 4, 6 and 8 in a row in ascending order."),
        (
            "Please place A and B at the two ends of a row and the blocks C and D between them.",
            "Lay the blocks A, B, C and D in a row with A and B at the ends.",
        ),
    ],
)
def test_parts_are_put_together(text: str, plain: str) -> None:
    assert told(text) == plain


@pytest.mark.parametrize(
    "text",
    [
        "line up A, B and C, A not next to B",
        "the row C, A, B shall be in alphabetical order",  # it stands there already
        "the letters C, A, B stand in a row. Put them in alphabetical order.",
        "three letters, 1, 2 and 3, stand in a row",
        "letters A, B, C in a row, biggest first",
        "line up 1, 2 and 3 from low to high, with the biggest on the left",
        "numbers 2 to 5 in a row, the biggest is on the left",  # and the others?
        "line up A and B, C and D",
        "a column that reads A, B, C",  # from which end?
        "a row in the order A, B, C in reverse order",
        "a row of three: A, B",
        "a row of blocks rising from 1 to 3",
        "row of A B C D, even before odd",
        "put A, B and C in a row or in a column",
        "line up A, C, B in order",
        "Line up A, B and C so that A is left of B and C is left of A and B is left of C",
        "A, B, C in a row from left to right; then C, B, A",
        "row with the vowels A, B on the left and the consonants C, D on the right",
        "3 letters and 3 digits in a line, A 1 B 2 C",
        "the vowels A and E in a row with the digits 1 and 2 left of them",
    ],
)
def test_what_is_not_clear_is_not_told(text: str) -> None:
    assert told(text) is None
