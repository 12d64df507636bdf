"""Lines as they are noted down, and their order before and after."""

from __future__ import annotations

import pytest

from tests.language.meaning import means, start_and_end

UP = "from bottom to top in the order"


@pytest.mark.parametrize(
    "text",
    (
        "start: tower, red bottom, green middle, blue top. goal: same tower reversed",
        "Start: tower red (bottom), green, blue (top). Goal: tower blue (bottom), green, red (top).",
        "Start: three stacked blocks (red at the bottom, green in the middle, blue on top). Goal: same tower reversed.",
        "The tower currently reads (top to bottom) blue, green, red. After the task it should read red, green, blue.",
    ),
)
def test_towers_are_noted_down(text: str) -> None:
    start, end = start_and_end(text)
    down = "from top to bottom in the order"
    assert f"{UP} red, green, blue" in start or f"{down} blue, green, red" in start
    assert f"{UP} blue, green, red" in end or f"{down} red, green, blue" in end


def test_what_is_said_of_no_end_lies_between() -> None:
    assert f"{UP} red, green, blue" in means("Goal: a tower: red at the bottom, green, blue at the top.")
    assert f"{UP} white, green, blue, red" in means("Stack four cubes: red on top, blue, green, white at the bottom.")
    assert "order" not in means("Build a tower with A at the bottom, B and C on top.")


def test_ends_in_brackets() -> None:
    told = means("Unstack the tower of three letters A, B, C (A on top) and line the letters up alphabetically.")
    assert "form a tower of exactly three with the A block on top" in told
    assert "in alphabetical order" in told


def test_verbs_are_no_lines() -> None:
    assert "must be in a line" in means("Goal: line up A, B and C.")
    assert "There is a pyramid" not in means("Goal: stack with red at the bottom and blue on top.")


def test_the_block_on_top_of_a_tower() -> None:
    start, end = start_and_end(
        "Take the yellow block from the top of the tower of red, green and yellow and place it on the patch."
    )
    assert start.endswith("with the yellow block on top")
    assert "The yellow block must be on the gray patch" in end


def test_a_demo_ends_as_an_episode_does() -> None:
    assert "The cyan block must be on the brown block." in means(
        "The demo ends with the cyan block on top of the brown block."
    )
    start, end = start_and_end("The clip starts with red on blue and ends with blue on red.")
    assert "the red block is on the blue block" in start and "The blue block must be on the red block" in end


def test_a_mat_that_is_empty_at_first() -> None:
    start, end = start_and_end("Start: mat empty, red and blue scattered. Goal: red on the mat, blue on red.")
    assert "At the start, the gray patch is empty" in start
    assert "The red block must be on the gray patch" in end
