"""Words that are easily taken as of something else: each, first, also, the corner, so many, two looks of one thing."""

from __future__ import annotations

from typing import Any

import pytest

from rpg.passes.schema.frontend import BuiltinFrontEnd
from tests.language.meaning import assert_means


@pytest.mark.parametrize(
    ("text", "code"),
    [
        ("Put red on the mat. First put blue on green.", "misplaced"),
        ("Stack yellow on red. There is also a yellow block.", "ambiguous"),
        ("Put the A block on red. There is also an A block.", "ambiguous"),
        ("Two red towers, six blocks", "ambiguous"),
        ("Towers of red blocks, six blocks, at most two high", "ambiguous"),
        ("Three towers of two blocks, each a different colour.", "ambiguous"),
        ("Make a checkerboard of nine white blocks", "contradiction"),
        ("Sort the blocks red, green and blue. The first is red.", "misplaced"),
        ("Keep this as it is: red on blue", "no-referent"),
        (
            "The scene contains a green block and two purple blocks. The red block should be on a purple one.",
            "no-referent",
        ),
        ("Put the red block and the green block on the block.", "ambiguous"),
        ("Put the red block on the blue block. The blocks are round.", "misplaced"),
        ("My name is TOM, so please write TIM", "ambiguous"),
        ("Put red on the red mat, blue on the blue mat, each in the middle", "ambiguous"),
        ("the big and small red blocks in a row", "ambiguous"),
        ("Red, blue and green are all 10 cm apart.", "ambiguous"),
        ("There is a tower of three red blocks. Put a blue block next to it, and then another one.", "ambiguous"),
        ("Move any block but the red one onto the mat. There are a red, a blue and a green block.", "ambiguous"),
        ("Put the red block 10 cm left of the blue one and 10 cm behind it.", "misplaced"),
        ("A tower of three blocks beside a pair of blocks, all blue", "ambiguous"),
        ("Build a row of three red blocks. Build a row of three blue blocks. Put a white block on each.", "ambiguous"),
        ("Put blue on red. First the blue block must be moved to the left half.", "misplaced"),
        ("Put blue on red. First, a green block should be placed on the mat.", "misplaced"),
        ("Build two towers of three, each of a different color. On the left.", "incomplete"),
        ("Build two towers of three, each of a different color. In the middle.", "incomplete"),
        ("Red is next to blue. Red touches green. Red is on the left.", "ambiguous"),
        ("Neither the red block nor the blue block may touch the table. Both yellow blocks remain on it.", "ambiguous"),
    ],
)
def test_what_could_be_meant_of_something_else_is_asked(text: str, code: str) -> None:
    schema, diagnostics = BuiltinFrontEnd().read(text)
    assert schema is None
    assert [d.code for d in diagnostics if d.severity == "error"] == [code]


@pytest.mark.parametrize(
    ("text", "meant"),
    [
        ("Stack yellow on red. There is also a green block.",
         {"assets": {"yellow": 1, "red": 1, "green": 1}, "hold": ["red^yellow ; green"], "miss": ["yellow^red"]}),
        ("First put blue on green. Then put red on yellow.",
         {"assets": {"blue": 1, "green": 1, "red": 1, "yellow": 1},
          "hold": [["green ; blue ; yellow ; red", "green^blue ; yellow ; red", "green^blue ; yellow^red"]],
          "miss": [["green ; blue ; yellow ; red", "green ; blue ; yellow^red", "green^blue ; yellow^red"]]}),
        ("First put red on blue. Then put red next to white.",
         {"assets": {"red": 1, "blue": 1, "white": 1},
          "hold": [["red ; blue ; white", "blue^red ; white", "red white ; blue"]],
          "miss": [["red ; blue ; white", "blue^red ; white", "blue^red white"]]}),
        ("A wall three blocks wide with two layers, each a different colour.",
         {"assets": {"c1": 3, "c2": 3}, "hold": ["c1^c2 c1^c2 c1^c2 pitch=1"], "miss": ["c1^c2 c2^c1 c1^c2 pitch=1"]}),
        ("Build a grid of 2 rows and 2 columns from 3 red blocks and 1 blue block. The blue block is in the far left "
         "corner.", {"assets": {"red": 3, "blue": 1}, "hold": ["blue red | red red"], "miss": ["red red | red blue"]}),
        ("order from left: gray, white, cyan. It is a row.",
         {"assets": {"gray": 1, "white": 1, "cyan": 1}, "hold": ["gray white cyan"], "miss": ["white gray cyan"]}),
        ("Here is a black and white checkerboard of two rows and three columns.",
         {"assets": {"black": 3, "white": 3}, "hold": ["black white black | white black white"],
          "miss": ["black black black | white white white"]}),
        ("Pick out the blue block and put it on the white patch, the reds stay off it. There are two reds.",
         {"assets": {"blue": 1, "red": 2, "white_patch": 1}, "hold": ["blue at=white_patch"],
          "miss": ["blue red pitch=1 at=white_patch", "red"]}),
        ("Build three single-colour towers of two blocks.",
         {"assets": {"c1": 2, "c2": 2, "c3": 2}, "hold": ["c1^c1 ; c2^c2 ; c3^c3"], "miss": ["c1^c2 ; c2^c1 ; c3^c3"]}),
        ("A single-colour tower of three blocks.", {"assets": {"c1": 3}, "hold": ["c1^c1^c1"], "miss": ["c1^c1 ; c1"]}),
        ("Put the big and the small red block in a row.",
         {"assets": {"red{big}": 1, "red{small}": 1}, "hold": ["red{big} red{small}"],
          "miss": ["red{big} ; red{small}"]}),
        ("Put a yellow block on every mat except the red one. There are a red, a blue and a green mat.",
         {"assets": {"yellow": 2, "red_patch": 1, "blue_patch": 1, "green_patch": 1},
          "hold": ["yellow at=blue_patch ; yellow at=green_patch"],
          "miss": ["yellow at=blue_patch", "yellow at=red_patch ; yellow at=blue_patch"]}),
        ("Group the odd digits 1, 3 and the even digits 2, 4",
         {"assets": {"1": 1, "2": 1, "3": 1, "4": 1}, "hold": ["1 3 pitch=1 ; 2 4 pitch=1"],
          "miss": ["1 2 3 4 pitch=1", "1 2 pitch=1 ; 3 4 pitch=1"]}),
        ("There are three white and two black blocks. Take the white ones and make a tower.",
         {"assets": {"white": 3, "black": 2}, "hold": ["white^white^white"],
          "miss": ["white^white", "white^white^black^black^white"]}),
        ("A row of two blocks behind a row of three blocks, all brown.",
         {"assets": {"brown": 5}, "hold": [". brown brown . | . . . . | brown brown brown ."],
          "miss": ["brown brown brown . | . . . . | brown brown . ."]}),
        ("Build a red tower of two. Build a blue tower of two. Top each with a white block.",
         {"assets": {"red": 2, "blue": 2, "white": 2}, "hold": ["red^red^white ; blue^blue^white"],
          "miss": ["red^red ; blue^blue^white", "red^red^white ; blue^blue"]}),
        ("Build a row of three red blocks and put a white block on each.",
         {"assets": {"red": 3, "white": 3}, "hold": ["red^white red^white red^white"],
          "miss": ["red red red^white"]}),
        ("Red is next to blue and touches it. Blue is on the right.",
         {"assets": {"red": 1, "blue": 1}, "hold": ["red blue pitch=1"],
          "miss": ["blue red pitch=1", "red . blue pitch=1"]}),
        ("Leave K and M upright but turn L upside down.",
         {"assets": {"K": 1, "L": 1, "M": 1}, "hold": [["K ; L ; M", "M ; K ; L~180"]],
          "miss": [["K ; L ; M", "K ; L~180 ; M~180"]]}),
    ],
)  # fmt: skip
def test_what_is_meant_is_read(text: str, meant: dict[str, Any]) -> None:
    assert_means(text, meant)


def test_the_middle_one_is_one_block() -> None:
    schema, _ = BuiltinFrontEnd().read("A line of five, the middle one blue and the outer ones gray")
    assert schema is None or [block.color for block in schema.blocks].count("blue") == 1
