"""What is denied of a side of all others, and what is told of the next in a line."""

from __future__ import annotations

import pytest

from tests.language.meaning import code_of, means

_THERE = "There are a red, a blue and a green block. "


@pytest.mark.parametrize(
    ("text", "side"),
    [
        ("The red one must not be the leftmost.", "to the left of"),
        ("The red block must not be the rightmost block.", "to the right of"),
        ("Don't make the red one the leftmost.", "to the left of"),
        ("The red block isn't the frontmost.", "in front of"),
    ],
)
def test_not_the_leftmost_is_not_left_of_all_others(text: str, side: str) -> None:
    told = means(_THERE + text)
    blue, green = (f"The red block must not be somewhere {side} the {color} block" for color in ("blue", "green"))
    assert f"{blue} or {green[:1].lower()}{green[1:]}." in told
    assert "half of the table" not in told


def test_the_leftmost_is_left_of_all_others() -> None:
    told = means(_THERE + "The red one must be the leftmost.")
    assert "must be somewhere to the left of the blue and green blocks" in told


def test_not_the_leftmost_of_a_row_is_of_the_row() -> None:
    told = means("Put red, blue and green in a row. The red one must not be the leftmost.")
    assert "must not be in a row with the red block at the left end" in told


@pytest.mark.parametrize(
    "text",
    [
        "Line up six red blocks so that no block is more than 6 cm from the next.",
        "Line up six red blocks so that each is at most 6 cm from the next.",
        "Line up A, B, C and D. No block may be more than 6 cm from the next.",
    ],
)
def test_how_near_the_next_is_says_nothing_of_the_others(text: str) -> None:
    assert code_of(text) == "ambiguous"


def test_one_distance_from_the_next_and_one_from_all() -> None:
    assert "with 6 cm between centers" in means("Line up six red blocks so that each is 6 cm from the next.")
    assert "with gaps of at most 2 cm" in means("Line up six red blocks with gaps of at most 2 cm.")
    assert "at least 6 cm from" in means("Line up six red blocks. Each must be at least 6 cm from the next.")
