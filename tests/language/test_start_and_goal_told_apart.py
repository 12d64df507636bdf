"""How it begins and how it should end, told in two parts: the blocks of the one are those of the other."""

from __future__ import annotations

import pytest

from tests.language.meaning import code_of, means, start_and_end

TOWERS = "At the start, the red, blue, green, yellow, purple and orange blocks form two towers of three"


@pytest.mark.parametrize(
    "text",
    [
        "The episode starts with two towers of three cubes. At the end there should be a single tower of six.",
        "Start from two towers of three blocks each, end in one tower of six.",
    ],
)
def test_as_many_at_the_end_as_at_the_start_are_the_same(text: str) -> None:
    begun, end = start_and_end(text)
    assert begun == TOWERS
    assert end.rstrip(".") == "The red, blue, green, yellow, purple and orange blocks must form a tower of exactly six"


@pytest.mark.parametrize(
    ("before", "after"),
    [("Precondition", "Postcondition"), ("Current state", "Desired state"), ("Before", "After")],
)
def test_two_headings_are_of_the_start_and_of_the_goal(before: str, after: str) -> None:
    begun, end = start_and_end(f"{before}: red on blue. {after}: blue on red.")
    assert begun == "At the start, the red block is on the blue block"
    assert end.rstrip(".") == "The blue block must be on the red block"


def test_fewer_at_the_end_are_some_of_those_of_the_start() -> None:
    text = "There is a row of five blocks. At the end there should be a tower of three."
    begun, end = start_and_end(text)
    assert "There are five red blocks" in means(text)
    assert "the five red blocks are in a row" in begun
    assert end.rstrip(".") == "Three red blocks must form a tower of exactly three"


def test_what_is_told_of_the_end_alone_is_no_start() -> None:
    begun, end = start_and_end("At the end there are a tower of three and a row of two.")
    assert not begun
    assert "tower of exactly three" in end
    assert "The other two red blocks must be in a row" in end


def test_a_tower_that_is_taken_down_lies_block_by_block() -> None:
    text = "Take down the tower of four cubes, at the end all cubes shall be single on the table."
    begun, end = start_and_end(text)
    assert "form a tower of exactly four" in begun
    assert end.rstrip(".") == "The red, blue, green and yellow blocks must be on the table"


def test_a_reversal_is_one() -> None:
    told = "Reversal of a stack. At the start there is a tower of red and blue, at the end a tower of blue and red."
    begun, end = start_and_end(told)
    assert begun.endswith("in the order red, blue")
    assert end.rstrip(".").endswith("in the order blue, red")


def test_a_reversal_that_is_none_is_refused() -> None:
    text = "Reversal of a stack. It starts with red on green on blue and should finish with green on blue on red."
    assert code_of(text) == "misplaced-word"
