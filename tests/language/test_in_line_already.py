"""What is told of some blocks of a line behind it: these are in that line, and in no other one."""

from __future__ import annotations

import pytest

from tests.language.meaning import means


@pytest.mark.parametrize(
    ("text", "line", "some"),
    [
        ("Line up A, B, C and E in alphabetical order, the vowels on the mat.", "in alphabetical order",
         "The blocks A and E must be on the gray patch"),
        ("Line up A to E from left to right, the vowels touching the red block.", "in the order A, B, C, D, E",
         "The E block must touch the red block"),
        ("Stack 1 to 4 in ascending order, the odd ones on the mat.", "in ascending numerical order",
         "The blocks 1 and 3 must be on the gray patch"),
        ("Line up red, blue and green from left to right, the red one on the mat.", "in the order red, blue, green",
         "The red block must be on the gray patch"),
    ],
)  # fmt: skip
def test_some_of_a_line_are_in_no_other_one(text: str, line: str, some: str) -> None:
    told = means(text)
    assert line in told
    assert some in told
    assert told.count("must be in a") + told.count("must be stacked") == 1


@pytest.mark.parametrize(
    ("text", "other"),
    [
        ("Stack the red blocks on the blue mat, the green ones on the yellow mat.",
         "The two green blocks must be stacked on the yellow patch"),
        ("Stack A, B and C on the red mat, the digits on the blue mat.",
         "The blocks 1 and 2 must be stacked on the blue patch"),
        ("Line up A, B and C from left to right, 1, 2 and 3 from right to left.",
         "The blocks 1, 2 and 3 must be in a row from right to left"),
    ],
)  # fmt: skip
def test_others_are_in_a_line_of_their_own(text: str, other: str) -> None:
    assert other in means(text)
