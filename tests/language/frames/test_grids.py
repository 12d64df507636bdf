"""Grids, walls, pyramids and cubes told part by part, in whatever order and syntax."""

from __future__ import annotations

import pytest

from tests.language.frames.told import told

GRID = "Build a grid of 2 rows and 3 columns"
FLAT = "Build a pyramid with a base of 3 blocks"


@pytest.mark.parametrize(
    ("text", "plain"),
    [
        ("2 rows with 3 columns grid of blue blocks", f"{GRID} from 6 blue blocks."),
        ("A grid shall be formed, three columns, two rows. Use green cubes only.", f"{GRID} from 6 green blocks."),
        (
            "In a grid of two rows and three columns, the left column is green, the middle one yellow and the right "
            "one pink.",
            f"{GRID}, in reading order: green, yellow, pink, green, yellow, pink.",
        ),
        (
            "2x3 grid: far row red, red, blue; near row blue, red, blue",
            f"{GRID}, in reading order: red, red, blue, blue, red, blue.",
        ),
        ("Grid of letters, reading order A to F, two rows of three", f"{GRID}, in reading order: A, B, C, D, E, F."),
        (
            "3x3 grid. center: red. corners: blue. rest: white.",
            "Build a grid of 3 rows and 3 columns, in reading order: "
            "blue, white, blue, white, red, white, blue, white, blue.",
        ),
        (
            "a 2x3 grid, one row red, the other blue",
            f"{GRID} from 3 red blocks and 3 blue blocks. Each row has one color.",
        ),
        (
            "Five black and four white blocks in checkerboard fashion on a three-by-three grid.",
            "Build a grid of 3 rows and 3 columns, in reading order: "
            "black, white, black, white, black, white, black, white, black.",
        ),
        (
            "checkerboard 2x2 on the black mat, red and white, 2 each",
            "Build a 2x2 checkerboard of red and white blocks. The grid is on the black mat.",
        ),
        (
            "make wall. three long. two high. bottom red, top white.",
            "Build a wall 3 blocks wide and 2 blocks high, in reading order: white, white, white, red, red, red.",
        ),
        (
            "Build a flat pyramid from three green blocks at the bottom, two blue ones on them and a yellow one on "
            "top.",
            f"{FLAT}, layers from bottom to top: green, blue, yellow.",
        ),
        ("build a 3-2-1 pyramid from six blocks", f"{FLAT} from 6 blocks."),
        ("A square pyramid of five green blocks.", "Build a pyramid with a 2x2 base from 5 green blocks."),
        ("cube 2x2x2 out of 8 orange", "Build a grid of 2 rows, 2 columns and 2 layers from 8 orange blocks."),
        (
            "Two layers of four cubes each, 2x2 per layer, lower layer black, upper layer white.",
            "Build a grid of 2 rows, 2 columns and 2 layers, in reading order: "
            "white, white, white, white, black, black, black, black.",
        ),
        (
            "3x3 grid red corners blue edges white center",
            "Build a grid of 3 rows and 3 columns, in reading order: red, blue, red, blue, white, blue, red, "
            "blue, red.",
        ),
        (
            "step pyramid base 3x3 second layer 2x2 and one block on top all gray",
            "Build a pyramid with a 3x3 base from 14 gray blocks.",
        ),
        (
            "pyramid, four on the bottom as a two by two and one on top, all in orange",
            "Build a pyramid with a 2x2 base from 5 orange blocks.",
        ),
        (
            "A square pyramid would be lovely: four gray blocks for the base and a yellow one on top",
            "Build a pyramid with a 2x2 base, layers from bottom to top: gray, yellow.",
        ),
        (
            "Make wall of two layers, each layer four boxes: lower layer brown, upper layer white",
            "Build a wall 4 blocks wide and 2 blocks high, in reading order: white, white, white, white, brown, "
            "brown, brown, brown.",
        ),
        (
            "Grid with three rows and four columns, column colors from left to right: red, green, blue, white",
            "Build a grid of 3 rows and 4 columns, in reading order: red, green, blue, white, red, green, blue, "
            "white, red, green, blue, white.",
        ),
        (
            "4-by-4 grid so that black and white cells alternate like a checkerboard",
            "Build a 4x4 checkerboard of black and white blocks.",
        ),
        ("2x2x2 cube, colors irrelevant", "Build a grid of 2 rows, 2 columns and 2 layers from 8 blocks."),
        (
            "Build a 2x2x3 cuboid with red, white and blue layers from the bottom.",
            "Build a grid of 2 rows, 2 columns and 3 layers, in reading order: blue, blue, blue, blue, white, "
            "white, white, white, red, red, red, red.",
        ),
        (
            "four layers pyramid, red at the bottom, then orange, yellow, and white on top",
            "Build a pyramid with a base of 4 blocks, layers from bottom to top: red, orange, yellow, white.",
        ),
        ("checkerboard 4 rows 4 columns red black", "Build a 4x4 checkerboard of red and black blocks."),
        (
            "Make wall from twelve block, 4 in each row, color alternate red and blue by row, start with red on bottom",
            "Build a wall 4 blocks wide and 3 blocks high, in reading order: red, red, red, red, blue, blue, "
            "blue, blue, red, red, red, red.",
        ),
        (
            "The grid has two rows and two columns; the diagonal from the upper left to the lower right is red, "
            "the other two blocks are blue.",
            "Build a grid of 2 rows and 2 columns, in reading order: red, blue, blue, red.",
        ),
        (
            "wall: red red red on bottom, blue blue blue on top",
            "Build a wall 3 blocks wide and 2 blocks high, in reading order: blue, blue, blue, red, red, red.",
        ),
        (
            "make me a flat 3x3 square of white cubes and put a red cube on top of the middle",
            "Build a grid of 3 rows and 3 columns from 9 white blocks. Put a red block on the center block.",
        ),
    ],
)
def test_parts_are_put_together(text: str, plain: str) -> None:
    assert told(text) == plain


@pytest.mark.parametrize(
    "text",
    [
        "a 2x3 grid of red or blue blocks",
        "a 3x3 grid with no red block in the middle",
        "a 3x3 grid, all but one red",
        "a 2x2 grid of three red blocks",
        "a red grid and a blue grid, both 2x2",
        "a 2x2 grid of red blocks, then a pyramid of blue ones",
        "a 2x2 grid of red blocks with a blue block on each",
        "a 3x3 grid with red and blue in the corners",
        "a 2x3 grid, left column red, far row blue",
        "a 2x2 grid, each row in one colour: left red, right blue",
        "a 3x3 grid with the middle row red and the other row blue",
        "a 3x3 grid where the first row is red, the second too and the third blue",
        "letters C, A, B, D in a 2x2 grid, in alphabetical order",
        "a wall of three layers, the bottom one red and the top one blue",
        "a large red wall, 3 wide and 2 high",
        "two rows of three red blocks",  # anywhere
        "a pyramid: three red, two blue, one green",  # its layers?
        "a pyramid with a bottom row of four blocks, made from exactly five cubes",
        "a 3x3 checkerboard of red, white and blue",
        "A pyramid of six black blocks as a 2x2 base and one yellow block on top",
        "pyramid with a base of three, two blocks in the third layer and one on top, red",
        "2x2 grid with two red rows",
        "3x3 grid of red blocks and a red block on top of the middle",
    ],
)
def test_what_is_not_clear_is_not_told(text: str) -> None:
    assert told(text) is None
