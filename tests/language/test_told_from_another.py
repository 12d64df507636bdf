"""What is told from another: "not the red block but the green one", "next to the blue one, not the green one"."""

from __future__ import annotations

import pytest

from tests.language.meaning import code_of, means


@pytest.mark.parametrize(
    "text",
    [
        "Put the green block, not the red one, on the blue one.",
        "Not the red block, but the green one goes on the blue block.",
        "The blue block should carry the green one, not the red one.",
    ],
)
def test_another_block_that_is_not_there(text: str) -> None:
    told = means(text)
    assert "The green block must be on the blue block." in told
    assert "The red block must not be on the blue block." in told


def test_one_that_bears_it_and_one_that_does_not() -> None:
    told = means("Not the red one but the blue one should carry the yellow one.")
    assert told.endswith("must not be on the red block. The yellow block must be on the blue block.")


def test_another_landmark_where_it_is_not() -> None:
    told = means("Put the red block next to the blue one, not the green one.")
    assert told.endswith("must be next to the blue block. The red block must not be next to the green block.")


def test_the_small_one_is_of_the_color_of_the_big_one() -> None:
    told = means("Not the big red block but the small one goes on top of the blue block.")
    assert told.endswith(
        "The 5 cm red block must not be on the blue block. The 3 cm red block must be on the blue block."
    )


def test_the_contrary_says_no_more() -> None:
    told = "There are a blue block and a red block. The blue block must be on the red block."
    assert means("The blue block should be on the red one, not the red one on the blue one.") == told
    assert means("Put blue on red, not red on blue.") == told


@pytest.mark.parametrize(
    "text",
    [
        "Put the yellow block between the two black ones, but not the white one.",
        "Put the red block on the blue one, not the green one.",
    ],
)
def test_it_is_asked_what_is_not_clear(text: str) -> None:
    assert code_of(text)
