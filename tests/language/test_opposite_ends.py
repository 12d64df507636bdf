"""Blocks at the two ends of a line: "a red block at each end", "two red ones at opposite ends"."""

from __future__ import annotations

import pytest

from tests.language.meaning import means


@pytest.mark.parametrize(
    "have",
    [
        "should have a blue block at each end",
        "must get a blue block at both ends",
        "has one blue block at each end",
        "should have blue blocks at both ends",
    ],
)
@pytest.mark.parametrize("line", ["row", "column"])
def test_what_a_line_should_have_at_each_end_is_at_both(line: str, have: str) -> None:
    told = means(f"The {line} of three red blocks {have}.")
    assert "There are three red blocks and two blue blocks." in told
    assert "in the order a blue block, then the three red blocks, then a blue block" in told


@pytest.mark.parametrize("which", ["two red ones", "the two red ones", "red ones"])
def test_of_two_at_opposite_ends_one_is_at_each(which: str) -> None:
    for line in ("row", "column"):
        told = means(f"A {line} of four blocks with {which} at opposite ends.")
        assert "a red block, then the blue and green blocks in no fixed order, then a red block" in told


def test_two_of_two_kinds_at_opposite_ends() -> None:
    told = means("A row of five blocks with a red and a blue one at opposite ends.")
    assert "the red block, then the green, yellow and purple blocks in no fixed order, then the blue block" in told
    assert "in the order A, C, B in either direction" in means("A row of A, B and C with A and B at opposite ends.")


def test_at_one_end_is_one_block() -> None:
    told = means("The row of three red blocks should have a blue block at one end.")
    assert "in the order the blue block, then the three red blocks in either direction" in told


@pytest.mark.parametrize(
    ("text", "found"),
    [
        ("B should be the middle one of the letters A, B, C in a row.", "in the order A, B, C in either direction"),
        ("2 is the last one of the digits 1, 2 and 3 in a row.", "with the 2 block at the right end"),
        ("B should be the top one of A, B and C in a stack.", "with the B block on top"),
    ],
)
def test_which_one_of_several_in_a_line_it_is(text: str, found: str) -> None:
    assert found in means(text)
