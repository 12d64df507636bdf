"""What is so, and in the next sentence what should be so: which of it is the start, and which the end."""

from __future__ import annotations

import pytest

from tests.language.meaning import code_of, start_and_end


@pytest.mark.parametrize(
    ("text", "start", "goal"),
    [
        ("The A is on the B. The B should be on the C.", "A block is on the B block", "B block must be on the C"),
        ("A is left of B. B should be on A.", "A block is to the left of the B", "B block must be on the A"),
        ("A, B and C are stacked. C should be on the table.", "are stacked", "C block must be on the table"),
        ("Red is on the mat. Blue is on red. Blue must be on the table.", "on the red block", "be on the table"),
    ],
)
def test_what_is_to_be_elsewhere_is_so_at_the_start_alone(text: str, start: str, goal: str) -> None:
    begun, end = start_and_end(text)
    assert start in begun
    assert goal in end
    assert end.count(" must ") == 1


@pytest.mark.parametrize(
    ("text", "fact"),
    [
        ("The A is left of the B. The C should be between them.", "to the left of the B block"),
        ("The red block is on the mat. The blue one should be there too.", "on the gray patch"),
        ("The red block is on the blue block. The green block should be on the red block.", "on the blue block"),
    ],
)
def test_what_nothing_moves_is_so_at_the_start_and_at_the_end(text: str, fact: str) -> None:
    begun, end = start_and_end(text)
    assert fact in begun
    assert fact in end


@pytest.mark.parametrize(
    "text",
    [
        "The red block must be on the blue block. The green block must be on the red block.",
        "The red block is on the blue block. The green block is on the red block.",
        "The red cube is on the yellow cube. The blue cube must not be on it.",
    ],
)
def test_what_is_said_in_one_way_is_all_of_the_end(text: str) -> None:
    assert start_and_end(text)[0] == ""


def test_what_is_so_now_is_the_start() -> None:
    begun, end = start_and_end("Put A on B. B is now on C.")
    assert "B block is on the C block" in begun
    assert "on the C block" not in end


def test_no_more_than_one_of_three_that_are_there_is_a_change() -> None:
    begun, end = start_and_end("Three red blocks are on the mat. Don't leave more than one there.")
    assert "three red blocks are on the gray patch" in begun
    assert "At most one of the three red blocks must be on the gray patch" in end


def test_moved_off_is_off() -> None:
    begun, end = start_and_end("Three red blocks are on the mat. At least one should be moved off.")
    assert "three red blocks are on the gray patch" in begun
    assert "At least one of the three red blocks must not be on the gray patch" in end


def test_what_is_swapped_is_told_of_before() -> None:
    begun, end = start_and_end("The red block is on the mat. The blue one is not. Swap them.")
    assert "red block is on the gray patch" in begun
    assert "blue block is not on the gray patch" in begun
    assert "must swap places" in end
    begun, end = start_and_end("There is a row of A, B and C. Put D at the left end and E at the right end.")
    assert "the blocks A, B and C are in a row" in begun
    assert "The five blocks must be in a row with the D block at the left end and the E block at the right end" in end
    swapped = "Two red blocks are on the patch and two blue ones are not. They should change places."
    assert code_of(swapped) == "ambiguous"


@pytest.mark.parametrize(
    ("wish", "goal"),
    [
        ("Exactly one should remain.", "Exactly one of the three red blocks must be on the gray patch"),
        ("None should remain.", "The gray patch must be empty"),
        ("At most two should stay.", "At most two of the three red blocks must be on the gray patch"),
        ("Leave two there.", "Exactly two of the three red blocks must be on the gray patch"),
    ],
)
def test_so_many_remain_where_they_were_told_to_be(wish: str, goal: str) -> None:
    begun, end = start_and_end(f"Three red blocks are on the mat. {wish}")
    assert "three red blocks are on the gray patch" in begun
    assert end.endswith(goal) or end.endswith(goal + ".")
    assert end.count(" must ") == 1


@pytest.mark.parametrize(
    "text",
    [
        "I'd like the three green blocks in a bunch and the blue one nowhere near them.",
        "The three green blocks in a pile and the blue one far from them.",
    ],
)
def test_a_heap_that_others_are_placed_by_is_wanted(text: str) -> None:
    begun, end = start_and_end(text)
    assert begun == ""
    assert "three green blocks must be in one group" in end


@pytest.mark.parametrize("then", ["Put one of them on the mat.", "Line them up.", "Stack two of them."])
def test_a_heap_of_which_something_is_made_is_there(then: str) -> None:
    assert "lie in a heap" in start_and_end(f"Three green blocks in a heap. {then}")[0]


def test_a_line_that_is_there_goes_the_other_way() -> None:
    assert (
        "must be side by side in a row"
        in start_and_end("Four blocks stand one behind the other. They should be side by side.")[1]
    )
    told = start_and_end("A, C and B are in a row from left to right. They should be in a line in alphabetical order.")[
        1
    ]
    assert "column" not in told
