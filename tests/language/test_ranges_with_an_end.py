"""A range of symbols in a line, with its first or its last at an end, is in sequence; and digits that have a place."""

from __future__ import annotations

import pytest

from tests.language.meaning import code_of, means, start_and_end

ROW, COLUMN = "in a row from left to right", "in a column on the table from front to back"


@pytest.mark.parametrize(
    ("text", "line", "order"),
    [
        ("letters A to E in a column, A at the far end", COLUMN, "E, D, C, B, A"),
        ("the first five letters of the alphabet in a row with A on the left", ROW, "A, B, C, D, E"),
        ("Put 1 to 5 in a line, 5 on the right", ROW, "1, 2, 3, 4, 5"),
        ("Line up the letters A to E. The E must be on the far left.", ROW, "E, D, C, B, A"),
        ("letters A to E in a row with A on the left and C in the middle", ROW, "A, B, C, D, E"),
        ("the digits 1 to 5 in a tower with 1 at the bottom", "stacked from bottom to top", "1, 2, 3, 4, 5"),
        ("the numbers 1 to 5 in a row with 1 on the left and 5 on the right", ROW, "1, 2, 3, 4, 5"),
        ("Put the cubes labelled 1 to 5 in a row with 5 on the left", ROW, "5, 4, 3, 2, 1"),
    ],
)
def test_a_range_follows_from_its_end(text: str, line: str, order: str) -> None:
    assert start_and_end(text)[1] == f"The five blocks must be {line} in the order {order}."


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ("A, B, C, D in a row with A on the left", "in a row with the A block at the left end."),
        ("the numbers 1 to 5 in a row with 3 on the left", "in a row with the 3 block at the left end."),
        (
            "a row of the numbers one, two, three and four, one on the left",
            "in a row with the 1 block at the left end.",
        ),
        ("Line up the letters A to E in any order. A is on the left.", "in a row with the A block at the left end."),
        ("the numbers 1, 2, 3 and 4 in a row with 4 on the left", "in a row with the 4 block at the left end."),
        ("letters A to E in a row, A on the left, E in second place", "then the blocks B, C and D in no fixed order."),
        ("a red block and the letters A to D in a row, A on the left", "in a row with the A block at the left end."),
    ],
)
def test_others_stand_in_no_order(text: str, told: str) -> None:
    assert means(text).replace("\n", " ").endswith(told)


def test_where_the_end_is_not_says_nothing_of_the_others() -> None:
    told = start_and_end("letters A to E in a row, A not on the left")[1]
    assert "must not be in a row with the A block at the left end" in told


@pytest.mark.parametrize(
    "text",
    ["Build a row with 3 on the left", "Build a tower with 4 at the bottom", "A, B and C in a row with 2 on the left",
     "Two red and two blue blocks in a row with 2 on the left"],
)  # fmt: skip
def test_a_lone_number_may_be_so_many(text: str) -> None:
    assert code_of(text) in ("ambiguous", "count-mismatch")
