"""Bridges of three, what stands at the ends of a tower in other words, and towers that are turned over or grow."""

import pytest

from tests.language.meaning import code_of, means

_ACROSS = (
    "There are a red block and two blue blocks. The two blue blocks and the red block must form a pyramid with a base "
    "of two blocks from top to bottom in the order the red block, then the two blue blocks."
)
_ORDERED = (
    "There are a blue block, a green block and a red block. The blue, green and red blocks must form a tower of "
    "exactly three from bottom to top in the order blue, green, red."
)


@pytest.mark.parametrize(
    ("text", "meaning"),
    [
        ("Bridge the two blue blocks with a red one.", _ACROSS),
        ("Two blue blocks, bridged by a red one.", _ACROSS),
        ("Blue is the base of the tower, red its top, with green in between.", _ORDERED),
        (
            "The tower's base is blue and its top is red.",
            "There are a blue block and a red block. The blue and red blocks must be stacked from bottom to top in the "
            "order blue, red.",
        ),
        (
            "Turn the tower of red on blue upside down.",
            "There are a red block and a blue block. At the start, the red and blue blocks are stacked from top to "
            "bottom in the order red, blue. The red and blue blocks must form a tower of exactly two from bottom to "
            "top in the order red, blue.",
        ),
        (
            "The tower of two red blocks grows by a green one.",
            "There are a green block and two red blocks. The two red blocks must be stacked. The green block must be "
            "on the tower of the two red blocks.",
        ),
        (
            "Split six red blocks evenly between two towers.",
            "There are six red blocks. The six red blocks must form two towers of equal height.",
        ),
        (
            "A 2x2 grid with the blue blocks on one diagonal and the green ones on the other diagonal.",
            "There are two blue blocks and two green blocks. The two blue blocks and the two green blocks must form a "
            "grid of two rows and two columns in a checkerboard pattern.",
        ),
    ],
)
def test_what_is_told_is_kept(text: str, meaning: str) -> None:
    assert means(text) == meaning


@pytest.mark.parametrize(
    ("text", "code"),
    [
        ("Two blue blocks next to each other with a third across both.", "misplaced-word"),  # a third blue one?
        ("Split seven red blocks evenly between two towers.", "count-mismatch"),
        ("There is a row of two red blocks. It grows by a green block.", "ambiguous"),
        ("There is a tower of two red blocks. It grows by one block.", "misplaced-word"),
        ("A bridge of five blocks.", "misplaced-word"),
        ("An arch of three red blocks.", "misplaced-word"),  # can one pass below it?
        ("An arch made of two red blocks and a blue block.", "misplaced-word"),
    ],
)
def test_what_is_open_is_refused(text: str, code: str) -> None:
    assert code_of(text) == code
