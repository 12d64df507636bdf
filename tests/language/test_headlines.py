"""A headline tells nothing that is not told behind it; what it alone tells is not left out with it."""

from __future__ import annotations

import pytest

from tests.language.meaning import code_of, means


@pytest.mark.parametrize(
    ("headline", "told"),
    [
        ("Traffic light:", "A tower with red on top, yellow in the middle and green at the bottom."),
        ("Port of the classic three-block stacking task:", "Put red on green and blue on red."),
        ("Adapted from put-block-in-zone:", "Both red blocks have to be on the green zone."),
        ("Sorting by parity:", "The cubes 2 and 4 are on the gray pad, and 1 and 3 are on the pink one."),
        ("Bedtime for the blocks, sweetie:", "The red block is on the red mat."),
        ("Unstacking task.", "Initial state: red on blue. Goal: red and blue are on the table."),
    ],
)
def test_a_headline_is_left_out(headline: str, told: str) -> None:
    assert means(f"{headline} {told}") == means(told)


def test_a_place_in_a_headline_is_where_all_of_it_is() -> None:
    text = "Traffic light on the black pad: a tower with red on top, yellow in the middle and green at the bottom."
    assert "on the black patch" in means(text)


@pytest.mark.parametrize(
    "text",
    [
        "Port of the classic five-block stacking task: put red on green and blue on red.",
        "Sorting by size: three blocks in a row.",
        "Fruit stall without apples: three red blocks in a row.",
        "Red tower: three blocks stacked.",
        "Warehouse bay on the gray pad: put the red block on the blue block.",
    ],
)
def test_what_a_headline_alone_tells_is_not_lost(text: str) -> None:
    assert code_of(text)


def test_a_title_of_a_task_asks_for_nothing() -> None:
    told = "The red block is on the blue block. Put it on the mat."
    assert means(f"Easy task: {told}") == means(told)


@pytest.mark.parametrize("headline", ["TC-041:", "Requirement R-7:", "Case 2:", "Variant B of the stacking suite:"])
def test_a_headline_has_a_number(headline: str) -> None:
    assert means(f"{headline} put the red block on the blue one.") == means("Put the red block on the blue one.")


def test_what_is_numbered_like_a_headline_may_tell() -> None:
    assert "must not be on the blue block" in means("Item 3: do not put red on blue.")
    for text in ("Not allowed case 3: red on blue.", "Wrong layout 2: red on blue.", "Row 2: red, blue."):
        code_of(text)  # refused
