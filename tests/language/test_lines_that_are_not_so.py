"""What a line is not to be, told where it is made; and numbers and sizes that rise or fall along one."""

from __future__ import annotations

import pytest

from tests.language.meaning import code_of, means


@pytest.mark.parametrize(
    ("text", "meaning"),
    [
        ("Put the digits 1, 2 and 3 in a row, but not in ascending order from left to right.",
         "The blocks 1, 2 and 3 must not be in a row from left to right in ascending numerical order."),
        ("Put P, Q and R in a row that is not in alphabetical order from either end.",
         "The blocks P, Q and R must not be in a line in alphabetical order in either direction."),
        ("Put H, I, D and E in a row that does not spell HIDE.",
         "The blocks H, I, D and E must not spell the word HIDE."),
        ("S, E and A in a row, in any order but SEA.", "The blocks S, E and A must not spell the word SEA."),
        ("Stack red, green and blue, but not with red at the bottom.",
         "The red, green and blue blocks must not form a tower with the red block at the bottom."),
    ],
)  # fmt: skip
def test_lines_that_are_not_so(text: str, meaning: str) -> None:
    assert means(text).replace("\n", " ").endswith(meaning)


@pytest.mark.parametrize(
    ("text", "meaning"),
    [
        ("Stack the cubes 2, 3 and 5 such that the digits strictly decrease from the bottom to the top.",
         "stacked from bottom to top in descending numerical order."),
        ("Stack a 6 cm blue cube, a 5 cm red one and a 3 cm yellow one so that the size decreases from bottom to top.",
         "stacked from bottom to top by decreasing size."),
        ("Place the cubes 1 to 5 in one column. The numbers must increase with distance.",
         "in a column on the table from front to back in ascending numerical order."),
        ("Line up 2, 3, 4 and 5 so that each one is bigger than the one on its right.",
         "in a row from right to left in ascending numerical order."),
        ("Stack 2, 3 and 4 so that each cube shows a smaller number than the one under it.",
         "stacked from bottom to top in descending numerical order."),
        ("Make a tower of 2, 3 and 4 whose numbers get bigger towards the top.",
         "from bottom to top in ascending numerical order."),
    ],
)  # fmt: skip
def test_numbers_and_sizes_that_change_along_a_line(text: str, meaning: str) -> None:
    assert means(text).replace("\n", " ").endswith(meaning)


@pytest.mark.parametrize(
    ("text", "code"),
    [
        ("Stack A, B and C. They must not be in alphabetical order.", "ambiguous"),
        ("The digits 1 to 8 in a row from left to right, not ascending.", "incomplete"),
        ("Put the blocks in a row, not in a tower.", "misplaced"),
        ("Put A, B, C and D in a 2x2 grid with A and D in opposite corners.", "ambiguous"),
    ],
)
def test_what_is_still_open(text: str, code: str) -> None:
    assert code_of(text) == code
