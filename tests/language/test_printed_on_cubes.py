"""What is printed on a cube, and what is said of it behind it: "the red one with an R on it, I would like it there"."""

from __future__ import annotations

import pytest

from tests.language.meaning import means

R_AND_G = "There are a red R block and a green G block. The red R block must be to the left of the green G block."


@pytest.mark.parametrize(
    "text",
    [
        "The red cube with an R on it, I would like it on the left side of the green cube with a G on it.",
        "The red one with an R on it is to the left of the green one with a G on it.",
        "As for the red cube with the letter R on it, we want it left of the green one with a G on it.",
    ],
)
def test_a_coloured_cube_shows_a_letter(text: str) -> None:
    assert means(text).replace("\n", " ") == R_AND_G


@pytest.mark.parametrize(
    ("text", "meant"),
    [
        ("The cube with 5 on it must be left of the one with 7 on it.",
         "There are a 5 block and a 7 block. The 5 block must be to the left of the 7 block."),
        ("Put the one with an A on it behind the one with a B on it.",
         "There are an A block and a B block. The A block must be behind the B block."),
        ("The red and the blue block, I want them next to each other.",
         "There are a red block and a blue block. The red block must be next to the blue block."),
        ("The red cube with a green cube on it, I would like it to the left of the blue cube.",
         "There are a red block, a green block and a blue block. The green block must be on the red block. "
         "The red block must be to the left of the blue block."),
        ("Put the red one with a blue one on it behind the green one.",
         "There are a red block, a green block and a blue block. The red block must be behind the green block. "
         "The blue block must be on the red block."),
    ],
)  # fmt: skip
def test_others_are_named_or_carry_blocks(text: str, meant: str) -> None:
    assert means(text).replace("\n", " ") == meant
