"""Structures told with their parts: what is above or beside a part, some of several, lots in rows, groups alike."""

from __future__ import annotations

from typing import Any

import pytest

from rpg.passes.schema.frontend import BuiltinFrontEnd
from tests.language.meaning import assert_means

TOWER = {
    "assets": {"yellow": 1, "black": 3},
    "hold": ["black^black^black^yellow"],
    "miss": ["yellow^black^black^black", "black^black^yellow^black", "black^black^yellow"],
}
ROW = {
    "assets": {"red": 1, "blue": 3},
    "hold": ["red blue blue blue"],
    "miss": ["blue blue blue red", "blue red blue blue"],
}
AROUND = {
    "assets": {"yellow": 1, "white": 2, "black": 2},
    "hold": ["white white yellow black black"],
    "miss": ["black black yellow white white", "white black yellow white black"],
}


@pytest.mark.parametrize(
    ("text", "meant"),
    [
        ("A tower of four: the top one yellow, the three below it all black.", TOWER),
        ("There is a tower of four blocks; its top is yellow while the three under it are all black.", TOWER),
        ("Build a tower of four. The top block is yellow and the blocks below it are black.", TOWER),
        ("A tower of four blocks with a yellow top; the three beneath it are black.", TOWER),
        ("In a tower of four the top block is yellow and all those underneath are black.", TOWER),
        ("A row of four blocks: the left one red, the three to its right blue.", ROW),
        ("A row of four blocks. The leftmost is red and the three to the right of it are blue.", ROW),
        ("A row of five, the middle one yellow, the two to its left white and the two to its right black.", AROUND),
        (
            "A tower of five: the middle one red, the two above it blue and the two below it green.",
            {
                "assets": {"red": 1, "blue": 2, "green": 2},
                "hold": ["green^green^red^blue^blue"],
                "miss": ["blue^blue^red^green^green", "green^blue^red^blue^green"],
            },
        ),
        (
            "Three blocks in a line: the nearest is red and the two behind it are white.",
            {"assets": {"red": 1, "white": 2}, "hold": ["white | white | red"], "miss": ["red | white | white"]},
        ),
        (
            "We end with six blocks forming a two-by-three rectangle, the front row yellow and the back row purple.",
            {
                "assets": {"yellow": 3, "purple": 3},
                "hold": ["purple purple purple | yellow yellow yellow"],
                "miss": [
                    "yellow yellow yellow | purple purple purple",
                    "purple yellow | purple yellow | purple yellow",
                ],
            },
        ),
    ],
)
def test_the_rest_is_told_by_where_it_is(text: str, meant: dict[str, Any]) -> None:
    assert_means(text, meant)


OUTER = {
    "assets": {"red": 6, "yellow": 3},
    "hold": ["red yellow red | red yellow red | red yellow red pitch=2,1.25"],
    "miss": [
        "yellow red red | yellow red red | yellow red red pitch=2,1.25",
        "red red red | yellow yellow yellow | red red red pitch=1.25,2",
    ],
}
LINED = {
    "assets": {"red": 4, "white": 4, "blue": 4},
    "hold": ["red red red red | white white white white | blue blue blue blue pitch=1.25,2"],
    "miss": ["white white white white | red red red red | blue blue blue blue pitch=1.25,2"],
}


@pytest.mark.parametrize(
    ("text", "meant"),
    [
        ("Set up 3 columns with 3 blocks each; the outer columns red, the centre column yellow.", OUTER),
        ("Three columns of three blocks: the middle column is yellow and the other two columns are red.", OUTER),
        ("Twelve blocks in three rows; the rows, from the back to the front, are red, white and blue.", LINED),
        ("Three rows of four blocks. From front to back the rows are blue, white and red.", LINED),
        ("Twelve blocks in three rows, the back row red, the middle row white and the front row blue.", LINED),
        (
            "Three towers of two blocks in a row: the left one red, the other two blue.",
            {
                "assets": {"red": 2, "blue": 4},
                "hold": ["red^red blue^blue blue^blue"],
                "miss": ["blue^blue red^red blue^blue", "red^blue red^blue blue^blue"],
            },
        ),
        (
            "Three towers of two blocks each, the outer ones red and the middle one blue.",
            {
                "assets": {"red": 4, "blue": 2},
                "hold": ["red^red blue^blue red^red"],
                "miss": ["blue^blue red^red red^red", "red^blue red^red red^blue"],
            },
        ),
        (
            "Two towers of three blocks each. From left to right the towers are red and white.",
            {"assets": {"red": 3, "white": 3}, "hold": ["red^red^red white^white^white"],
             "miss": ["white^white^white red^red^red"]},
        ),
        (
            "A grid of 2 rows and 3 columns. Each column has one colour, namely red, white, blue from left to right.",
            {"assets": {"red": 2, "white": 2, "blue": 2}, "hold": ["red white blue | red white blue"],
             "miss": ["blue white red | blue white red"]},
        ),
    ],
)  # fmt: skip
def test_some_of_several_structures_are_told_together(text: str, meant: dict[str, Any]) -> None:
    assert_means(text, meant)


ODD_BEHIND = {
    "assets": {str(n): 1 for n in range(1, 7)},
    "hold": ["1 3 5 | 2 4 6", "5 1 3 | 4 2 6"],
    "miss": ["2 4 6 | 1 3 5", "1 2 3 | 4 5 6"],
}
ALIKE = {
    "assets": {"white": 4, "black": 2},
    "hold": ["white black white ; black white white"],
    "miss": ["white white white ; black black white", "white white ; white white ; black black"],
}


@pytest.mark.parametrize(
    ("text", "meant"),
    [
        ("put the blocks 1 to 6 in two rows, the odd ones behind the even ones", ODD_BEHIND),
        ("Put the numbers 1 to 6 into two rows with the even numbers in front of the odd numbers.", ODD_BEHIND),
        ("Arrange the digits 1 to 6 in two rows of three. The odd digits are behind the even digits.", ODD_BEHIND),
        (
            "Put three red and three blue blocks into two stacks, the blue ones to the right of the red ones.",
            {"assets": {"red": 3, "blue": 3}, "hold": ["red^red^red blue^blue^blue"],
             "miss": ["blue^blue^blue red^red^red", "red^blue^red blue^red^blue"]},
        ),
        ("Make two groups of three blocks, each with two white ones and one black one.", ALIKE),
        ("Make two clusters of three blocks. In each cluster two are white and one is black.", ALIKE),
        ("Make two piles of three blocks. Each consists of two white ones and a black one.", ALIKE),
        ("Sort six cubes into two groups of three; each group has two white cubes and one black cube.", ALIKE),
    ],
)  # fmt: skip
def test_lots_and_groups_are_told_by_what_they_have(text: str, meant: dict[str, Any]) -> None:
    assert_means(text, meant)


CORNERS = "{0} at=3.2,5.5 ; {0} at=3.2,-5.5 ; {0} at=-3.2,5.5 ; {0} at=-3.2,-5.5"


@pytest.mark.parametrize(
    ("text", "meant"),
    [
        (
            "Build a tower of two blue blocks in each corner of the table.",
            {"assets": {"blue": 8}, "hold": [CORNERS.format("blue^blue")], "miss": [CORNERS.format("blue blue")]},
        ),
        (
            "In every corner of the table stands a tower of a red and a blue block.",
            {"assets": {"red": 4, "blue": 4}, "hold": [CORNERS.format("red^blue"), CORNERS.format("blue^red")],
             "miss": ["red^red at=3.2,5.5 ; blue^blue at=3.2,-5.5 ; red^blue at=-3.2,5.5 ; red^blue at=-3.2,-5.5"]},
        ),
        (
            "Put a tower of two red blocks in both far corners.",
            {"assets": {"red": 4}, "hold": ["red^red at=3.2,5.5 ; red^red at=3.2,-5.5"],
             "miss": ["red^red at=3.2,5.5 ; red^red at=-3.2,-5.5"]},
        ),
        (
            "Boxes A through F should be put in two rows of three, alphabetical, back row first.",
            {"assets": dict.fromkeys("ABCDEF", 1), "hold": ["A B C | D E F"], "miss": ["D E F | A B C"]},
        ),
        (
            "Letters A to F go into two rows of three, alphabetically, the front row first.",
            {"assets": dict.fromkeys("ABCDEF", 1), "hold": ["D E F | A B C"], "miss": ["A B C | D E F"]},
        ),
        (
            "Two rows of three red blocks each with a gap of at least 10 cm between the two rows.",
            {"assets": {"red": 6}, "hold": ["red red red | red red red pitch=1.25,4"],
             "miss": ["red red red | red red red pitch=1.25,2"]},
        ),
        (
            "Two towers of 2 and 3 green blocks in a row from left to right.",
            {"assets": {"green": 5}, "hold": ["green^green green^green^green"],
             "miss": ["green^green^green green^green"]},
        ),
    ],
)  # fmt: skip
def test_several_structures_have_their_places(text: str, meant: dict[str, Any]) -> None:
    assert_means(text, meant)


BUT_MIDDLE = {
    "assets": {"red": 4, "blue": 1},
    "hold": ["red red blue red red"],
    "miss": ["blue red red red red", "red red red red ; blue"],
}
NOT_BELOW = {
    "assets": {"red": 3, "blue": 2},
    "hold": ["blue^red^red^red^blue", "blue^blue^red^red^red"],
    "miss": ["red^blue^blue^red^red", "red^red^red ; blue^blue"],
}
NEAREST = {"assets": {"red": 1, "gray": 2}, "hold": ["gray | gray | red"], "miss": ["red | gray | gray"]}


@pytest.mark.parametrize(
    ("text", "meant"),
    [
        ("A row of five red blocks, but the middle one is blue.", BUT_MIDDLE),
        ("A row of five red blocks, only the middle one is blue.", BUT_MIDDLE),
        ("A row of five red blocks. The middle one is blue instead.", BUT_MIDDLE),
        ("A row of five red blocks, except that the middle one is blue.", BUT_MIDDLE),
        (
            "A stack of six green cubes, but the two at the bottom are white.",
            {"assets": {"green": 4, "white": 2}, "hold": ["white^white^green^green^green^green"],
             "miss": ["green^green^green^green^white^white"]},
        ),
        (
            "Make a filled 3x3 square of blue blocks. The one in the middle is yellow instead.",
            {"assets": {"blue": 8, "yellow": 1}, "hold": ["blue blue blue | blue yellow blue | blue blue blue"],
             "miss": ["yellow blue blue | blue blue blue | blue blue blue"]},
        ),
        ("Stack three red and two blue blocks in one tower without a red one at the bottom.", NOT_BELOW),
        ("Stack three red and two blue blocks in one tower, but no red one at the bottom.", NOT_BELOW),
        ("Stack three red and two blue blocks in one tower, the bottom one not red.", NOT_BELOW),
        ("Stack three red and two blue blocks in one tower. There must be no red block at the bottom.", NOT_BELOW),
        (
            "A row of two red and three blue blocks with no red one at an end.",
            {"assets": {"red": 2, "blue": 3}, "hold": ["blue red red blue blue"], "miss": ["blue red blue blue red"]},
        ),
        ("Three blocks one behind the other. The front one is red, the other two are gray.", NEAREST),
        ("Three blocks stand one behind the other; the nearest is red and the others are gray.", NEAREST),
        (
            "Three blocks side by side. The left one is red, the other two are gray.",
            {"assets": {"red": 1, "gray": 2}, "hold": ["red gray gray"], "miss": ["gray red gray"]},
        ),
        (
            "A tower of three green and two brown blocks, no brown one directly on another brown one.",
            {"assets": {"green": 3, "brown": 2}, "hold": ["green^brown^green^brown^green"],
             "miss": ["green^brown^brown^green^green"]},
        ),
    ],
)  # fmt: skip
def test_parts_that_differ_from_what_is_said_of_all(text: str, meant: dict[str, Any]) -> None:
    assert_means(text, meant)


ORANGE = "orange orange orange | orange orange orange | orange orange orange"
UPWARDS = {"assets": {"green": 1, "white": 1, "brown": 1}, "hold": ["green^white^brown"],
           "miss": ["brown^white^green", "green^brown^white"]}  # fmt: skip
TOPPED = {
    "assets": {"red": 2, "white": 4},
    "hold": ["white^white^red ; white^white^red"],
    "miss": ["red^white^white ; red^white^white", "white^white^white ; white^red^red"],
}


@pytest.mark.parametrize(
    ("text", "meant"),
    [
        ("A tower of three: the bottom one is green, the one above it is white and the top one is brown.", UPWARDS),
        ("Build a tower of three. The bottom block is green, the one above it is white, and the top one is brown.",
         UPWARDS),
        (
            "Three cubes one behind the other: the nearest is green, the one behind it white, and the farthest brown.",
            {"assets": {"green": 1, "white": 1, "brown": 1}, "hold": ["brown | white | green"],
             "miss": ["green | white | brown"]},
        ),
        (
            "A row of four: the left one is red, the one next to it white, the others blue.",
            {"assets": {"red": 1, "white": 1, "blue": 2}, "hold": ["red white blue blue"],
             "miss": ["red blue white blue", "blue blue white red"]},
        ),
        ("Two towers of three blocks; in each the top one is red and the two below it are white.", TOPPED),
        ("Two towers of three blocks each. In each tower the top block is red and the other two are white.", TOPPED),
        (
            "Make a row out of A, B, C and E with a vowel at each end.",
            {"assets": dict.fromkeys("ABCE", 1), "hold": ["A C B E", "E B C A"], "miss": ["A E B C", "B A E C"]},
        ),
        (
            "Line up A, B, C, D and E with the vowels at the ends.",
            {"assets": dict.fromkeys("ABCDE", 1), "hold": ["A D C B E"], "miss": ["A E B C D"]},
        ),
        (
            "A row of A, B, C, D and E: the consonants in the middle, the vowels at the ends.",
            {"assets": dict.fromkeys("ABCDE", 1), "hold": ["A D C B E", "E B C D A"], "miss": ["A E B C D"]},
        ),
        (
            "A plus sign made of five white cubes, the one in the centre being black.",
            {"assets": {"white": 4, "black": 1}, "hold": [". white . | white black white | . white ."],
             "miss": [". black . | white white white | . white ."]},
        ),
        (
            "A tower of five white blocks; only the top one is red and the bottom one blue.",
            {"assets": {"white": 3, "red": 1, "blue": 1}, "hold": ["blue^white^white^white^red"],
             "miss": ["red^white^white^white^blue"]},
        ),
        (
            "Three rows of two blocks; from the back to the front they are red, white and blue.",
            {"assets": {"red": 2, "white": 2, "blue": 2}, "hold": ["red red | white white | blue blue pitch=1.25,2"],
             "miss": ["blue blue | white white | red red pitch=1.25,2"]},
        ),
        (
            "Build a tower of two red blocks and a tower of three blue ones, with a green block on the shorter one.",
            {"assets": {"red": 2, "blue": 3, "green": 1}, "hold": ["red^red^green ; blue^blue^blue"],
             "miss": ["red^red ; blue^blue^blue^green"]},
        ),
        (
            "A 3x3 grid of orange cubes, 7 cm from centre to centre.",
            {"assets": {"orange": 9}, "hold": [f"{ORANGE} pitch=1.75"], "miss": [f"{ORANGE} pitch=1.25"]},
        ),
        (
            "An equilateral triangle whose sides consist of three green blocks each, corners shared, interior empty.",
            {"assets": {"green": 6}},
        ),
    ],
)  # fmt: skip
def test_parts_are_told_one_after_the_other(text: str, meant: dict[str, Any]) -> None:
    assert_means(text, meant)


@pytest.mark.parametrize(
    "text",
    [
        "A row of four blocks: the left one red, the three to its left blue.",
        "A row of four blocks: the left one red, the three behind it blue.",
        "A tower of five: the middle one red, the two above it blue.",
        "A tower of five: the middle one red, the three above it blue.",
        "A tower of four: the top one red, the three above it blue.",
        "Three towers of two blocks: the middle one red, the first blue, the last green.",
        "Four rows of two blocks, the middle row red, the others blue.",
        "Four rows of three blocks. From back to front the rows are red, white and blue.",
        "Eleven blocks in two rows, the front one red and the back one blue.",
        "Put the numbers 1 to 8 into two rows of three, the odd numbers in front of the even numbers.",
        "Put three red, three blue and three green blocks in two rows, the red ones behind the blue ones.",
        "Make two groups of five, each with two white ones and one black one.",
        "Make two groups of four cubes. In each group three are red.",
        "Divide five red and two blue blocks into two groups, each with two red ones and one blue one.",
        "A row of five red blocks. The middle one is blue.",
        "Build a tower of a red, a green and a blue block. The top one is green instead.",
        "Stack red on blue. The top one is green instead.",
        "A tower of two red and three blue blocks, but no green one at the bottom.",
        "Put a tower of the two red blocks in each corner of the table.",
        "Two rows of three red blocks with a gap of 5 cm between them.",
        "Put the blocks 1 to 6 in two columns of three in ascending order.",
        "A row of A, B, C, D and E with a vowel at the left end.",
        "A row of the digits 1 to 5 with an odd digit at each end.",
        "A tower of three cubes: the top one is green, the one above it is white and the bottom one is brown.",
        "Two towers of three blocks; in each the top one is red and the two above it are white.",
        "Four towers, each two high, stand in a row; the two in the middle are white, the two at the ends are black.",
        "Line up A, B, C and E with a vowel on the far left and on the far right.",
    ],
)
def test_parts_that_are_not_there_are_refused(text: str) -> None:
    schema, _ = BuiltinFrontEnd().read(text)
    assert schema is None
