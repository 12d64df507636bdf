"""One block after the other where the place is told once, and what alone may be moved."""

from __future__ import annotations

import pytest

from tests.language.meaning import means, start_and_end


@pytest.mark.parametrize(
    "text",
    (
        "Put yellow on the mat, then green, then blue.",
        "First put yellow on the mat, then green and then blue.",
        "The yellow block goes on the mat, then the green block, then the blue block.",
    ),
)
def test_the_place_is_the_same(text: str) -> None:
    told = means(text)
    assert "First, the yellow block must be on the gray patch. Then, the green block must be on the gray patch." in told
    assert "Finally, the blue block must be on the gray patch." in told


@pytest.mark.parametrize(
    "text",
    (
        "Put red on the mat, then blue on top of it, then green.",
        "Put red on the mat, then blue on top of it, then green on top of that.",
    ),
)
def test_what_comes_on_top(text: str) -> None:
    told = means(text)
    assert "Then, the blue block must be on the red block. Finally, the green block must be on the blue block." in told


def test_down_from_the_top() -> None:
    told = means("Build a tower, green on top, then blue, then red.")
    assert "from bottom to top in the order red, blue, green" in told


def test_another_place_is_another() -> None:
    told = means("Put A on the mat, then B on top of it, then C next to the mat.")
    assert "Finally, the C block must be next to the gray patch." in told
    assert "must be on the yellow block" in means("Put red on top of blue, then green on top of yellow.")


@pytest.mark.parametrize(
    "text",
    (
        "Nothing may be moved except the white cube. Put it on the black cube.",
        "You may only move the white cube. Put the white cube on the black cube.",
        "Only the white cube may be moved. The white cube must be on the black cube.",
    ),
)
def test_what_alone_may_be_moved(text: str) -> None:
    told = means(text)
    assert "The white block must be on the black block. The black block must stay where it is." in told


def test_where_another_is() -> None:
    told = means("The blue cube has to end up where the red cube is now, and the red cube where the blue cube is.")
    assert "The blue block and the red block must swap places." in told
    told = means("Red goes where blue is now and blue goes where green is now.")
    assert "swap" not in told and "The blue block must be where the green block was at the start." in told


def test_lines_at_both_ends() -> None:
    start, end = start_and_end("Reverse the tower of three cubes, which is red, white, blue from the bottom.")
    assert "from bottom to top in the order red, white, blue" in start
    assert "from bottom to top in the order blue, white, red" in end
    _, end = start_and_end("The final tower has the order yellow, orange, red from the bottom up.")
    assert "from bottom to top in the order yellow, orange, red" in end


def test_never_even_for_a_moment() -> None:
    told = means("Red must never be on green, not even temporarily. Put red on blue and blue on green.")
    assert "The red block must never be on the green block." in told


def test_what_lies_on_the_mats_is_swapped() -> None:
    told = means("Swap the blocks on the two patches. A is on the red patch, B on the green patch.")
    assert "At the start, the A block is on the red patch." in told
    assert "The A block and the B block must swap places." in told


def test_steps_with_stops_behind_their_numbers() -> None:
    told = means("Step 1. Put red on blue. Step 2. Put green on red.")
    assert "First, the red block must be on the blue block. Then, the green block must be on the red block." in told


def test_which_line_is_changed() -> None:
    start, end = start_and_end("Swap the first and the last cube in the row red, yellow, green, blue.")
    assert "from left to right in the order red, yellow, green, blue" in start
    assert "from left to right in the order blue, yellow, green, red" in end
    start, end = start_and_end("Change the order of the tower from red-green-blue to blue-red-green (bottom to top).")
    assert "from bottom to top in the order red, green, blue" in start
    assert "from bottom to top in the order blue, red, green" in end
    assert "At the start" not in means("In a row of red, green and blue, green must be in the middle.")


def test_what_is_forbidden_under_a_heading() -> None:
    told = means("Goal: black on white. Forbidden: white on black.")
    assert "The white block must never be on the black block." in told
    assert "must never be next to the blue block" in means("Never: red next to blue. Goal: red and blue on the mat.")


def test_what_is_cleared_first() -> None:
    told = means("Clear the mat first. A red block is on it.")
    assert "At the start, the red block is on the gray patch." in told
    told = means("Clear the mat first. Then put a red block on it.")
    assert "First, the gray patch must be empty. Then, the red block must be on the gray patch." in told
