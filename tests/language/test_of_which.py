"""What "this", "each one" and "in between" are of, and what is told of some of several blocks."""

from __future__ import annotations

import pytest

from tests.language.meaning import code_of, means


@pytest.mark.parametrize(
    "text",
    [
        "Two red blocks are on the mat. Put a green block on the one that is next to the white block.",
        "There is a white block on the green mat and one on the blue mat. Put a red block on each one.",
        "There is a white block on the green mat and a red one on the blue mat. Put a yellow block on each.",
        "Put a green block on each white block that is on the mat. Two of the four white blocks are on the mat.",
        "Put a green block on every white block which is not on the mat; one of the three white blocks is on it.",
        "First stack the two white blocks, last make a row of two red blocks; in between put a blue block on the mat.",
        "Begin with a tower of two white blocks and end with a row of two red ones; in between put blue on the mat.",
        "Three white blocks are on the mat. Put a red block on the one in the corner.",
        "Put the white block next to both red blocks, on neither of them, and the green block on both of them.",
        "Put the green block beside both of the red blocks but on neither, and the white block on both.",
        "Build a tower of two white blocks. To its left stands a red block, and behind this a row of two blue ones.",
        "Build a row of two white blocks. To the right of that lies a blue block, and to the right of that a red one.",
    ],
)
def test_of_one_of_two(text: str) -> None:
    assert code_of(text) == "ambiguous"


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ("There is a red mat and a green mat. Put a blue block on each one.",
         "A blue block must be on the red patch. The other blue block must be on the green patch."),
        ("Two of the three red blocks are on the mat. Put a blue block on each red block that is on the mat.",
         "There are three red blocks and two blue blocks."),
        ("Put the green block next to both of the red blocks but on neither.",
         "The green block must not be on red block 1."),
        ("Build a tower of two white blocks. To its left stands a red block, and to its right a blue one.",
         "The blue block must be to the right of the tower of the two white blocks."),
    ],
)  # fmt: skip
def test_of_the_one_that_is_meant(text: str, told: str) -> None:
    assert told in means(text)


@pytest.mark.parametrize(
    "text",
    [
        "The green block lies on the white block, which lies on the blue mat; green must not lie on the mat itself.",
        "Only the white block is on the blue mat, and the green block is on the white block.",
        "Don't put the green block on the blue mat, put it on the white block, which should be on the blue mat.",
    ],
)
def test_what_lies_on_another_is_not_directly_on_the_mat(text: str) -> None:
    told = means(text)
    assert "The green block must be on the white block." in told
    assert "The white block must be on the blue patch." in told
    assert "must not be on the blue patch" not in told


def test_what_lies_elsewhere_is_off_the_mat() -> None:
    assert "The green block must not be on the blue patch." in means(
        "The green block is on the red block and not on the blue mat; the white block is on the blue mat."
    )
