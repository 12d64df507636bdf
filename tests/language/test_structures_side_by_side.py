"""Structures that stand beside each other, of which the looks or the numbers of the blocks are not told."""

import pytest

from tests.language.meaning import code_of, means


@pytest.mark.parametrize(
    ("text", "meaning"),
    [
        (
            "Two towers of two with the green block between them.",
            "There are two red blocks, two blue blocks and a green block. The two red blocks must form a tower of "
            "exactly two. The two blue blocks must form a tower of exactly two. The green block must be between the "
            "tower of the two red blocks and the tower of the two blue blocks.",
        ),
        (
            "Put a red block between two towers of two.",
            "There are a red block, two blue blocks and two green blocks. The two blue blocks must form a tower of "
            "exactly two. The two green blocks must form a tower of exactly two. The red block must be between the "
            "tower of the two blue blocks and the tower of the two green blocks.",
        ),
        (
            "A row of three with a red block to the left of it.",
            "There are a blue block, a green block, a yellow block and a red block. The blue, green and yellow blocks "
            "must be in a row. The red block must be to the left of the blue, green and yellow blocks.",
        ),
        (
            "A tower next to a row of three.",
            "There are six red blocks. Red block 4, red block 5 and red block 6 must be in a row. Red block 1, red "
            "block 2 and red block 3 must form a tower of exactly three. The tower of red block 1, red block 2 and red "
            "block 3 must be next to red block 4, red block 5 and red block 6.",
        ),
        (
            "A pyramid and a row of three.",
            "There are nine red blocks. Six red blocks must form a pyramid with a base of three blocks. The other "
            "three red blocks must be in a row.",
        ),
        (
            "A monochrome tower of three.",
            "There are three red blocks. The three red blocks must form a tower of exactly three.",
        ),
        (
            "Stack the blocks in pairs of the same color: two red, two green.",
            "There are two red blocks and two green blocks. The two red blocks and the two green blocks must form two "
            "towers of two, each of a different color.",
        ),
    ],
)
def test_each_has_blocks_of_its_own(text: str, meaning: str) -> None:
    assert means(text) == meaning


@pytest.mark.parametrize(
    "text",
    [
        "Two towers of two with a green block between them and a red block on top of both.",  # not a pyramid
        "A pyramid to the left of the red block.",
        "A row of three with a red block on both sides of the middle one.",
        "Build a tower and put a red block on top.",
    ],
)
def test_blocks_that_could_be_of_the_structure_are_asked_about(text: str) -> None:
    assert code_of(text) == "ambiguous"


@pytest.mark.parametrize(
    "text",
    [
        "A 3x3 grid of red blocks with the center empty.",
        "A 3x3 grid of red blocks without the center block.",
        "A 3x3 ring of red blocks around an empty center.",
        "Arrange eight red blocks in a 3x3 grid whose center is empty.",
    ],
)
def test_a_grid_without_its_centre_is_the_rim_of_a_square(text: str) -> None:
    assert means(text) == "There are eight red blocks. The eight red blocks must form a hollow 3x3 square."


def test_a_larger_grid_has_no_hole() -> None:
    assert code_of("A 4x4 grid of red blocks with an empty center.") == "unsupported-structure"
