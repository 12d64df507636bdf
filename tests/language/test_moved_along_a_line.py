"""Blocks of a row or a tower that is there, moved along it: to an end, so many places on, "should be at the bottom"."""

from __future__ import annotations

import pytest

from tests.language.meaning import code_of, means, start_and_end

_ROW = "There is a row of red, green, white and blue from left to right. "
_TOWER = "There is a tower of red, green and blue from bottom to top. "


@pytest.mark.parametrize(
    ("text", "order"),
    [
        (f"{_ROW}Move the red one to the other end.", "green, white, blue, red"),
        (f"{_ROW}Move the white block two places to the left.", "white, red, green, blue"),
        (f"{_ROW}The red one should be moved one place to the right.", "green, red, white, blue"),
        (f"{_ROW}Blue should come first.", "blue, red, green, white"),
        (f"{_ROW}Put blue at the left end and red at the right end.", "blue, green, white, red"),
        (f"{_TOWER}Move the green one up by one place.", "red, blue, green"),
        (f"{_TOWER}Blue should be at the bottom.", "blue, red, green"),
        (f"{_TOWER}The bottom block goes on top.", "green, blue, red"),
        (f"{_TOWER}Now blue should be at the bottom and red on top.", "blue, green, red"),
        ("A red block and three white ones stand in a row, with the red one at the left end. Move the red one to the "
         "other end.", "white, white, white, red"),
        ("There is a tower of two white blocks with a red one on top. Put the red one at the bottom.",
         "red, white, white"),
    ],
)  # fmt: skip
def test_the_order_that_it_comes_to(text: str, order: str) -> None:
    start, end = start_and_end(text)
    assert start != ""
    assert end.endswith(f"in the order {order}.")


@pytest.mark.parametrize(
    "text",
    [
        f"{_ROW}Move the green block to the other end.",
        f"{_ROW}Move the white block two places to the right.",
        f"{_TOWER}Blue must not be on top.",
        "Move the red block two places to the left.",
        "Put the red block at the other end.",
    ],
)
def test_where_there_is_no_such_place(text: str) -> None:
    assert code_of(text) == "no-referent"


def test_ends_of_a_row_that_is_still_to_be_built() -> None:
    told = means("Build a row of red, green and blue. Red goes at one end and blue at the other end.")
    assert told.endswith("in a row in the order red, green, blue in either direction.")
