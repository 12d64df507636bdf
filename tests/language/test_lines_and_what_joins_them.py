"""One more block at an end of a line, one of two structures on a side of the other, the second of two rows told by the
first, and what an exception looks like, told behind it."""

import pytest

from tests.language.meaning import code_of, means

WHITE_RIGHT = (
    "There are three red blocks and a white block. The three red blocks and the white block must be in a row with the "
    "white block at the right end."
)
IN_FRONT = (
    "There are three red blocks and five blue blocks. The three red blocks must be in a row. The five blue blocks "
    "must be in a row. "
)
TURNED = (
    "There are two red blocks, two white blocks and two blue blocks. Red block 1, white block 1 and blue block 1 must "
    "be in a row from left to right in the order red, white, blue. Blue block 2, white block 2 and red block 2 must "
    "be in a row from left to right in the order blue, white, red. Red block 1, white block 1 and blue block 1 must "
    "be in front of blue block 2, white block 2 and red block 2."
)
BLUE_ENDS = (
    "There are two blue blocks and three white blocks. The two blue blocks and the three white blocks must be in a "
    "row in the order blue, white, white, white, blue in either direction."
)


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ("Put three red blocks in a row and a white one at the right end of it.", WHITE_RIGHT),
        ("A row of three red blocks with the white one at the right end.", WHITE_RIGHT),
        ("Line up three red blocks and a white one from front to back with the white one at the near end.",
         "There are three red blocks and a white block. The three red blocks and the white block must be in a column "
         "on the table with the white block at the front end."),
        ("Line up three red blocks and a white one from left to right with the white one at the right end.",
         "There are three red blocks and a white block. The three red blocks and the white block must be in a row from "
         "left to right in the order red, red, red, white."),
        ("Build a row of three red blocks and a row of five blue blocks. The red row is in front.",
         IN_FRONT + "The three red blocks must be in front of the five blue blocks."),
        ("One row of three red blocks, one row of five blue blocks. The longer one is in front.",
         IN_FRONT + "The five blue blocks must be in front of the three red blocks."),
        ("The front row is red, white, blue from left to right and the back row is the same in reverse.", TURNED),
        ("A row of five blocks, all of them white but not the two at the ends. Those are blue.", BLUE_ENDS),
        ("Of three blocks in a row, the left one is red, the right one is blue, and the one between them is green.",
         "There are a red block, a blue block and a green block. The three blocks must be in a row from left to right "
         "in the order red, green, blue."),
    ],
)  # fmt: skip
def test_what_is_read(text: str, told: str) -> None:
    assert means(text) == told


@pytest.mark.parametrize(
    ("text", "code"),
    [
        ("Build a row of three red blocks. Put a white one on the right.", "ambiguous"),  # of the row, or of the table?
        ("Line up a red, a blue and a green block from left to right with the green one at the left end.",
         "order-conflict"),
        ("Two rows of four blocks, one behind the other, both red, white, blue from left to right.", "ambiguous"),
        ("A row of three blocks, all red except the middle one. It must touch the mat.", "misplaced"),
    ],
)  # fmt: skip
def test_what_is_asked_about(text: str, code: str) -> None:
    assert code_of(text) == code
