"""What each of several structures has, told by the colors that there are."""

from __future__ import annotations

import pytest

from tests.language.meaning import code_of, means

TOLD = "Build two towers from two red and two blue blocks, each with a red and a blue block."


@pytest.mark.parametrize(
    "text",
    [
        "Build two towers from two red and two blue blocks, each with one block of each color.",
        "Build two towers from two red and two blue blocks with one block of each color in each tower.",
        "Build two towers from two red and two blue blocks so that each contains both colors.",
        "Build two towers of equal height from two red and two blue blocks, each of which contains both colors.",
    ],
)
def test_each_has_one_of_each_color(text: str) -> None:
    assert means(text) == means(TOLD)


@pytest.mark.parametrize(
    "text",
    [
        "Build two towers from three red and two blue blocks so that each contains both colors.",
        "Build two towers from two red and two blue blocks, each with all three colors.",
        "Make a 3x3 grid of three red, three green and three blue blocks. Every row contains each color once.",
        "Build two stacks of different height, each with a red and a blue cube.",
    ],
)
def test_what_may_be_otherwise_is_not_guessed(text: str) -> None:
    assert code_of(text)


def test_the_color_of_a_patch_is_none_of_theirs() -> None:
    text = (
        "There are two red and two green blocks and a black mat. Build two towers on the mat, each with one block of "
    )
    assert "black block" not in means(f"{text}each color.")
