"""Towers, rows, words and sums asked for in everyday ways: each means one figure, and what comes near it is refused."""

from __future__ import annotations

from typing import Any

import pytest

from rpg.passes.schema.frontend import BuiltinFrontEnd
from tests.language.meaning import assert_means

Meant = dict[str, Any]
TOWER: Meant = {"assets": {"red": 3}, "hold": ["red^red#2^red#3"], "miss": ["red^red#2 ; red#3", "red red#2 red#3"]}
ROW: Meant = {"assets": {"red": 4}, "hold": ["red* at=0,0"], "miss": ["red^red#2 ; red#3 red#4", "red^*"]}
RING: Meant = {"assets": {"orange": 8, "green": 1}, "hold": ["orange* circle=1.7 at=0,0; green at=0,0"],
               "miss": ["orange* circle=1.7 at=0,2; green at=0,-5", "orange* ; green"]}  # fmt: skip
CAT: Meant = {"assets": {"C": 1, "A": 1, "T": 1}, "hold": ["C A T"], "miss": ["T A C", "C ; A ; T"]}
CAT_DOWN: Meant = {"assets": {"C": 1, "A": 1, "T": 1}, "hold": ["T^A^C"], "miss": ["C^A^T", "C A T"]}
SUM: Meant = {"assets": {"2": 1, "+": 1, "5": 1, "=": 1, "7": 1}, "hold": ["2 + 5 = 7", "7 = 2 + 5"],
              "miss": ["7 + 2 = 5", "2 5 7 + ="]}  # fmt: skip
SORTED: Meant = {"assets": {"A": 1, "B": 1, "C": 1}, "hold": ["A B C"], "miss": ["B A C", "C B A"]}
GRID: Meant = {"assets": {"red": 3, "white": 3, "black": 3},
               "hold": ["red red red | white white white | black black black"],
               "miss": ["black black black | white white white | red red red",
                        "red white black | red white black | red white black"]}  # fmt: skip
NUMBERED: Meant = {"assets": {str(n): 1 for n in range(1, 10)}, "hold": ["1 2 3 | 4 5 6 | 7 8 9"],
                   "miss": ["7 8 9 | 4 5 6 | 1 2 3", "1 4 7 | 2 5 8 | 3 6 9"]}  # fmt: skip
AHEAD: Meant = {"assets": {"A": 1, "E": 1, "R": 1, "S": 1}, "hold": ["A E R S", "E A S R"],
                "miss": ["R A E S", "A R E S", "A E ; R S"]}  # fmt: skip
STRIPED: Meant = {"assets": {"red": 2, "blue": 2}, "hold": ["red^blue^red^blue"],
                  "miss": ["blue^red^blue^red", "red^red^blue^blue"]}  # fmt: skip
FALLING: Meant = {"assets": {"red{6}": 1, "blue{5}": 1, "white{3}": 1}, "hold": ["red{6}^blue{5}^white{3}"],
                  "miss": ["white{3}^blue{5}^red{6}", "blue{5}^red{6}^white{3}"]}  # fmt: skip
BIG_ON_TOP: Meant = {"assets": {"2": 1, "4": 1, "6": 1}, "hold": ["2^4^6"], "miss": ["6^4^2", "4^2^6"]}
LAYERS: Meant = {"assets": {"white": 8, "red": 4}, "hold": ["white^red^white white^red^white | white^red^white "
                                                           "white^red^white pitch=1"],
                 "miss": ["red^white^white white^red^white | white^red^white white^red^white pitch=1"]}  # fmt: skip
RAINBOW: Meant = {"assets": {"red": 1, "orange": 1, "yellow": 1, "green": 1, "blue": 1},
                  "hold": ["red orange yellow green blue"], "miss": ["blue green yellow orange red",
                                                                    "red yellow orange green blue"]}  # fmt: skip


@pytest.mark.parametrize(
    ("text", "meant"),
    [
        ("Let us raise a tower of three red blocks.", TOWER),
        ("Generate a tower of three red blocks", TOWER),
        ("We should try a tower of three red blocks.", TOWER),
        ("A tower of three red blocks is specified.", TOWER),
        ("A tower of three red blocks is given as the goal.", TOWER),
        ("We consider a tower of three red blocks.", TOWER),
        ("Granny wants her tower of three red blocks now.", TOWER),
        ("Mommy can you make a tower of three red blocks?", TOWER),
        ("A tower of three cubes, red ones.", TOWER),
        ("Stack me three red cubes, one straight on top of the other.", TOWER),
        ("Visitors should see a row of four red blocks.", ROW),
        ("On this display, four red blocks stand in a row.", ROW),
        ("Help the four red blocks form a row.", ROW),
        ("The parties agree that four red blocks shall be arranged in a row.", ROW),
        ("A line of bricks, four of them, all red.", {**ROW, "hold": ["red* at=0,0", "red | red#2 | red#3 | red#4"]}),
        ("Eight orange blocks hold hands in a circle, and one green block is in the middle of the circle.", RING),
        ("Visitors should see the word CAT spelled out from left to right.", CAT),
        ("Today's word is CAT, please spell it.", CAT),
        ("My cat's name is CAT, so please write CAT with the letter blocks.", CAT),
        ("i wanna spell my name which is CAT with the blocks", CAT),
        ("Write CAT in block letters across the table.", CAT),
        ("put c a t in a row so it reads cat", CAT),
        ("stack c a t so it reads cat from top to bottom", CAT_DOWN),
        ("The final tower spells CAT when read from top to bottom.", CAT_DOWN),
        ("Our word of the day is CAT, please write it from top to bottom.", CAT_DOWN),
        ("Today's sum is 2 + 5 = 7, please lay it out with the cubes.", SUM),
        ("The solution is 2+5=7, so build it.", SUM),
        ("Please do the sum 2 + 5 and show the answer too.", SUM),
        ("Show me how much 2 plus 5 is using the number blocks.", SUM),
        ("Help the letters B, A and C stand in a row in alphabetical order.", SORTED),
        ("On this display the letters A to C run in alphabetical order from left to right.", SORTED),
        ("Put the letters A to C in a row so that the kids can read them in alphabetical order.", SORTED),
    ],
)
def test_figures_asked_for_in_passing_are_read(text: str, meant: Meant) -> None:
    assert_means(text, meant)


@pytest.mark.parametrize(
    ("text", "meant"),
    [
        ("Take a 3x3 grid whose back row is red, whose middle row is white and whose front row is black.", GRID),
        ("We consider a grid of three rows and three columns in which each row is monochromatic, the far row being "
         "red, the middle row white and the near row black.", GRID),
        ("Three by three grid numbered 1 through 9, left to right, top to bottom.", NUMBERED),
        ("Arrange the number cubes 1 to 9 in a 3x3 grid so that the children can count them in reading order.",
         NUMBERED),
        ("A grid having three rows and three columns shall be formed of the digits 1 to 9, the far row being occupied "
         "by 1, 2 and 3, the middle row by 4, 5 and 6 and the near row by 7, 8 and 9 from left to right.", NUMBERED),
        ("A 2x2 block of three layers is specified: bottom layer white, middle layer red, top layer white again.",
         LAYERS),
        ("In a row, the vowels A and E come before the consonants R and S.", AHEAD),
        ("Success iff, in a single left-to-right row, all vowels (A, E) come before all consonants (R, S).", AHEAD),
        ("In a row, A and E come before R and S.", AHEAD),
        ("In a row, red comes before blue and green.",
         {"assets": {"red": 1, "blue": 1, "green": 1}, "hold": ["red blue green", "red green blue"],
          "miss": ["blue red green", "green blue red"]}),
        ("Tower: 4 cubes, alternating red/blue, red at the bottom.", STRIPED),
        ("Make me a striped tower, four blocks, red and blue stripes, red on the bottom.", STRIPED),
        ("A stack of four cubes with alternating colors, red at the base and blue above it.", STRIPED),
        ("Stack them by size, biggest at the bottom: the red block is 6 cm, the blue one 5 cm and the white one 3 cm.",
         FALLING),
        ("The red block is 6 cm, the blue one 5 cm and the white one 3 cm. Stack them by size, biggest at the bottom.",
         FALLING),
        ("Build a tower with 2, 4 and 6 from smallest to biggest with the biggest on top.", BIG_ON_TOP),
        ("Build a tower with 2, 4 and 6 in which the biggest number is on top and the smallest is at the bottom.",
         BIG_ON_TOP),
        ("Red, orange, yellow, green, blue: one block of each, side by side in rainbow order with red at the left end.",
         {**RAINBOW, "hold": ["red orange yellow green blue pitch=1.1"]}),
        ("Granny wants her rainbow now, that is red, orange, yellow, green and blue in one row with red on the left.",
         RAINBOW),
        ("A rainbow row from red on the left to yellow on the right.",
         {"assets": {"red": 1, "orange": 1, "yellow": 1}, "hold": ["red orange yellow"],
          "miss": ["red yellow orange"]}),
        ("A brown cube, on that a white one, and on top a pink one.",
         {"assets": {"brown": 1, "white": 1, "pink": 1}, "hold": ["brown^white^pink"],
          "miss": ["pink^brown^white", "brown^pink^white"]}),
        ("make a tower out of 2 red blocks and then 2 blue ones on the very top",
         {"assets": {"red": 2, "blue": 2}, "hold": ["red^red#2^blue^blue#2"], "miss": ["blue^blue#2^red^red#2"]}),
        ("A row of five blocks with the middle one purple and the two on each side of it yellow.",
         {"assets": {"purple": 1, "yellow": 4}, "hold": ["yellow yellow#2 purple yellow#3 yellow#4"],
          "miss": ["purple yellow*", "yellow purple yellow#2 yellow#3 yellow#4"]}),
        ("Set up a tower where every block is a different colour, three blocks.",
         {"assets": {"c1": 1, "c2": 1, "c3": 1}, "hold": ["c1^c2^c3"], "miss": ["c1^c2 ; c3"]}),
        ("A tower with 3 floors, each a different color.",
         {"assets": {"c1": 1, "c2": 1, "c3": 1}, "hold": ["c1^c2^c3"], "miss": ["c1^c2 ; c3"]}),
        ("A tower of three floors: the top floor is red, the middle floor blue and the ground floor green.",
         {"assets": {"red": 1, "blue": 1, "green": 1}, "hold": ["green^blue^red"], "miss": ["red^blue^green"]}),
        ("A row that begins and ends with a black block and has three white blocks between.",
         {"assets": {"black": 2, "white": 3}, "hold": ["black white white#2 white#3 black#2"],
          "miss": ["black black#2 white*"]}),
        ("Row of 5; middle = red; others = white.",
         {"assets": {"red": 1, "white": 4}, "hold": ["white white#2 red white#3 white#4"],
          "miss": ["red white*"]}),
        ("Sixteen cubes in a 4x4 grid, rows alternating green and white.",
         {"assets": {"green": 8, "white": 8},
          "hold": [" | ".join(2 * ["green green green green", "white white white white"])],
          "miss": [" | ".join(4 * ["green white green white"])]}),
        ("A grid of 2 rows x 2 columns, odd columns black, even columns yellow.",
         {"assets": {"black": 2, "yellow": 2}, "hold": ["black yellow | black yellow"],
          "miss": ["black black | yellow yellow", "black yellow | yellow black"]}),
        ("A pyramid of red bricks with a single white one crowning it.",
         {"assets": {"red": 5, "white": 1}, "hold": ["side . . white . . | . red . red . | red . red . red pitch=0.55"],
          "miss": ["side . . red . . | . white . red . | red . red . red pitch=0.55"]}),
        ("How about a nice pattern: red, red, blue in a row?",
         {"assets": {"red": 2, "blue": 1}, "hold": ["red red#2 blue"], "miss": ["red blue red#2"]}),
        ("Stack in this order from below: A, then B, then C on the very top.",
         {"assets": {"A": 1, "B": 1, "C": 1}, "hold": ["A^B^C"], "miss": ["C^B^A"]}),
        ("A wall with a checker pattern, 2 wide, 2 high, colours orange and purple.",
         {"assets": {"orange": 2, "purple": 2}, "hold": ["orange^purple purple^orange pitch=1"],
          "miss": ["orange^orange#2 purple^purple#2 pitch=1"]}),
        ("Make a frame of eight blocks around one red block.",
         {"assets": {"red": 1, "c1": 8}, "hold": ["c1 c1 c1 | c1 red c1 | c1 c1 c1"],
          "miss": ["c1 c1 c1 | c1 c1 c1 | c1 c1 red"]}),
    ],
)  # fmt: skip
def test_grids_orders_and_patterns_told_short_are_read(text: str, meant: Meant) -> None:
    assert_means(text, meant)


@pytest.mark.parametrize(
    "text",
    [
        "Raise the red block.",  # from the table?
        "Generate the red block.",
        "Help the children build a tower of three red blocks.",
        "The red block and the blue block hold hands.",
        "My son wants his red tower moved.",
        "Consider a tower of three red blocks. The top block should be on the mat.",  # there already?
        "Consider the tower of three red blocks.",
        "Consider ten blocks; I want a square pyramid whose layers are 3x3, 2x2 and a single block.",
        "Our word is short.",
        "Spell my name which is short.",
        "My grandson's name is TOM, so please write TIM with the letter blocks.",
        "stack c a t so it reads dog from top to bottom",
        "Our equation is 2+5=8, so build it.",
        "In a row from right to left, the vowels A, E come before the consonants B, C.",
        "A striped wall of black and white.",  # which way do the stripes go?
        "A row from red on the left to purple on the right.",  # what is between them?
        "A grid of three rows and four columns in which each row is monochromatic, the far row being red.",
        "Build a tower with 2, 4 and 6 in which the biggest number is on top and the smallest is on top.",
        "A row of five blocks with the middle one purple and the one on each side yellow.",
        "The kids want the word ZOO, each letter on a yellow block.",  # shown on it, or on top of it?
        "A 4x4 grid, rows alternating.",  # of which colours?
        "Make a frame of ten blocks around one red block.",
        "i want three rows of three blocks all of them gray except the middle one which is orange",  # row or block?
    ],
)
def test_what_does_not_tell_one_figure_is_refused(text: str) -> None:
    assert BuiltinFrontEnd().read(text)[0] is None


def test_the_word_that_is_told_of_is_no_further_word() -> None:
    schema, _ = BuiltinFrontEnd().read("Spell CAT. The word is red.")
    assert schema is not None and {block.color for block in schema.blocks} == {"red"}
