"""How something is and has to become, words that are there and changed, words along a column, sizes of each of several
lines, and modifiers that must show in the task or are asked about."""

from __future__ import annotations

from typing import Any

import pytest

from rpg.passes.schema.frontend import BuiltinFrontEnd
from tests.language.meaning import assert_means

Meant = dict[str, Any]

RIGHT_OF: Meant = {
    "assets": {"red": 1, "blue": 1},
    "start": ["blue red"],
    "start_miss": ["red blue"],
    "hold": ["red blue"],
    "miss": ["blue red", "blue | red"],
}
BEHIND: Meant = {
    "assets": {"red": 1, "blue": 1},
    "start": ["blue | red"],
    "start_miss": ["red | blue"],
    "hold": ["red | blue"],
    "miss": ["blue | red"],
}
NET: Meant = {
    "assets": {"T": 1, "E": 1, "N": 1},
    "start": ["T E N pitch=1"],
    "start_miss": ["N E T pitch=1"],
    "hold": ["N E T pitch=1"],
    "miss": ["T E N pitch=1", "N T E pitch=1"],
}
CAT: Meant = {
    "assets": {"C": 1, "A": 1, "T": 1, "S": 1},
    "start": ["C A T S pitch=1"],
    "hold": ["C A T pitch=1 ; S"],
    "miss": ["C A T S pitch=1", "S ; T A C pitch=1"],
}
ON_AND_OFF: Meant = {
    "assets": {"red": 1, "blue": 1},
    "hold": [["red ; blue", "blue^red", "red ; blue"]],
    "miss": [["red ; blue", "red ; blue"], ["red ; blue", "blue^red"]],
}
BIG_AND_SMALL: Meant = {
    "assets": {"red{big}": 3, "blue{small}": 3},
    "hold": ["red{big} red{big} red{big} pitch=1.5 at=3,0 ; blue{small} blue{small} blue{small} pitch=1.5 at=-3,0"],
    "miss": ["blue{small} blue{small} blue{small} pitch=1.5 at=3,0 ; red{big} red{big} red{big} pitch=1.5 at=-3,0"],
}
STAR: Meant = {
    "assets": {"S": 1, "T": 1, "A": 1, "R": 1},
    "hold": ["S | T | A | R"],
    "miss": ["R | A | T | S", "S T A R", "R^A^T^S"],
}
TOP_RIGHT: Meant = {"assets": {"R": 1}, "hold": ["R~-90", "R~-90 at=0,3"], "miss": ["R", "R~90", "R at=0,-3"]}


@pytest.mark.parametrize(
    ("text", "meant"),
    [
        ("Red is left of blue. I want it on the right instead.", {**RIGHT_OF, "start": ["red blue"],
         "start_miss": ["blue red"], "hold": ["blue red"], "miss": ["red blue"]}),
        ("Red is to the right of blue now. Put it on the left.", RIGHT_OF),
        ("Red is in front of blue. Change that so it is behind.", BEHIND),
        ("Brown isn't on pink yet. Change that.",
         {"assets": {"brown": 1, "pink": 1}, "hold": ["pink^brown"], "miss": ["brown^pink", "brown pink"]}),
        ("Gray is on white now but must not be at the end.",
         {"assets": {"gray": 1, "white": 1}, "start": ["white^gray"], "start_miss": ["gray^white"],
          "hold": ["white ; gray"], "miss": ["white^gray"]}),
        ("At some point the red block must be on the blue one, but not at the end.", ON_AND_OFF),
        ("The word on the table is TEN. Make it NET.", NET),
        ("The row reads TEN. Swap two letters so that it reads NET.", NET),
        ("CATS lies on the table. Take the S away so that CAT is left.", CAT),
        ("The cubes spell CATS at first. Take one away so that they spell CAT.", CAT),
        ("Two rows: the three big red blocks behind, the three small blue ones in front.", BIG_AND_SMALL),
        ("Spell STAR in a column, reading from back to front.", STAR),
        ("The word STAR in a column on the table.", STAR),
        ("the R lies with its top to the right", TOP_RIGHT),
        ("Turn the R so that its top is to the right.", TOP_RIGHT),

        ("Build a tower of four in which the purple block sits somewhere above the orange one; the other two may be of "
         "any colour you like.",
         {"assets": {"purple": 1, "orange": 1, "plain": 2}, "hold": ["plain^orange^purple^plain"],
          "miss": ["plain^purple^orange^plain"]}),
        ("From left to right lie 1, 2 and 3. Turn the middle one upside down.",
         {"assets": {"1": 1, "2": 1, "3": 1}, "start": ["1 2 3"], "start_miss": ["1 3 2"], "hold": ["1 2~180 3"],
          "miss": ["1~180 2 3"]}),
        ("There are a pink, a red and a blue block. Put the pink one in the right half of the table, and no other "
         "block there.",
         {"assets": {"pink": 1, "red": 1, "blue": 1}, "hold": ["pink at=0,-3 ; red at=0,3 ; blue at=2,4"],
          "miss": ["pink at=0,-3 ; red at=2,-4 ; blue at=0,3", "pink at=0,3 ; red at=2,4 ; blue at=-2,4"]}),
        ("There are a red, a green and a blue block. Put the green one on the red one and move nothing else.",
         {"assets": {"red": 1, "green": 1, "blue": 1},
          "hold": [["green at=0,4 ; red at=0,0 ; blue at=0,-4", "red^green at=0,0 ; blue at=0,-4"]],
          "miss": [["green at=0,4 ; red at=0,0 ; blue at=0,-4", "red^green at=3,0 ; blue at=0,-4"],
                   ["green at=0,4 ; red at=0,0 ; blue at=0,-4", "red^green at=0,0 ; blue at=4,-4"]]}),
        ("A tower of red, white and blue stands there, with red at the bottom and blue on top. Rebuild it with the "
         "blue one in the middle.",
         {"assets": {"red": 1, "white": 1, "blue": 1}, "start": ["red^white^blue"], "start_miss": ["red^blue^white"],
          "hold": ["red^blue^white", "white^blue^red"], "miss": ["red^white^blue"]}),
        ("A tower has red at the bottom, then blue, then green. Lay its blocks in a row, beginning with the top one.",
         {"assets": {"red": 1, "blue": 1, "green": 1}, "start": ["red^blue^green"], "start_miss": ["green^blue^red"],
          "hold": ["green blue red"], "miss": ["red blue green", "green red blue"]}),
        ("There is a row of red, blue and green. Stack its blocks, starting with the right one.",
         {"assets": {"red": 1, "blue": 1, "green": 1}, "start": ["red blue green"], "hold": ["green^blue^red"],
          "miss": ["red^blue^green", "green^red^blue"]}),
        ("The E is upright. Turn it a quarter turn to the left.",
         {"assets": {"E": 1}, "start": ["E"], "start_miss": ["E~90"], "hold": [["E", "E~90"]], "miss": [["E", "E"]]}),
        ("The red block touches the blue block. Separate them.",
         {"assets": {"red": 1, "blue": 1}, "start": ["red blue pitch=1"], "start_miss": ["red ; blue"],
          "hold": ["red ; blue"], "miss": ["red blue pitch=1"]}),
        ("The A is upside down. Set it right.",
         {"assets": {"A": 1}, "start": ["A~180"], "start_miss": ["A"], "hold": ["A", "A at=0,-3"],
          "miss": ["A~180", "A~180 at=0,-3"]}),
        ("The L lies on its side. Put it upright.",
         {"assets": {"L": 1}, "start": ["L~90", "L~-90"], "start_miss": ["L"], "hold": ["L"], "miss": ["L~90"]}),
        ("Four blocks form a square. Make a row out of them.",
         {"assets": {"plain": 4}, "start": ["plain plain | plain plain"], "start_miss": ["plain plain plain plain"],
          "hold": ["plain plain plain plain"], "miss": ["plain plain | plain plain"]}),
        ("All six blocks are on the left half. Three of them should be on the right half.",
         {"assets": {"plain": 6}, "start": ["plain* at=0,5"],
          "hold": ["plain plain plain at=0,4 ; plain plain plain at=0,-4"],
          "miss": ["plain* at=0,5", "plain plain plain plain at=0,4 ; plain plain at=0,-4"]}),
        ("The mat is free. Red should be on it.",
         {"assets": {"red": 1, "patch": 1}, "start": ["red"], "start_miss": ["red at=patch"],
          "hold": ["red at=patch"], "miss": ["red"]}),
        ("Red is not on blue. It should be on blue.",
         {"assets": {"red": 1, "blue": 1}, "start": ["blue ; red"], "start_miss": ["blue^red"], "hold": ["blue^red"],
          "miss": ["blue ; red", "red^blue"]}),
        ("The red block is in the middle. It must go to a corner.",
         {"assets": {"red": 1}, "start": ["red at=0,0"], "hold": ["red at=5,7"], "miss": ["red at=0,0"]}),
    ],
)  # fmt: skip
def test_starts_and_goals(text: str, meant: Meant) -> None:
    assert_means(text, meant)


@pytest.mark.parametrize("text", [
    "Four cubes stand at the corners of a square measuring 20 cm on a side, touching each other.",
    "Three red blocks in a row, and in front of them three blue blocks in a row without touching the table.",
    "Build two equal towers of four red blocks each with the largest on the left.",
    "The red one should be right of the yellow one with nothing between them.",
    "Red block closest to me, blue block farthest away, always.",
    "Put the vowel out of B, C and D on the red patch.",
    "Two towers of two white blocks stand on the table. Put a red block on one of them.",
    "The A lies upright on the table. Give it a quarter turn clockwise.",
    "Three blocks stand on the mat. Two should be on it.",
    "Red is on the mat, blue may be.",
    "Put the red block in a corner, and no other block there. There are also two blue blocks.",
    "Put the big red block on a grid of two by two blue blocks, all of the same size.",
])  # fmt: skip
def test_what_would_not_show_in_the_task_is_asked_about(text: str) -> None:
    assert BuiltinFrontEnd().read(text)[0] is None
