""" "Another" behind "and" or a comma looks like the block that the clause before told of."""

from __future__ import annotations

import pytest

from tests.language.meaning import code_of, means


@pytest.mark.parametrize(
    "text",
    [
        "Put a white block on the red one and another on the blue one.",
        "Let a white block rest on the red one and another on the blue one.",
        "A white block goes on the red one, another goes on the blue one.",
    ],
)
def test_another_of_the_same_look(text: str) -> None:
    told = means(text)
    assert told.startswith("There are two white blocks, a red block and a blue block. A white block must be on the red")
    assert told.endswith("The other white block must be on the blue block.")


def test_another_tower_is_a_tower() -> None:
    told = means("A blue block with a tower of two red blocks on its left and another on its right.")
    assert told.count("must form a tower of exactly two") == 2


@pytest.mark.parametrize(
    "text",
    [
        "Put the red block on the blue one and another on the green one.",
        "Put two red blocks on the mat and another next to it.",
    ],
)
def test_what_another_looks_like_is_asked(text: str) -> None:
    assert code_of(text) == "ambiguous"
