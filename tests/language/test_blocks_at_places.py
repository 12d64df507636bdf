"""Blocks told by their places in a structure, which may be brought up with them: "each end block of a row of three"."""

import pytest

from tests.language.meaning import code_of, means

ENDS = (
    "There are three blue blocks and two red blocks. The three blue blocks must be in a row in the order blue, blue, "
    "blue in either direction. A red block must be on blue block 1. The other red block must be on blue block 2."
)
EVERY = (
    "There are three blue blocks and three red blocks. The three blue blocks must be in a row. A red block must be on "
    "blue block 1. Another red block must be on blue block 2. The other red block must be on blue block 3."
)
FAR_LEFT = (
    "There are four white blocks and a black block. The four white blocks must form a grid of two rows and two columns "
    "row by row in the order white block 1, then white block 2, white block 3 and white block 4 in no fixed order. The "
    "black block must be on white block 1."
)


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ("Put a red block on each end block of a row of three blue blocks.", ENDS),
        ("Build a row of three blue blocks. Put a red block on both end blocks.", ENDS),
        ("Put a red block on every block of a row of three blue blocks.", EVERY),
        ("Put a red block on each of three blue blocks that stand in a row.", EVERY),
        ("Put a black block on the far left one of four white blocks in a 2x2 grid.", FAR_LEFT),
        ("Put a red block behind the middle one of a row of three blue blocks.",
         "There are three blue blocks and a red block. The three blue blocks must be in a row in the order blue, blue, "
         "blue in either direction. The red block must be behind a blue block."),
        ("Put three red blocks in a row and a white block behind each of them.",
         "There are three red blocks and three white blocks. The three red blocks must be in a row. A white block must "
         "be directly behind red block 1. Another white block must be directly behind red block 2. The other white "
         "block must be directly behind red block 3."),
        ("Build a row of five white blocks. Put a red block on the second block and a green block on the fourth block.",
         "There are five white blocks, a red block and a green block. The five white blocks must be in a row from left "
         "to right in the order white, white, white, white, white. The red block must be on white block 1. The green "
         "block must be on white block 2."),
        ("Make an L out of five red blocks and put a blue block on its corner.",
         "There are five red blocks and a blue block. The five red blocks must form an L shape from its first drawn "
         "place on in the order red block 1, then red block 2, red block 3, red block 4 and red block 5 in no fixed "
         "order. The blue block must be on red block 1."),
    ],
)  # fmt: skip
def test_a_part_and_its_whole(text: str, told: str) -> None:
    assert means(text) == told


@pytest.mark.parametrize(
    ("text", "code"),
    [
        ("Put a red block on each end block.", "no-referent"),  # of what?
        ("Build a 3x3 square of white blocks. Put a black block on the near left corner.", "ambiguous"),  # the table's?
        ("Put a red block on the middle block of a row of four blue blocks.", "count-mismatch"),  # there is none
        ("Put the red block on the end block of a row of four blue blocks.", "ambiguous"),  # which?
        ("Put a green cube to the left of each of three red cubes.", "ambiguous"),  # these are in no line
    ],
)
def test_what_is_asked_about(text: str, code: str) -> None:
    assert code_of(text) == code


def test_ones_behind_corners_are_corners() -> None:
    far = "Place a red block in each of the two far corners of the table and a blue block in each of the two near"
    assert means(f"{far} ones.") == means(f"{far} corners.")
