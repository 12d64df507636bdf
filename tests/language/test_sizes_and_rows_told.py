"""How large figures are and which of their rows are which: rows of walls by name, totals, rows by turns, stairs that go
down, letters that are looked at, and lengths that are no conditions."""

from __future__ import annotations

from typing import Any

import pytest

from rpg.passes.schema.frontend import BuiltinFrontEnd
from tests.language.meaning import assert_means

_TWO_HIGH = {"assets": {"red": 8}, "hold": ["red^red red^red red^red red^red pitch=1"],
             "miss": ["red^red^red^red red^red^red^red pitch=1"]}  # fmt: skip
_ROWS = {"assets": {"red": 4, "white": 4}, "hold": ["red red red red | white white white white"],
         "miss": ["red white red white | red white red white",
                  "red white red white | white red white red"]}  # fmt: skip
_COLUMNS = {"assets": {"red": 4, "white": 2}, "hold": ["red white red | red white red"],
            "miss": ["red red red | white white red"]}  # fmt: skip
_DOWN = {"assets": {"red": 6}, "hold": ["red^red^red red^red red pitch=1"], "miss": ["red red^red red^red^red pitch=1"]}
_UP = {"assets": {"red": 6}, "hold": ["red red^red red^red^red pitch=1"], "miss": ["red^red^red red^red red pitch=1"]}
_EITHER = {"assets": {"red": 6}, "hold": ["red red^red red^red^red pitch=1", "red^red^red red^red red pitch=1"],
           "miss": ["red red red red red red"]}  # fmt: skip
_L = {"assets": {"red": 5}, "hold": ["red . . | red . . | red red red"], "miss": ["red red red | red . . | red . ."]}


@pytest.mark.parametrize(
    ("text", "meant"),
    [
        *((text, _TWO_HIGH) for text in (
            "Create a wall of 2 rows by 4 columns from red blocks", "a red wall of 4 columns by 2 rows",
            "a red 2 rows by 4 columns wall", "Put eight red blocks in a wall of two rows x four columns",
            "Build a wall of red blocks, two rows by four columns.", "Build a red wall measuring 2 rows by 4 columns",
            "a red wall, 2 rows by 4 columns", "Build a red wall with 2 rows and 4 columns", "a red 4 by 2 wall",
            "a 4x1x2 wall of red blocks",
            "wall of two rows of four, eight blocks in total, red",
        )),
        *((text, _ROWS) for text in (
            "Build a 2x4 grid, with alternating red and white rows", "Build a 2x4 grid. It has alternating red and "
            "white rows", "Build a 2x4 grid, the rows alternately red and white",
            "a grid of two rows by four columns, alternating red and white rows",
        )),
        ("Build a 2x3 grid, with alternating red and white columns", _COLUMNS),
        *((text, _DOWN) for text in (
            "Build a descending staircase of red blocks from left to right",
            "red stairs from left to right: heights 3, 2, 1",
            "A staircase of six red blocks, heights 3, 2 and 1, from left to right",
            "Descending staircase of red blocks from left to right, three steps",
            "From left to right, a red staircase with heights 3, 2, 1",
        )),
        *((text, _UP) for text in (
            "Build an ascending staircase of red blocks from left to right",
            "red stairs from left to right: heights 1, 2, 3",
            "Descending staircase of six red blocks from right to left",
        )),
        *((text, _EITHER) for text in (
            "Descending red staircase: heights 3, 2, 1.", "Ascending red staircase: heights 1, 2, 3",
            "Build a descending staircase of six red blocks", "red stairs, heights 3, 2 and 1",
        )),
        ("Build an ascending staircase of the digits 1 to 6",
         {"assets": {"1": 1, "2": 1, "3": 1, "4": 1, "5": 1, "6": 1}, "hold": [], "miss": ["1 2 3 4 5 6"]}),
        *((text, _L) for text in (
            "a letter L of five red blocks as I see it", "a letter L of five red blocks from my side",
            "Make a letter L of five red blocks so that I can read it", "An L of five red blocks, seen from above",
            "form an L shape as I see it from five red blocks",
        )),
        ("a T of five red blocks upside down from where I stand",
         {"assets": {"red": 5}, "hold": [". red . | . red . | red red red"],
          "miss": ["red red red | . red . | . red ."]}),
        ("a triangle of six red blocks as I see it",
         {"assets": {"red": 6}, "hold": [], "miss": ["red red red red red red"]}),
        ("a tower of red and white blocks, alternating, six blocks in total",
         {"assets": {"red": 3, "white": 3}, "hold": ["red^white^red^white^red^white", "white^red^white^red^white^red"],
          "miss": ["red^white ; red ; red ; white ; white"]}),
        ("one tower per color, six blocks in total",
         {"assets": {"c1": 2, "c2": 2, "c3": 2}, "hold": ["c1^c1 ; c2^c2 ; c3^c3"], "miss": ["c1^c2 ; c2^c3 ; c3^c1"]}),
    ],
)  # fmt: skip
def test_what_is_meant_is_read(text: str, meant: dict[str, Any]) -> None:
    assert_means(text, meant)


@pytest.mark.parametrize(
    ("text", "code"),
    [
        ("Wall of three rows of four, ten blocks in total, red", "contradiction"),
        ("a red 3x3 grid, ten blocks in total", "contradiction"),
        ("a wall of 3 rows by 4 columns, ten in total", "contradiction"),
        ("a staircase with three steps, seven blocks in all", "contradiction"),
        ("a red tower of three and a blue tower of two, six blocks in total", "contradiction"),
        ("a 2 by 3 by 2 wall of red blocks", "misplaced"),
        ("Stairs of 1, 2 and 3 blocks, red, white, blue", "ambiguous"),
        ("Descending stairs of red, white and blue: 3, 2, 1", "unused-block"),
        ("Ascending staircase: heights 3, 2, 1", "contradiction"),
        ("Descending staircase from left to right: heights 1, 2, 3", "contradiction"),
        ("Build a 4x4 grid with alternating rows", "incomplete"),
        ("Build a wall two layers high, as long as a row of four red blocks", "incomplete"),
        ("Put red on blue so long as a tower of two", "incomplete"),
        ("Build a tower of three 3 cm red blocks. All blocks are 5 cm.", "contradiction"),
        ("All blocks are 5 cm. Build a tower of three 3 cm red blocks.", "contradiction"),
        ("Build a tower of three small red blocks. All blocks are large.", "contradiction"),
        ("a tower of three small red blocks. All blocks are 5 cm.", "contradiction"),
        ("Put the 3 cm red block on the blue one. The red block is 5 cm.", "contradiction"),
    ],
)
def test_what_cannot_be_or_is_no_size_is_refused(text: str, code: str) -> None:
    schema, diagnostics = BuiltinFrontEnd().read(text)
    assert schema is None
    assert [d.code for d in diagnostics if d.severity == "error"] == [code]


@pytest.mark.parametrize(
    "text",
    ["Build a tower of three large red blocks. All blocks are 5 cm.", "Put red on blue as long as green is on the mat",
     "a row of three red blocks and two rows of three blue blocks", "towers of two, six blocks in total"],
)  # fmt: skip
def test_what_agrees_is_read(text: str) -> None:
    schema, diagnostics = BuiltinFrontEnd().read(text)
    assert schema is not None, diagnostics
