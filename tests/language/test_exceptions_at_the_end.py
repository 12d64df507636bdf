"""Exceptions at the end of a clause, blocks of a kind out of a range, and lines of only some blocks."""

from __future__ import annotations

import pytest

from tests.language.meaning import code_of, means

HALF = "in the left half of the table"
LEFT = f"The blocks 2, 3 and 4 must be {HALF}. The 1 block must not be {HALF}."
OFF = "The red and green blocks must be on the gray patch. The blue block must not be on the gray patch."
ODD_IN_ROW = (
    "The blocks 1, 3 and 5 must be in a row. The blocks 1, 3, 5 and 2 must not be in a row. The blocks 1, 3, 5 and 4 "
    "must not be in a row."
)
ONLY_TWO = "The 2 block must be {0}. The 1 block must not be {0}. The 3 block must not be {0}.".format(
    "on the red patch"
)
EVEN_ON = "There are a 2 block and a 4 block. There is a red patch. The blocks 2 and 4 must be on the red patch."


@pytest.mark.parametrize(
    ("text", "meaning"),
    [
        ("The digits 1 to 4 all go into the left half except the 1.", LEFT),
        ("Put the digits 1 to 4 in the left half, all but the 1.", LEFT),
        ("We have the cubes 1 to 6. Line them up in order, all but the 4.",
         "The blocks 1, 2, 3, 5 and 6 must be in a row from left to right in ascending numerical order. The blocks 1 "
         "to 6 must not be in a row."),
        ("Turn F, G and H upside down, only not the G.",
         "The F block must be upside down. The H block must be upside down. The G block must not be upside down."),
        ("Put the red, the blue and the green block on the mat, but not the blue one.", OFF),
        ("There are a red, a blue and a green block. Every block goes on the mat unless it is blue.", OFF),
        ("Every digit from 1 to 3 goes on the red mat unless it is odd.", ONLY_TWO),
        ("There are the digits 1 to 5. Make a row of only the odd ones.", ODD_IN_ROW),
        ("Put the even digits from 1 to 5 on the red mat.", EVEN_ON),
        ("Put the even digits from 1 to 3 on the red mat, but not the odd ones.", ONLY_TWO),
    ],
)  # fmt: skip
def test_they_are_left_out(text: str, meaning: str) -> None:
    assert means(text).replace("\n", " ").endswith(meaning)


@pytest.mark.parametrize(
    ("text", "code"),
    [
        ("Put the red, the blue and the green block on the mat, except the yellow one.", "misplaced"),
        ("Put A on B, except the C.", "ambiguous"),
        ("Line up only the red blocks.", "ambiguous"),
    ],
)
def test_exceptions_to_nothing(text: str, code: str) -> None:
    assert code_of(text) == code
