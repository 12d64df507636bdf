"""One of several that look alike, what is left without it, and what a last sentence adds."""

from __future__ import annotations

from typing import Any

import pytest

from rpg.passes.schema.frontend import BuiltinFrontEnd
from tests.language.meaning import assert_means

THREE_RED = {
    "assets": {"red": 3, "patch": 1},
    "start": ["red^red^red"],
    "hold": ["red at=patch ; red^red"],
    "miss": ["red^red^red at=patch", "red^red^red", "red^red at=patch ; red"],
}
ONE_OF_TWO = {
    "assets": {"black": 2, "white": 1, "patch": 1},
    "hold": ["black at=patch ; black ; white"],
    "miss": ["black . black at=patch ; white", "white at=patch ; black ; black"],
}
SUN = {"assets": {"S": 1, "U": 1, "N": 1}, "hold": ["S U N"], "miss": ["N U S", "S N U"]}
THREE_STEPS = {
    "assets": {"A": 1, "B": 1, "C": 1, "red_patch": 1},
    "hold": [["A ; B ; C", "A at=red_patch ; B ; C", "A^B at=red_patch ; C", "A^B^C at=red_patch"]],
    "miss": [["A ; B ; C", "A^B ; C", "A^B^C at=red_patch"], ["A ; B ; C", "A at=red_patch ; B ; C"]],
}


@pytest.mark.parametrize(
    ("text", "meant"),
    [
        ("Take the top cube off the tower of three red cubes and put it on the patch.", THREE_RED),
        ("Take the top cube from the tower of three red cubes and put it on the patch.", THREE_RED),
        ("There is a tower of three red cubes. Put the top one on the patch.", THREE_RED),
        ("Two black blocks and a white one on the table. One black block is on the mat, the other is not.", ONE_OF_TWO),
        ("There are two black blocks and a white one. One black block is on the mat, the other is not.", ONE_OF_TWO),
        ("There are two black and two white blocks. One black block is on a white one, the other is not.",
         {"assets": {"black": 2, "white": 2}, "hold": ["white^black ; black ; white"],
          "miss": ["white^black ; white^black", "black ; black ; white ; white"]}),
        ("Please put the letters of the word SUN next to each other so that the class can read it.", SUN),
        ("Spell SUN so that my little brother can read it.", SUN),
        ("First lay the A on the red mat, then stack the B on the A, and at the end the C on the B.", THREE_STEPS),
        ("First put A on the red mat, then put B on A, and in the end put C on B.", THREE_STEPS),
        ("At the start red is left of green, which is left of a blue block. Put red on blue.",
         {"assets": {"red": 1, "green": 1, "blue": 1}, "start": ["red green blue"],
          "start_miss": ["green red blue", "red blue green"], "hold": ["blue^red ; green"],
          "miss": ["red blue green"]}),
        ("Blue on green on red at the start. Put blue on the table.",
         {"assets": {"red": 1, "green": 1, "blue": 1}, "start": ["red^green^blue"],
          "start_miss": ["red ; green ; blue", "blue^green^red"], "hold": ["red^green ; blue"],
          "miss": ["red^green^blue"]}),
        ("Red on blue, green on white at the start. Swap red and green.",
         {"assets": {"red": 1, "green": 1, "blue": 1, "white": 1}, "start": ["blue^red ; white^green"],
          "start_miss": ["blue ; red ; white^green"]}),
        ("Take the white cube off the tower of two black ones and put it to the right of the tower.",
         {"assets": {"black": 2, "white": 1}, "start": ["black^black^white"], "start_miss": ["black^black ; white"],
          "hold": ["black^black white"], "miss": ["white black^black", "black^black^white"]}),
        ("Stack red, blue and green from bottom to top, then put the green block back on the table.",
         {"assets": {"red": 1, "green": 1, "blue": 1},
          "hold": [["red ; green ; blue", "red^blue^green", "red^blue ; green"]],
          "miss": [["red ; green ; blue", "red^blue ; green"], ["red ; green ; blue", "red^blue^green"],
                   ["red ; green ; blue", "red^blue^green", "red ; blue ; green"]]}),
        ("Of the red, green and blue blocks only the green one touches the table.",
         {"assets": {"red": 1, "green": 1, "blue": 1}, "hold": ["green^red^blue"], "miss": ["green^red ; blue"]}),
        ("Four letter blocks, A, B, C and D, stand in a row. B is immediately to the left of C, and A is at the right.",
         {"assets": {"A": 1, "B": 1, "C": 1, "D": 1}, "hold": ["D B C A", "B C D A"], "miss": ["B D C A"]}),
        ("Put the cyan block flanked by a red block on its left and a gray one on its right.",
         {"assets": {"cyan": 1, "red": 1, "gray": 1}, "hold": ["red cyan gray"], "miss": ["gray cyan red"]}),
        ("Put all but one of the six white blocks in a row.",
         {"assets": {"white": 6}, "hold": ["white white white white white ; white"],
          "miss": ["white white white white white white", "white white white white ; white white"]}),
        ("Red on blue, green on white at the start. Swap the two top blocks.",
         {"assets": {"red": 1, "green": 1, "blue": 1, "white": 1}, "start": ["blue^red ; white^green"],
          "hold": [["blue^red at=0,3 ; white^green at=0,-3", "blue^green at=0,3 ; white^red at=0,-3"]],
          "miss": [["blue^red at=0,3 ; white^green at=0,-3", "white^green at=0,3 ; blue^red at=0,-3"]]}),
        ("Take two blocks off the tower of four red blocks.",
         {"assets": {"red": 4}, "hold": [["red^red^red^red", "red^red ; red ; red"]],
          "miss": [["red^red^red^red", "red^red^red^red"], ["red^red^red^red", "red^red^red ; red"]]}),
        ("Don't take the red block off the blue one. Put the green one on top of the red one.",
         {"assets": {"red": 1, "green": 1, "blue": 1}, "start": ["blue^red ; green"],
          "start_miss": ["red^blue ; green", "red ; blue ; green"]}),
        ("Only the green block is between the two red blocks. There is also a blue block.",
         {"assets": {"red": 2, "green": 1, "blue": 1}, "hold": ["red green red ; blue"],
          "miss": ["red green blue red", "red blue red ; green"]}),
        ("At least one yellow block is on the white patch, and at least one green block is not. There are two of each.",
         {"assets": {"yellow": 2, "green": 2, "white_patch": 1},
          "hold": ["yellow . green at=white_patch ; yellow ; green", "yellow at=white_patch"],
          "miss": ["green . green . yellow at=white_patch", "green at=white_patch ; yellow ; yellow ; green"]}),
        ("Put the red block on my right and the blue one on my left.",
         {"assets": {"red": 1, "blue": 1}, "hold": ["red at=0,-4 ; blue at=0,4"],
          "miss": ["red at=0,-4 ; blue at=0,-2", "red at=0,4 ; blue at=0,-4"]}),
        ("The circle has four red and four blue blocks, taking turns.",
         {"assets": {"red": 4, "blue": 4}, "hold": ["red blue red blue red blue red blue circle=2"],
          "miss": ["red red red red blue blue blue blue circle=2"]}),
        ("Letters and digits alternate in a row: A, B, 1 and 2.",
         {"assets": {"A": 1, "B": 1, "1": 1, "2": 1}, "hold": ["A 1 B 2", "2 A 1 B"], "miss": ["A B 1 2"]}),
        ("Start with a stack of three: red at the bottom, then blue, then green on top. Remove only the top one and "
         "set it on the table.",
         {"assets": {"red": 1, "blue": 1, "green": 1}, "start": ["red^blue^green"],
          "hold": [["red^blue^green at=0,0", "red^blue at=0,0 ; green at=0,4"]],
          "miss": [["red^blue^green at=0,0", "red at=0,0 ; blue at=0,-4 ; green at=0,4"]]}),
        ("Three blocks in one tower, red, white, blue; red isn't allowed at the bottom.",
         {"assets": {"red": 1, "white": 1, "blue": 1}, "hold": ["white^red^blue", "blue^white^red"],
          "miss": ["red^white^blue"]}),
        ("Five blocks in a row, red, blue, green, white and gray: neither the red nor the blue one may stand at an "
         "end.",
         {"assets": {"red": 1, "blue": 1, "green": 1, "white": 1, "gray": 1}, "hold": ["green red white blue gray"],
          "miss": ["red blue green white gray", "green white gray red blue"]}),
        ("A, B and C, along with D, form a tower.",
         {"assets": {"A": 1, "B": 1, "C": 1, "D": 1}, "hold": ["A^B^C^D"], "miss": ["A^B^C ; D"]}),
        ("The red block, together with the blue one, is on the mat.",
         {"assets": {"red": 1, "blue": 1, "patch": 1}, "hold": ["red . blue at=patch"],
          "miss": ["red at=patch ; blue"]}),
        ("The digits 3, 4 and 7, together with a plus and an equals sign, show a true equation.",
         {"assets": {"3": 1, "4": 1, "7": 1, "+": 1, "=": 1}, "hold": ["3 + 4 = 7"], "miss": ["3 4 + 7 ="]}),
        ("After the red cube is on the patch, put the blue cube on the green one.",
         {"assets": {"red": 1, "blue": 1, "green": 1, "patch": 1}}),
        ("Put the red block next to the blue block, and the green one too.",
         {"assets": {"red": 1, "blue": 1, "green": 1}, "hold": ["red blue green pitch=1"],
          "miss": ["red blue ; green"]}),
        ("The red block starts on the green patch. Take it away, so that the patch is empty.",
         {"assets": {"red": 1, "green_patch": 1}, "start": ["red at=green_patch"],
          "hold": [["red at=green_patch", "red"]]}),
    ],
)  # fmt: skip
def test_one_taken_of_many(text: str, meant: dict[str, Any]) -> None:
    assert_means(text, meant)


@pytest.mark.parametrize(
    "text",
    [
        "Put the red blocks in turn on the mat.",
        "Two blue blocks stand side by side; the left one has a red one, the right one a green one.",
        "Lay out S, U and N so that the children can read it.",
        "Two red blocks and a blue one in the middle",
        "The tower is red, green, blue from the bottom. First take blue off it, then green.",
        "Four blocks in a row, each of a different colour, and all of them green.",
        "A, B, C and D stand in a row. Only B is turned a quarter turn to the left. Straighten it.",
        "Two boxes on the red mat, the same number on the blue one and none on the green one.",
        "Two of the three black cubes carry a green one each; the other carries nothing.",
        "Stack the black block on either the pink block or the gray block, and put the other blocks on the table.",
        "There are a red, a green and a blue patch. Each of them gets two of the six white blocks.",
        "Put A on B. C is a distractor. Put it on the mat.",
        "put 8 red blocks in a circle and a white one outside it",
        "There are two blue blocks, one of them on the green patch. Put the red block on that one.",
        "There is a tower of red, green and blue. Put only blue on the table.",
    ],
)
def test_what_could_be_meant_otherwise_is_refused(text: str) -> None:
    assert BuiltinFrontEnd().read(text)[0] is None
