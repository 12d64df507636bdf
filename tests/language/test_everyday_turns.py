"""Everyday and formal turns of phrase: what they are read as, and near ones that are refused."""

from __future__ import annotations

from typing import Any

import pytest

from rpg.passes.schema.frontend import BuiltinFrontEnd
from tests.language.meaning import assert_means

_RING = {
    "assets": {"white": 1, "orange": 6},
    "hold": ["orange* circle=2 at=0,0 ; white at=0,0"],
    "miss": ["orange* circle=2 at=0,0 ; white at=0,4", "orange orange orange ; orange orange orange ; white at=0,0"],
}
_TWO_ROWS = {"assets": {"A": 1, "B": 1, "1": 1, "2": 1}, "hold": ["A B | 1 2"], "miss": ["1 2 | A B", "B A | 1 2"]}
_PAIR = {"assets": {"black": 1, "white": 1}, "hold": ["white | black"], "miss": ["black | white", "white black"]}
_CBA = {"start": ["C^B^A"], "assets": {"A": 1, "B": 1, "C": 1}, "hold": ["A^B^C"], "miss": ["C^B^A"]}


@pytest.mark.parametrize(
    ("text", "meant"),
    [
        # one on the other, and so many
        ("five green blocks straight up, one on the other",
         {"assets": {"green": 5}, "hold": ["green^green^green^green^green"], "miss": ["green^green^green^green"]}),
        ("rainbow row, 6", {"assets": {"red": 1, "orange": 1, "yellow": 1, "green": 1, "cyan": 1, "blue": 1},
                            "hold": ["red orange yellow green cyan blue"],
                            "miss": ["red orange yellow green blue cyan"]}),
        ("two (2) red blocks and one (1) blue block shall be stacked, the blue block uppermost",
         {"assets": {"red": 2, "blue": 1}, "hold": ["red^red^blue"], "miss": ["blue^red^red"]}),
        ("There are three red blocks. Make it one tower.",
         {"assets": {"red": 3}, "hold": ["red^red^red"], "miss": ["red red red"]}),
        # what is left open
        ("One of the three red cubes must be on the mat, the others are free.",
         {"assets": {"red": 3, "patch": 1}, "hold": ["red at=patch"],
          "miss": ["red ; red ; red", "red red pitch=1 at=patch"]}),
        ("could you get either the red or the blue one onto the gray patch, one's enough?",
         {"assets": {"red": 1, "blue": 1, "gray_patch": 1}, "hold": ["red at=gray_patch", "blue at=gray_patch"],
          "miss": ["red ; blue"]}),
        ("a tower of three blocks, colour immaterial",
         {"assets": {"c1": 1, "c2": 1, "c3": 1}, "hold": ["c1^c2^c3", "c3^c1^c2"], "miss": ["c1^c2"]}),
        # where something is
        ("put the black one in front and the white one right behind it", _PAIR),
        ("The white one goes at the back, the black one directly in front of it.", _PAIR),
        ("Put red cube in left from blue cube.",
         {"assets": {"red": 1, "blue": 1}, "hold": ["red blue"], "miss": ["blue red"]}),
        ("put the red cube on the left and the blue cube to the right of it",
         {"assets": {"red": 1, "blue": 1}, "hold": ["red blue"], "miss": ["blue red"]}),
        ("Place the blocks so that red is the farthest away from me and blue is the closest, with green in the middle.",
         {"assets": {"red": 1, "green": 1, "blue": 1}, "hold": ["red | green | blue"], "miss": ["blue | green | red"]}),
        ("Move the blue one a bit to the right, like 5 cm.",
         {"assets": {"blue": 1}, "hold": [["blue at=0,0", "blue at=0,-1.25"]],
          "miss": [["blue at=0,0", "blue at=0,1.25"], ["blue at=0,0", "blue at=0,-2.5"]]}),
        ("Put a cube in every corner, and the red one in the center of the table.",
         {"assets": {"c1": 4, "red": 1},
          "hold": ["c1 at=3,5 ; c1 at=3,-5 ; c1 at=-3,5 ; c1 at=-3,-5 ; red at=0,0"],
          "miss": ["c1 at=3,5 ; c1 at=3,-5 ; c1 at=-3,5 ; c1 at=0,0 ; red at=-3,-5"]}),
        ("The cube white has to be between the cubes red.",
         {"assets": {"white": 1, "red": 2}, "hold": ["red white red"], "miss": ["white red red"]}),
        ("The green cube and either the red cube or the blue cube, but not both, shall be on the mat.",
         {"assets": {"green": 1, "red": 1, "blue": 1, "patch": 1}, "hold": ["green red pitch=1 at=patch"],
          "miss": ["green at=patch", "green red blue pitch=1 at=patch"]}),
        # rows
        ("Make two rows: A B in the back and 1 2 in front of them.", _TWO_ROWS),
        ("Two rows: A, B behind 1, 2", _TWO_ROWS),
        ("blocks 1 thru 4, two ranks, odd numbers in the rear rank, even in the front",
         {"assets": {"1": 1, "2": 1, "3": 1, "4": 1}, "hold": ["1 3 | 2 4", "3 1 | 2 4"], "miss": ["2 4 | 1 3"]}),
        ("The three blocks in the near row should be blue and the three blocks in the far row should be green.",
         {"assets": {"blue": 3, "green": 3}, "hold": ["green green green | . . . | blue blue blue"],
          "miss": ["blue blue blue | . . . | green green green"]}),
        ("Make a palindrome out of the letters L, E, V, E and L.",
         {"assets": {"L": 2, "E": 2, "V": 1}, "hold": ["L E V E L", "E L V L E"], "miss": ["L E V L E"]}),
        ("The blue cube is two places to the right of the red cube in a row of red, blue, yellow and pink.",
         {"assets": {"red": 1, "blue": 1, "yellow": 1, "pink": 1},
          "hold": ["red pink blue yellow", "yellow red pink blue"],
          "miss": ["blue pink red yellow", "red blue pink yellow", "red pink yellow blue"]}),
        ("cubes 1..3, ascending L to R",
         {"assets": {"1": 1, "2": 1, "3": 1}, "hold": ["1 2 3"], "miss": ["3 2 1", "1 3 2"]}),
        ("Line up three blocks neatly, tallest at the left and shortest at the right.",
         {"assets": {"red{small}": 1, "blue": 1, "green{big}": 1}, "hold": ["green{big} blue red{small}"],
          "miss": ["red{small} blue green{big}"]}),
        ("I want to read 2 5 1 from left to right.",
         {"assets": {"1": 1, "2": 1, "5": 1}, "hold": ["2 5 1"], "miss": ["1 2 5"]}),
        ("Every other block in the row of four should be red, the rest white.",
         {"assets": {"red": 2, "white": 2}, "hold": ["red white red white", "white red white red"],
          "miss": ["red red white white"]}),
        ("There must be at least one block between green and white in a row of three blocks",
         {"assets": {"green": 1, "white": 1, "c1": 1}, "hold": ["green c1 white"], "miss": ["green white c1"]}),
        # towers
        ("three towers, each two high, each tower in one colour, no two the same",
         {"assets": {"c1": 2, "c2": 2, "c3": 2}, "hold": ["c1^c1 ; c2^c2 ; c3^c3"], "miss": ["c1^c2 ; c2^c1 ; c3^c3"]}),
        ("Two A blocks and two B blocks should be stacked alternately, A is lowest.",
         {"assets": {"A": 2, "B": 2}, "hold": ["A^B^A^B"], "miss": ["B^A^B^A", "A^A^B^B"]}),
        ("stack em: red bottom, then blue, then yellow cap",
         {"assets": {"red": 1, "blue": 1, "yellow": 1}, "hold": ["red^blue^yellow"], "miss": ["yellow^blue^red"]}),
        ("Please to make one tower with three blocks, the red block is down, the blue block is middle, the green block "
         "is up.", {"assets": {"red": 1, "blue": 1, "green": 1}, "hold": ["red^blue^green"],
                    "miss": ["green^blue^red"]}),
        ("Given a three-block tower with A on B and B on C, invert it such that C is on top of B and B is on top of A.",
         _CBA),
        ("Turn the tower upside down: it's now A on B on C.", _CBA),
        ("First dismantle the tower of two green cubes, placing each of them on the table, and only then line them up "
         "in a row.", {"start": ["green^green"], "assets": {"green": 2},
                       "hold": [["green^green", "green ; green", "green green"]], "miss": [["green^green"]]}),
        ("Knock down the tower of three red blocks and build a row instead.",
         {"start": ["red^red^red"], "assets": {"red": 3}, "hold": ["red red red"], "miss": ["red ; red ; red"]}),
        ("A tower of red, then next to it a tower of blue, both two high.",
         {"assets": {"red": 2, "blue": 2}, "hold": ["red^red blue^blue"], "miss": ["red^red ; blue^blue"]}),
        ("Start with the orange block sitting on the purple one. Swap them so that purple ends up on top.",
         {"start": ["purple^orange"], "assets": {"orange": 1, "purple": 1}, "hold": ["orange^purple"],
          "miss": ["purple^orange"]}),
        ("Three X blocks and three O blocks should be in a row alternately, X is leftmost.",
         {"assets": {"X": 3, "O": 3}, "hold": ["X O X O X O"], "miss": ["O X O X O X"]}),
        ("I'd be fine with any tower of three as long as the top is black.",
         {"assets": {"black": 1, "c1": 1, "c2": 1}, "hold": ["c1^c2^black"], "miss": ["black^c1^c2"]}),
        ("two columns, three each, yellow left, purple right",
         {"assets": {"yellow": 3, "purple": 3},
          "hold": ["yellow . purple | yellow . purple | yellow . purple"],
          "miss": ["purple . yellow | purple . yellow | purple . yellow"]}),
        ("Stack two red blocks, then on top of these two blue blocks.",
         {"assets": {"red": 2, "blue": 2}, "hold": ["red^red^blue^blue"], "miss": ["blue^blue^red^red"]}),
        ("Exchange the top block of the tower red, white, blue with the black block.",
         {"assets": {"red": 1, "white": 1, "blue": 1, "black": 1}, "start": ["red^white^blue ; black"],
          "hold": [["red^white^blue at=0,0 ; black at=0,3", "red^white^black at=0,0 ; blue at=0,3"]],
          "miss": [["red^white^blue at=0,0 ; black at=0,3", "red^white^blue at=0,0 ; black at=0,3"]]}),
        ("Take care that the tower of four has alternating colours, orange and cyan.",
         {"assets": {"orange": 2, "cyan": 2}, "hold": ["orange^cyan^orange^cyan"], "miss": ["orange^cyan^cyan"]}),
        # figures
        ("Build me a T junction out of 5 gray blocks",
         {"assets": {"gray": 5}, "hold": ["gray gray gray | . gray . | . gray ."],
          "miss": ["gray gray gray gray gray"]}),
        ("tetris L piece out of 4 orange blocks",
         {"assets": {"orange": 4}, "hold": ["orange . | orange . | orange orange"],
          "miss": ["orange orange | orange orange"]}),
        ("A checkerboard of 4 cubes, purple and yellow",
         {"assets": {"purple": 2, "yellow": 2}, "hold": ["purple yellow | yellow purple"],
          "miss": ["purple purple | yellow yellow"]}),
        ("could you lay out four blocks as a tray, 2 rows by 2, every row its own colour",
         {"assets": {"c1": 2, "c2": 2}, "hold": ["c1 c1 | c2 c2"], "miss": ["c1 c2 | c1 c2"]}),
        ("a plus-shaped cross in plan, five blocks, the centre one yellow and the four arms red",
         {"assets": {"yellow": 1, "red": 4}, "hold": [". red . | red yellow red | . red ."],
          "miss": [". yellow . | red red red | . red ."]}),
        ("Fill the middle column of a 3x3 grid with red blocks and the rest with gray ones.",
         {"assets": {"red": 3, "gray": 6}, "hold": ["gray red gray | gray red gray | gray red gray"],
          "miss": ["gray gray gray | red red red | gray gray gray"]}),
        ("place four red blocks into the four corners, one per corner",
         {"assets": {"red": 4}, "hold": ["red at=3,5 ; red at=3,-5 ; red at=-3,5 ; red at=-3,-5"],
          "miss": ["red at=3,5 ; red at=3,-5 ; red at=-3,5 ; red at=0,0"]}),
        # what goes around
        ("put the white block dead centre of the table and ring it with a circle of six orange ones", _RING),
        ("put the white block in the middle of the table. Six orange ones must form a ring around it.", _RING),
        ("ring the white block with eight orange ones",
         {"assets": {"white": 1, "orange": 8}, "hold": ["orange* circle=2 at=0,0 ; white at=0,0"],
          "miss": ["orange* circle=2 at=0,0 ; white at=0,4"]}),
        # groups
        ("make two pairs, each a red block next to a blue one",
         {"assets": {"red": 2, "blue": 2}, "hold": ["red blue ; blue red"], "miss": ["red blue red ; blue"]}),
        ("Make two groups: three reds with one blue, and three blues with one red.",
         {"assets": {"red": 4, "blue": 4}, "hold": ["red red red blue pitch=1 ; blue blue blue red pitch=1"],
          "miss": ["red red red red pitch=1 ; blue blue blue blue pitch=1"]}),
        ("Six blocks begin in a heap, and the player wins by sorting them into a red group and a yellow group, three "
         "each.", {"assets": {"red": 3, "yellow": 3}, "heap": 6, "hold": ["groups=color"],
                   "miss": ["red yellow red yellow red yellow pitch=1"]}),
        # the start, and steps
        ("Randomize the start: 4 cubes in a heap. Success iff they form two towers of equal height.",
         {"assets": {"plain": 4}, "heap": 4, "hold": ["red^blue ; green^yellow"], "miss": ["red^blue^green ; yellow"]}),
        ("Initially C is on A and B stands alone on the table; the goal is A on B and B on C.",
         {"assets": {"A": 1, "B": 1, "C": 1}, "start": ["A^C ; B"], "hold": ["C^B^A"], "miss": ["A^C ; B"]}),
        ("Move the red one first and then the green one, both onto the white mat.",
         {"assets": {"red": 1, "green": 1, "white_patch": 1},
          "hold": [["red ; green", "red at=white_patch ; green", "red green pitch=1 at=white_patch"]],
          "miss": [["red ; green", "green at=white_patch ; red", "red green pitch=1 at=white_patch"]]}),
        ("Make sure nothing is on top of the red block, the blue one is on it now.",
         {"assets": {"red": 1, "blue": 1}, "start": ["red^blue"], "hold": ["red ; blue"], "miss": ["red^blue"]}),
        # sums
        ("the sum must give 9: use the cubes 4, 5, +, = and 9",
         {"assets": {"4": 1, "5": 1, "+": 1, "=": 1, "9": 1}, "hold": ["4 + 5 = 9", "9 = 5 + 4"],
          "miss": ["4 5 + = 9", "9 + 4 = 5"]}),
        # of whom it is said
        ("No red block may touch a green block. 2 red, 2 green. All of them in one row.",
         {"assets": {"red": 2, "green": 2}, "hold": ["red green red green"], "miss": ["red red ; green ; green"]}),
        ("a tower of four, all in different colours, only the red one must not be at the bottom",
         {"assets": {"red": 1, "blue": 1, "green": 1, "yellow": 1}, "hold": ["blue^red^green^yellow"],
          "miss": ["red^blue^green^yellow", "blue^red^green"]}),
        ("Any red block shall be placed to the left of any blue block. There are two red and two blue blocks.",
         {"assets": {"red": 2, "blue": 2}, "hold": ["red red . blue blue"], "miss": ["red blue red blue"]}),
    ],
)  # fmt: skip
def test_it_is_read_as_it_is_meant(text: str, meant: dict[str, Any]) -> None:
    assert_means(text, meant)


@pytest.mark.parametrize(
    "text",
    [
        "put the white block on the red mat and six orange blocks around it.",
        "put the white block in the middle of the table, the red one next to it and six orange blocks around it.",
        "Put one block in each corner of the table. The red one goes in the middle.",
        "There are two red and two green blocks. No red block may touch a green block. They form a row.",
        "Line up A, B, C, I and E with the vowels at the ends.",
        "Make a palindrome out of the letters L, E and V.",
        "tetris T piece out of 5 orange blocks",
        "Two (3) red blocks must be stacked",
        "One of the two mats must hold the red block, the other is free.",
        "put the red block on the left mat and the blue block to the right of it",
        "Every other block in the row of five should be red, the rest white.",
        "Build a tower with as many red as blue blocks, seven in total.",
        "In a row of A, B, C, D, E is three positions to the left of B.",
        "letters A to F in two rows: A, B, C in front of D, E",
        "stack red at the bottom and blue and green on top",
        "Any red block must be placed on the mat. There are two red blocks.",
        "a row of five blocks, one on the other",
        "the sum must give 4: use the cubes 4, 5, +, = and 9",
        "the sum must give 9: use the cubes 4, 5, -, = and 9",
        "line of four blocks from the near left corner to the far right corner",
        "make three pairs of blocks",
        "put the white block on the mat. Put six orange blocks in a circle around it.",
    ],
)
def test_what_could_be_meant_otherwise_is_refused(text: str) -> None:
    schema, diagnostics = BuiltinFrontEnd().read(text)
    assert schema is None
    assert any(d.severity == "error" for d in diagnostics)
