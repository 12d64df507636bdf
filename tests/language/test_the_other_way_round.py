""" "The other way round", of relations, of towers and rows that are there, and of their order."""

from __future__ import annotations

import pytest

from tests.language.meaning import code_of, start_and_end

_REVERSED = "The blue, green and red blocks must form a tower of exactly three from bottom to top in the order blue, " \
    "green, red."  # fmt: skip


@pytest.mark.parametrize(
    ("text", "end"),
    [
        ("Red is on blue. Make it the other way round.", "The blue block must be on the red block."),
        ("Red is on blue. At the end it is the other way round.", "The blue block must be on the red block."),
        ("There's a red block on a yellow block on a blue block. Make it the other way round.",
         "The yellow block must be on the red block. The blue block must be on the yellow block."),
        ("Red is left of blue. Make it the other way round.", "The blue block must be to the left of the red block."),
        ("There is a tower of red, green and blue from bottom to top. The order should be the other way round.",
         _REVERSED),
        ("Start: a stack with red at the bottom, green in the middle and blue at the top. Goal: the order of this "
         "stack is reversed.", _REVERSED),
        ("Blocks 1 to 4 start in a row in this order from left to right. At the end the order is the other way round.",
         "The four blocks must be in a row from left to right in the order 4, 3, 2, 1."),
        ("The start is a tower of red, green and blue from bottom to top. The end is the same tower, just the other "
         "way round.", _REVERSED),
        ("Start: red, green and blue in a tower, from the bottom. Goal: the same three in reverse order.", _REVERSED),
        ("Red is on blue, which is on green. Turn the tower upside down.",
         "The red, blue and green blocks must form a tower of exactly three from bottom to top in the order red, blue, "
         "green."),
    ],
)  # fmt: skip
def test_what_it_comes_to(text: str, end: str) -> None:
    start, then = start_and_end(text)
    assert (start != "", then) == (True, end)


@pytest.mark.parametrize(
    "text",
    ["Red is on the mat and blue is off it. At the end it is the other way round.", "Make it the other way round."],
)
def test_where_nothing_was_told_to_turn(text: str) -> None:
    assert code_of(text) in ("no-referent", "no-goal", "ambiguous")


@pytest.mark.parametrize(
    ("text", "end"),
    [
        ("Start is red on blue, end is blue on red.", "The blue block must be on the red block."),
        ("The start is a tower of three red blocks, the goal is a row of three.",
         "The three red blocks must be in a row."),
        ("At the start the row from left to right is red, blue, red. It has to become red, red, blue.",
         "The two red blocks and the blue block must be in a row from left to right in the order red, red, blue."),
        ("There are two towers of two: red on blue, and green on yellow. Swap the tops.",
         "The red block and the green block must swap places. The red block must be on the yellow block. The green "
         "block must be on the blue block."),
    ],
)  # fmt: skip
def test_start_and_end_in_one_breath(text: str, end: str) -> None:
    start, then = start_and_end(text)
    assert (start != "", then) == (True, end)
