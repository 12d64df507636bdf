"""Mats that are cleared, what is left on them, and a stock told beside what each of them gets."""

from __future__ import annotations

import pytest

from tests.language.meaning import code_of, means, start_and_end

_FOUR = "At the start, the four red blocks are on the gray patch"


@pytest.mark.parametrize(
    "text",
    [
        "The blue patch must be left empty.",
        "The blue patch should be cleared of all blocks.",
        "Free the blue patch.",
        "The blue patch is to be vacated.",
        "The blue patch should become free.",
        "Nothing may remain on the blue patch.",
    ],
)
def test_a_mat_is_cleared(text: str) -> None:
    begun = ("At the start, the red block is on the blue patch", "The blue patch must be empty.")
    assert start_and_end(f"A red block is on the blue patch. {text}") == begun


@pytest.mark.parametrize("text", ["The red patch must be left empty.", "Leave the red patch bare.",
                                  "No block is allowed on the red patch."])  # fmt: skip
def test_blocks_that_nobody_names_lie_there_at_first(text: str) -> None:
    assert means(text) == means("Clear the red patch.")


def test_a_mat_that_is_spared_is_none() -> None:
    assert code_of("The red patch must not be cleared.") == "incomplete"


@pytest.mark.parametrize(
    ("text", "end"),
    [
        ("Leave one there and remove the rest.", "Exactly one of the four red blocks must be on the gray patch."),
        ("Keep only one.", "Exactly one of the four red blocks must be on the gray patch."),
        ("Only one may stay.", "At most one of the four red blocks must be on the gray patch."),
        ("Remove all but one.", "Exactly one of the four red blocks must be on the gray patch."),
        ("Remove two.", "Exactly two of the four red blocks must not be on the gray patch."),
    ],
)
def test_what_is_left_there(text: str, end: str) -> None:
    assert start_and_end(f"Four red blocks are on the patch. {text}") == (_FOUR, end)


def test_it_is_not_clear_which_are_left_of_two_lots() -> None:
    assert code_of("Three blocks are on the patch and two in a row. Leave one there and remove the rest.") != ""


@pytest.mark.parametrize("text", ["Two patches, four red blocks, two blocks per patch.",
                                  "Each patch gets two red blocks; two patches, four red blocks."])  # fmt: skip
def test_the_stock_is_no_part_of_what_each_gets(text: str) -> None:
    assert means(text).startswith("There are four red blocks. There are a gray patch and a blue patch.")
