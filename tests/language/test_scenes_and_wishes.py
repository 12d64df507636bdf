"""Scenes that are told, and what is wanted behind them: which of it is the start, and which the end."""

from __future__ import annotations

import pytest

from tests.language.meaning import code_of, start_and_end


@pytest.mark.parametrize(
    ("text", "ends"),
    [
        (
            "There is a row with black, white, white, black from left to right, and on each of the white cubes sits a "
            "pink one.",
            ("in the order black, white, white, black", "A pink block must be on white block 1"),
        ),
        (
            "There are three red blocks in a row and a blue block lies behind the middle one.",
            ("three red blocks must be in a row", "must be behind a red block"),
        ),
        ("There is the word CAT in a row, and a red block lies on the A.", ("spell the word CAT", "on the A block")),
    ],
)
def test_a_scene_without_a_command_is_all_of_it_wanted(text: str, ends: tuple[str, ...]) -> None:
    begun, end = start_and_end(text)
    assert begun == ""
    assert all(told in end for told in ends)


@pytest.mark.parametrize(
    "text",
    [
        "There is a row with black and white from left to right. Put a pink block on the white one.",
        "There is a row with black and white from left to right, and a pink block should be on the white one.",
    ],
)
def test_a_scene_with_a_wish_behind_it_is_there(text: str) -> None:
    begun, end = start_and_end(text)
    assert "in the order black, white" in begun
    assert "pink block must be on the white block" in end


@pytest.mark.parametrize(
    ("text", "left"),
    [
        ("Move every red block off the mat but leave the blue one on it.", "the blue block is on the gray patch"),
        ("Take A off B but leave B on C.", "the B block is on the C block"),
        ("Take one of the three red blocks off the mat and leave the other two there.", "red block 2 and red block 3"),
        ("Put red on blue and leave green in the left half.", "green block is in the left half"),
    ],
)
def test_what_is_left_somewhere_was_there(text: str, left: str) -> None:
    begun, end = start_and_end(text)
    assert left.lower() in begun.lower()
    assert left.replace(" is ", " must be ").lower() in end.lower()


@pytest.mark.parametrize(
    "text",
    ["Put the red block onto the mat and leave it there.", "Take the red block and leave it on the mat.",
     "Leave a red block on the mat.", "Put red on blue and leave green on the table."],
)  # fmt: skip
def test_what_is_put_down_and_left_was_not_there(text: str) -> None:
    assert start_and_end(text)[0] == ""


@pytest.mark.parametrize(
    ("text", "fact"),
    [
        ("The blue block is on the mat, the red block must be to the left of the blue block.", "on the gray patch"),
        ("A is on the mat and B should be too.", "on the gray patch"),
        ("Red is on blue and green has to be next to blue.", "on the blue block"),
        ("A, B and C form a row, and D has to be behind B.", "in a row"),
        ("Six blue blocks form a pyramid. A red block should be in front of it.", "form a pyramid"),
        ("The red block is on the mat and I'd like the blue one next to the red one.", "on the gray patch"),
    ],
)
def test_what_is_so_beside_a_wish_is_so_at_both_ends(text: str, fact: str) -> None:
    begun, end = start_and_end(text)
    assert fact in begun
    assert fact in end


@pytest.mark.parametrize(
    ("text", "start", "goal"),
    [
        ("The red block is on the mat and should be on the blue block.", "on the gray patch", "on the blue block"),
        ("The red block isn't on the mat. It should be.", "is not on the gray patch", "must be on the gray patch"),
        ("The red block is on the mat, but it shouldn't be.", "is on the gray patch", "must not be on the gray patch"),
        ("A, B and C are on the mat. Only A should be.", "blocks A, B and C are", "B block must not be on the gray"),
        ("Five red blocks are on the mat. At most two should be.", "five red blocks are", "At most two of the five"),
        ("Five blocks form a tower. They should form a row.", "a tower of exactly five", "must be in a row"),
    ],
)
def test_what_is_changed_is_so_at_the_start_alone(text: str, start: str, goal: str) -> None:
    begun, end = start_and_end(text)
    assert start in begun
    assert goal in end
    assert start.replace(" is ", " must be ").replace(" are ", " must be ") not in end


def test_in_one_tense_and_in_relative_clauses_it_is_all_the_end() -> None:
    for text in (
        "The gray cube lies between the two orange cubes, which must be 20 cm apart.",
        "A row of red and blue is on the mat and a yellow block is behind it.",
    ):
        assert start_and_end(text)[0] == ""


@pytest.mark.parametrize(
    "text",
    [
        "The red block lies on the mat, but the blue one should lie there.",
        "The blue block has a red block on it. Put it on the mat.",
        "The blue block carries a red block. It should be on the mat.",
        "There is a blue block with a red block on it. Put it on the mat.",
    ],
)
def test_what_may_be_either_is_asked(text: str) -> None:
    assert code_of(text) == "ambiguous"


def test_what_carries_something_is_a_fact_and_can_lose_it() -> None:
    begun, end = start_and_end("The blue block carries a red block. The red block should be on the mat.")
    assert "red block is on the blue block" in begun
    assert "on the blue block" not in end
    assert "must not" in start_and_end("The blue block has a red block on it. Take it off.")[1]


@pytest.mark.parametrize(
    ("text", "start"),
    [
        ("Imagine there is a tower of three blue blocks. Put a red block beside it.", "a tower of exactly three"),
        ("See the red block on the mat? Put the blue one on top of it.", "on the gray patch"),
    ],
)
def test_what_is_imagined_is_there(text: str, start: str) -> None:
    assert start in start_and_end(text)[0]
    assert start_and_end("Imagine a tower of three red blocks. Build it!")[0] == ""


@pytest.mark.parametrize(
    ("text", "goal"),
    [
        ("There is a row: red, blue, green. Put a yellow block at its left end.", "in the order yellow, red, blue"),
        ("A, B and C are in a row from left to right. Put D at the right end.", "in the order A, B, C, D"),
        ("There is a row of three red blocks, and a blue one should be at its right end.", "blue block at the right"),
        ("There is a row of three red blocks. Put a blue block at each end.", "a blue block, then the three red"),
    ],
)
def test_a_line_that_is_there_is_made_longer(text: str, goal: str) -> None:
    begun, end = start_and_end(text)
    assert "in a row" in begun
    assert goal in end


def test_a_side_is_no_end_of_a_line() -> None:
    assert code_of("There is a row of three red blocks. Put a blue block on the left.") == "ambiguous"


def test_a_ring_that_is_there_is_filled_then() -> None:
    begun, end = start_and_end("There is a circle of six white blocks. Put a red block in the middle of it.")
    assert "six white blocks form a circle" in begun
    assert "must form a filled circle" in end


def test_a_list_is_not_cut_before_its_last() -> None:
    end = start_and_end("Build a row of red, blue and green from left to right, with a yellow block at the left end.")[
        1
    ]
    assert "in the order yellow, red, blue, green" in end


def test_what_a_patch_is_not_cleared_of_stays() -> None:
    begun, end = start_and_end(
        "There are a green, a red and a blue block on the mat. Clear the mat except for the green block."
    )
    assert "green, red and blue blocks are on the gray patch" in begun
    assert "green block must be on the gray patch" in end
    assert "empty" not in end
    assert code_of("Clear the mat except for the green block.") == "ambiguous"


@pytest.mark.parametrize(
    "text",
    [
        "The red block was on the mat and is now on the blue one. Put it back.",
        "The red block was on the mat. Now it is on the blue one. Put it back.",
        "The red block was on the mat but is now on the blue one. Put it back on the mat.",
    ],
)
def test_where_it_was_before_is_not_the_start(text: str) -> None:
    begun, end = start_and_end(text)
    assert begun == "At the start, the red block is on the blue block"
    assert end == "The red block must be on the gray patch."


def test_what_was_so_is_the_start_of_what_is_so_now() -> None:
    begun, end = start_and_end("The red block was on the mat. Now it is on the blue block.")
    assert "on the gray patch" in begun
    assert "on the blue block" in end
