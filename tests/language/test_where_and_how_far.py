"""Quarters and halves of the table, anywhere but there, as far from one thing as from another, touched by nothing."""

from __future__ import annotations

import pytest

from tests.language.meaning import code_of, means


@pytest.mark.parametrize("place", ["near right quarter of the table", "right near quarter", "lower right quadrant"])
def test_a_quarter_is_in_two_halves(place: str) -> None:
    told = means(f"Put the pink block in the {place}.")
    assert {"The pink block must be in the near half of the table.", "The pink block must be in the right half of the "
            "table."} == {f"{x}." for x in told.rstrip(".").split(". ")[1:]}  # fmt: skip


@pytest.mark.parametrize(
    "but", ["but in the left half", "except the left half of the table", "other than in the left half"]
)
def test_anywhere_but_there(but: str) -> None:
    assert means(f"Put the red block anywhere {but}.").endswith("must not be in the left half of the table.")


def test_far_from_one_and_from_another() -> None:
    told = means("The two black blocks must be at least 15 cm from the yellow block and from each other.")
    assert told.count("at least 15 cm from the yellow block") == 2
    assert told.endswith("The two black blocks must be at least 15 cm apart.")


@pytest.mark.parametrize("others", ["both of the others", "every other", "the other two"])
def test_each_as_far_from_every_other(others: str) -> None:
    told = means(f"Red, green and blue, each at least 12 cm from {others}.")
    assert told.count("must be at least 12 cm from") == 3


@pytest.mark.parametrize(
    "text",
    [
        "No block may touch the red block. The two blue blocks must touch each other.",
        "Nothing touches the red block, but the two blue ones touch each other.",
        "I want two blue blocks that touch and a red block that doesn't touch any other block.",
    ],
)
def test_touched_by_none_of_those_named_later(text: str) -> None:
    told = means(text)
    assert "The two blue blocks must touch each other." in told
    assert told.count("must not touch") == 2


def test_half_of_them_on_either_side() -> None:
    told = means("Six blocks: half on the left side, half on the right.")
    assert "Red block 4, red block 5 and red block 6 must be in the right half of the table." in told
    told = means("Everything goes into the left half except for one block, five blocks in all.")
    assert "Exactly four of the" in told


@pytest.mark.parametrize(
    "text",
    [
        "The pink block must not be in the far left quarter of the table.",
        "Nothing may touch the red block. The two blue blocks must touch each other. It is on the mat.",
        "Put the left part of the row on the mat.",
    ],
)
def test_what_is_not_clear_is_refused(text: str) -> None:
    assert code_of(text)
