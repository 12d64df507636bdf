"""All that is told of a row, a column or a tower shows in the task: its blocks, their order, their number, its ends."""

from __future__ import annotations

from typing import Any

import pytest

from rpg.passes.schema.frontend import BuiltinFrontEnd
from tests.language.meaning import assert_means


@pytest.mark.parametrize(
    "text",
    [
        # what is left out of all others
        "A row of five, all but the last one red",
        "A tower of four, all but the top one blue",
        "A row of five, all but the first two red",
        "A row of five blocks, all red but the last one",
        "a column of five cubes, all of them except the middle one red",
        # what a block is not
        "The odd digits 1, 3 and 4 in a row",
        "Stack the even numbers 2, 4, 5",
        "the vowels A, E and T in a row",
        "the consonants B, C and A in a tower",
        "The digits 1, 2 and A in a row",
        # who is in the line
        "Put two red blocks together and two blue blocks together in a tower",
        "Two reds side by side and two blues side by side in one row",
        "Put two green cubes between a red one and a blue one in a tower",
        "Every red block should be between two blue blocks in a row of five",
        "A row of red, white and blue, white to the right of it",
        "A row of two red and two blue with green between them",
        "A row of red and blue with two green between them",
        "A row of red blocks with a blue between each two",
        "Spell CAT and DOG in one row",
        "Two rows of three red blocks, all touching",
        # how many there are
        "Row of two red, three blue, six blocks in total",
        "Tower of two red and three blue, six blocks in all",
        "A row of four red blocks as long as a row of three blue blocks",
        "A row of 3, two red",
        "A row of red and blue, three red",
        "Blocks 1 and 3 red, 2 and 3 blue, in a row",
        # which end, and which way
        "The blocks are in a row: red, green, blue. Put the green one at the other end.",
        "put red at the left end of the row and blue in the third place",
        "put the red block in the middle of the row and the yellow block on one end",
        "the letters of HELP mirrored from right to left",
        "There is a tower of A, B and C. Put the blocks in the order C, A, B.",
        "The row must not be red, blue, green",
        # so many of them
        "A row of A, B, C, D with A and B together",
        "Spell CAT with one letter red",
        "Spell CAT, all letters red but one",
        "Stack three blocks. One of the blocks is red.",
        "a row of six cubes, alternating in size",
    ],
)
def test_a_line_that_is_told_otherwise_is_refused(text: str) -> None:
    schema, diagnostics = BuiltinFrontEnd().read(text)
    assert schema is None
    assert any(d.severity == "error" for d in diagnostics)


TOGETHER = {"assets": {"red": 3, "blue": 3}, "hold": ["red red red blue blue blue", "blue blue blue red red red"],
            "miss": ["red red blue blue blue red", "red red red ; blue blue blue"]}  # fmt: skip
AT_ENDS = {"assets": {"green": 3, "red": 1, "blue": 1},
           "hold": ["red green green green blue", "blue green green green red"],
           "miss": ["green red green green blue", "red blue green green green"]}  # fmt: skip
ABC_TURNED = {"assets": {"A": 1, "B": 1, "C": 1}, "start": ["A B C"], "hold": ["B C A"], "miss": ["A B C", "B A C"]}
MIDDLE = {"assets": {"red": 3, "yellow": 2}, "hold": ["yellow red red red yellow"],
          "miss": ["red red red yellow yellow", "red yellow red yellow red"]}  # fmt: skip
SIZES = {"assets": {"red{small}": 2, "red{big}": 2}, "hold": ["red{small} red{big} red{small} red{big} pitch=1.5"],
         "miss": ["red{small} red{small} red{big} red{big} pitch=1.5"]}  # fmt: skip
ENDS = {"assets": {"yellow": 2, "green": 2, "white": 1}, "hold": ["yellow yellow white green green"],
        "miss": ["white yellow yellow green green", "green green white yellow yellow"]}  # fmt: skip


@pytest.mark.parametrize(
    ("text", "meant"),
    [
        # what is in the line, and where
        ("Put two green cubes between a red one and a blue one, all in one row",
         {"assets": {"green": 2, "red": 1, "blue": 1}, "hold": ["red green green blue", "blue green green red"],
          "miss": ["green red green blue", "red ; green green ; blue"]}),
        ("Put the odd digits on the left and the even digits on the right, in one row, digits 1 to 4",
         {"assets": {"1": 1, "2": 1, "3": 1, "4": 1}, "hold": ["1 3 2 4", "3 1 4 2"], "miss": ["1 2 3 4", "2 4 1 3"]}),
        ("Put three red cubes on the left and three blue cubes on the right in one row",
         {"assets": {"red": 3, "blue": 3}, "hold": ["red red red blue blue blue"],
          "miss": ["blue blue blue red red red", "red blue red blue red blue"]}),
        ("put the three red blocks in the middle of the row and one yellow block on each end", MIDDLE),
        ("put one yellow block at each end of the row and the three red blocks in the middle", MIDDLE),
        ("put the two red blocks in the middle of the row and two yellow blocks on each end",
         {"assets": {"red": 2, "yellow": 4}, "hold": ["yellow yellow red red yellow yellow"],
          "miss": ["yellow red red yellow yellow yellow"]}),
        ("row with 2 yellow left side, 2 green right side, 1 white center", ENDS),
        ("row with white center, 2 yellow left and 2 green right", ENDS),
        ("A is at the left end of the row and B at the other end, C is in the middle.",
         {"assets": {"A": 1, "B": 1, "C": 1}, "hold": ["A C B"], "miss": ["A B C", "B C A"]}),
        ("Put the red cubes together and the blue cubes together in one row, 3 red 3 blue", TOGETHER),
        ("Put the reds together and the blues together in a row, 3 of each", TOGETHER),
        ("3 red and 3 blue cubes in one row, the reds together and the blues together", TOGETHER),
        ("A row of three green blocks with a red one at one end and a blue one at the other", AT_ENDS),
        ("put a red block at one end of a row of three green blocks and a blue one at the other", AT_ENDS),
        ("A row of three green blocks with a red block at one end",
         {"assets": {"green": 3, "red": 1}, "hold": ["red green green green", "green green green red"],
          "miss": ["green red green green"]}),
        ("Blocks 1 and 2 red, 3 and 4 blue, in a row",
         {"assets": {"red:1": 1, "red:2": 1, "blue:3": 1, "blue:4": 1}, "hold": ["red:1 red:2 blue:3 blue:4"],
          "miss": ["red:1 red:2 ; blue:3 blue:4"]}),
        ("cubes A, B red and C, D green in a tower",
         {"assets": {"red:A": 1, "red:B": 1, "green:C": 1, "green:D": 1}, "hold": ["red:A^red:B^green:C^green:D"],
          "miss": ["red:A^red:B ; green:C^green:D"]}),
        ("A row of red and blue with green between them",
         {"assets": {"red": 1, "blue": 1, "green": 1}, "hold": ["red green blue", "blue green red"],
          "miss": ["green red blue"]}),
        ("A row of five: all blocks are red except the last two, which are blue",
         {"assets": {"red": 3, "blue": 2}, "hold": ["red red red blue blue"], "miss": ["blue blue red red red"]}),
        ("A, B and C in one row, D behind B",
         {"assets": {"A": 1, "B": 1, "C": 1, "D": 1}, "hold": [". D . | A B C"], "miss": ["A B C D"]}),
        # in which order
        ("five blocks in a row and they should go red, orange, yellow, green, blue",
         {"assets": {"red": 1, "orange": 1, "yellow": 1, "green": 1, "blue": 1},
          "hold": ["red orange yellow green blue"], "miss": ["orange red yellow green blue"]}),
        ("five blocks in a row and the colours are red, red, blue, red, red",
         {"assets": {"red": 4, "blue": 1}, "hold": ["red red blue red red"], "miss": ["red blue red red red"]}),
        ("three blocks in a row, they are red, white and green",
         {"assets": {"red": 1, "white": 1, "green": 1}, "hold": ["red white green", "white green red"],
          "miss": ["red ; white ; green"]}),
        ("4 blocks, 2 colours, alternating, in a row: white/black/white/black",
         {"assets": {"white": 2, "black": 2}, "hold": ["white black white black"],
          "miss": ["black white black white", "white white black black"]}),
        ("Three blocks in a row, one of them red, the others blue",
         {"assets": {"red": 1, "blue": 2}, "hold": ["red blue blue", "blue red blue"], "miss": ["red ; blue ; blue"]}),
        # the other end
        ("The blocks are in a row: A, B, C. Put A at the other end.", ABC_TURNED),
        ("There is a row of A, B and C. Move A to its other end.", ABC_TURNED),
        ("The blocks are in a tower: A, B, C. Put A at the opposite end.",
         {"assets": {"A": 1, "B": 1, "C": 1}, "start": ["A^B^C"], "hold": ["B^C^A"], "miss": ["A^B^C", "C^B^A"]}),
        ("There is a tower of A, B and C. Put it in the order C, A, B.",
         {"assets": {"A": 1, "B": 1, "C": 1}, "hold": ["C^A^B"], "miss": ["C A B", "B^A^C"]}),
        # how large
        ("row of 2 small and 2 large cubes, alternating", SIZES),
        ("a row of 2 small and 2 large cubes whose sizes alternate", SIZES),
        ("a row alternating small and large cubes, two of each", SIZES),
        # how many
        ("A row of red blocks as long as a row of three blue blocks",
         {"assets": {"red": 3, "blue": 3}, "hold": ["red red red ; blue blue blue"], "miss": ["red red ; blue blue"]}),
        ("A tower of red blocks exactly as high as the tower of 2 blue blocks",
         {"assets": {"red": 2, "blue": 2}, "hold": ["red^red ; blue^blue"], "miss": ["red ; red ; blue^blue"]}),
    ],
)  # fmt: skip
def test_a_line_is_read_as_it_is_told(text: str, meant: dict[str, Any]) -> None:
    assert_means(text, meant)


NOON = {"assets": {"N": 2, "O": 1, "blue:O": 1}, "hold": ["N O blue:O N", "N blue:O O N"], "miss": ["O N blue:O N"]}
EITHER = {"assets": {"red": 1, "blue": 1, "green": 1, "patch": 1},
          "hold": ["red at=patch ; blue ; green", "red ; blue at=patch ; green"],
          "miss": ["red ; blue ; green at=patch", "red ; blue ; green"]}  # fmt: skip


@pytest.mark.parametrize(
    ("text", "meant"),
    [
        # some of the letters of a word
        ("Spell NOON. One O is blue.", NOON),
        ("Spell NOON with one blue O", NOON),
        ("Spell NOON, one O blue", NOON),
        ("Spell NOON. One of the Os is blue.", NOON),
        ("Spell NOON with both Ns red but one O blue",
         {"assets": {"red:N": 2, "O": 1, "blue:O": 1}, "hold": ["red:N O blue:O red:N"],
          "miss": ["O red:N red:N blue:O"]}),
        ("Spell BANANA with 2 green As",
         {"assets": {"B": 1, "A": 1, "green:A": 2, "N": 2}, "hold": ["B A N green:A N green:A"],
          "miss": ["B A N N green:A green:A"]}),
        # either of two
        ("The red block or the blue block, but not the green block, must be on the mat", EITHER),
        ("Put red or blue, but not green, on the mat", EITHER),
        ("Put the red one on the blue one or else on the mat",
         {"assets": {"red": 1, "blue": 1, "patch": 1}, "hold": ["blue^red", "red at=patch ; blue"],
          "miss": ["red ; blue", "blue at=patch ; red"]}),
        ("A red tower of two stands behind or in front of a row of three green blocks",
         {"assets": {"red": 2, "green": 3}, "hold": [". red^red . | . . . | green green green",
                                                    "green green green | . . . | . red^red ."],
          "miss": ["red^red . . green green green"]}),
        ("A red tower of two stands behind a row of three green blocks or it is in front of it",
         {"assets": {"red": 2, "green": 3}, "hold": [". red^red . | . . . | green green green",
                                                    "green green green | . . . | . red^red ."],
          "miss": ["red^red . . green green green"]}),
        ("Put the red block left of and behind a tower of two blue blocks",
         {"assets": {"red": 1, "blue": 2}, "hold": ["red . . | . . . | . . blue^blue"], "miss": ["red . blue^blue"]}),
    ],
)  # fmt: skip
def test_either_and_some_are_read_as_they_are_told(text: str, meant: dict[str, Any]) -> None:
    assert_means(text, meant)
