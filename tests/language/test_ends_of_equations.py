"""Equations of which it is told what they begin or end with."""

from __future__ import annotations

import pytest

from tests.language.meaning import assert_means, code_of

CUBES = {"2": 1, "3": 1, "5": 1, "+": 1, "=": 1}
BEGINS = {"assets": CUBES, "hold": ["5 = 2 + 3", "5 = 3 + 2"], "miss": ["2 + 3 = 5", "3 + 2 = 5", "5 + 2 = 3"]}


@pytest.mark.parametrize(
    "text",
    [
        "Make an equation with 2, 3, 5, + and =, with the 5 on the left.",
        "Make a true equation with 2, 3, 5, + and = that starts with the 5.",
    ],
)
def test_what_is_at_an_end(text: str) -> None:
    assert_means(text, BEGINS)


def test_both_ends_may_be_told() -> None:
    text = "Make a true equation with 2, 3, 5, + and =, with the 2 on the left and the 5 on the right."
    assert_means(text, {"assets": CUBES, "hold": ["2 + 3 = 5"], "miss": ["3 + 2 = 5", "5 = 2 + 3"]})


@pytest.mark.parametrize(
    "text",
    [
        "Make a true equation with 2, 3, 5, + and =, with the + on the left.",
        "Make the equation 2+3=5 with the 3 on the left.",
    ],
)
def test_none_has_this_there(text: str) -> None:
    assert code_of(text) == "false-equation"
