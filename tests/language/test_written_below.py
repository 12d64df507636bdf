"""A word that is written below another one stands nearer to the viewer, what comes after a letter to its
right; what may be anywhere adds nothing."""

from __future__ import annotations

import pytest

from tests.language.meaning import assert_means, code_of, means


@pytest.mark.parametrize(
    "text",
    [
        "Let's write CAT with the letter blocks and right below it DOG.",
        "Spell CAT, and DOG underneath.",
        "Write CAT above DOG.",
    ],
)
def test_below_is_nearer(text: str) -> None:
    assert means(text) == means("Write CAT in the far row and DOG in the near row.")


def test_after_a_letter_is_to_its_right() -> None:
    there = means("Spell CAT and put the yellow block right after the last letter.")
    assert "The yellow block must be immediately to the right of the T block." in there
    assert "First, the A block" in means("Put the red block on the mat after the A is on the B.")


def test_what_is_told_beside_a_word_may_adjoin_it() -> None:
    text = "Spell CAT and put the yellow block right after the last letter."
    looks = {"C": 1, "A": 1, "T": 1, "yellow": 1}
    assert_means(
        text, {"assets": looks, "hold": ["C A T yellow"], "miss": ["yellow C A T", "C A yellow T", "C A T; yellow"]}
    )


def test_in_a_tower_below_is_below() -> None:
    assert code_of("Spell CAT down a tower and below it DOG.")


@pytest.mark.parametrize("where", ["anywhere else on the table", "anywhere", "anywhere on the table"])
def test_the_others_may_be_anywhere(where: str) -> None:
    told = "Exactly two of the four yellow cubes have to be on the gray mat."
    assert means(f"{told} The remaining yellow cubes may be {where}.") == means(told)


def test_else_is_not_there() -> None:
    assert code_of("At least two of the four yellow cubes are on the gray mat. The others may be anywhere else.")


def test_alone_at_the_start_is_on_the_table() -> None:
    text = "Setup: red is on yellow, blue stands alone. At the end red must be on blue."
    assert "At the start, the blue block is on the table." in means(text)
