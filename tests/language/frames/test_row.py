"""A row of coloured blocks told part by part."""

from __future__ import annotations

import pytest

from tests.language.frames.told import told


@pytest.mark.parametrize(
    ("text", "plain"),
    [
        ("Row: 4 purple, no gap", "Lay 4 purple blocks in a row. The blocks touch each other."),
        (
            "red blue red blue in a line from left to right",
            "Lay 2 red blocks and 2 blue blocks in a row from left to right: red, blue, red, blue.",
        ),
        (
            "Six blocks in a row, red ones and green ones taking turns, starting with green on the left.",
            "Lay 3 red blocks and 3 green blocks in a row from left to right: green, red, green, red, green, red.",
        ),
        (
            "5 cubes in a row please, middle one black, others white",
            "Lay 4 white blocks and 1 black block in a row from left to right: white, white, black, white, white.",
        ),
        (
            "pink cube rightmost, gray cube leftmost, cyan cube in the middle of them, one row",
            "Lay 1 pink block, 1 gray block and 1 cyan block in a row from left to right: gray, cyan, pink.",
        ),
        (
            "make row of four cube: two is yellow, two is black, colors alternate",
            "Lay 2 yellow blocks and 2 black blocks in a row of alternating colors.",
        ),
        (
            "blocks lined up front to back: black nearest, then gray, then white",
            "Lay 1 black block, 1 gray block and 1 white block in a column from front to back: black, gray, white.",
        ),
        (
            "The brown block hides between two cyan ones, all of them in one straight line.",
            "Lay 1 brown block and 2 cyan blocks in a line with the brown block in the middle and a cyan block at each "
            "end.",
        ),
        (
            "three gray blocks in row, distance 6 cm with tolerance 5 mm",
            "Lay 3 gray blocks in a row. The blocks are 6 cm apart with a tolerance of 5 mm.",
        ),
        (
            "Symmetric row: two red, two blue, one green in the middle, red outside.",
            "Lay 2 red blocks, 2 blue blocks and 1 green block in a row from left to right: red, blue, green, blue, "
            "red.",
        ),
        (
            "white block second from left in a row of four; rest black",
            "Lay 3 black blocks and 1 white block in a row from left to right: black, white, black, black.",
        ),
        (
            "eight blocks, half of them red and half blue, alternating in a row near the front edge of the table",
            "Lay 4 red blocks and 4 blue blocks in a row of alternating colors. The row is at the near edge of the "
            "table.",
        ),
        (
            "the red and the white blocks go in a line, two of each",
            "Lay 2 red blocks and 2 white blocks in a line.",
        ),
        (
            "white twice, black once, in a row with black in the middle",
            "Lay 2 white blocks and 1 black block in a row from left to right: white, black, white.",
        ),
        (
            "Three red and three white, lined up, no two of the same colour next to each other",
            "Lay 3 red blocks and 3 white blocks in a line of alternating colors.",
        ),
        (
            "Row: first and third block red, second and fourth block blue",
            "Lay 2 red blocks and 2 blue blocks in a row from left to right: red, blue, red, blue.",
        ),
        (
            "blue ones first, then the green ones, then the red ones, two of each, in a line",
            "Lay 2 blue blocks, 2 green blocks and 2 red blocks in a line from left to right: blue, blue, green, "
            "green, red, red.",
        ),
        (
            "put a small block between two big blocks in a row",
            "Lay 1 small block and 2 big blocks in a row from left to right: a big block, a small block, a big block.",
        ),
        (
            "All the red blocks go to the left of all the blue blocks in a row of three reds and two blues.",
            "Lay 3 red blocks and 2 blue blocks in a row from left to right: red, red, red, blue, blue.",
        ),
        (
            "line of cubes, blue in the center, two whites left of it and two whites right of it",
            "Lay 1 blue block and 4 white blocks in a line from left to right: white, white, blue, white, white.",
        ),
        (
            "row of 6 with pattern blue blue red",
            "Lay 4 blue blocks and 2 red blocks in a row from left to right: blue, blue, red, blue, blue, red.",
        ),
        (
            "one line, first and last red, the remaining three white",
            "Lay 3 white blocks and 2 red blocks in a line from left to right: red, white, white, white, red.",
        ),
        (
            "Six blue blocks in a row, none of them touching",
            "Lay 6 blue blocks in a row. The blocks do not touch each other.",
        ),
    ],
)
def test_parts_are_put_together(text: str, plain: str) -> None:
    assert told(text) == plain


@pytest.mark.parametrize(
    "text",
    [
        "a row of red, green and blue, but no red at the left end",
        "a row of three red or three blue blocks",
        "a row of four blocks, two red and three blue",
        "a row of two red blocks and a blue one, the red one on the left",  # which of the two?
        "a row of red, white, blue again",
        "a column of three with the red one between two blue ones",  # or a tower?
        "three blocks in a row. Red, white and blue must touch.",  # are these the three?
        "line up red and blue, green and white",
        "the row of red blocks touches the mat",
        "two blue blocks and a row of three red ones and a row of three white ones",
        "a row of three blocks with red at both ends and blue at the left end",
        "five red blocks in a row from left to right, from right to left",
        "line up red and white, standing on the green mat",  # both, or the white one?
        "at the left end a red and a blue block, in a row with two white ones",
        "put four blocks in a row, the other two are red",
        "a row of five, all but the last one red",
        "a row of five blocks, all red but two",
        "a row of three small blocks and two red ones",  # are these small?
        "a row of blue, two whites left of it and one white right of it",
        "a row of seven with pattern blue blue red",
        "blocks 1 and 3 red, 3 and 4 blue, in a row",
        "a row with all red ones left of all blue ones",  # how many?
        "first line up red and blue, then put green on the left",
        "three red blocks in a row touching the blue block",
        "row of red and blue repeated",
        "row of six, two colours, red, white and blue",
        "three red blocks in a row, two of which are blue",
        "the third block from the left in a row of five is red",  # and not five of them
        "align the red block with the blue block",  # along which line?
        "a row of four red blocks, a blue block lies on the second one from the left",
    ],
)
def test_what_is_not_clear_is_not_told(text: str) -> None:
    assert told(text) is None
