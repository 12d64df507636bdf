"""Figures and their places, as they are told together with anything else: states that must hold, and near misses."""

from __future__ import annotations

from typing import Any

import pytest

from tests.language.compose.test_meanings import told
from tests.language.meaning import assert_means

CASES: dict[str, dict[str, Any]] = {
    "Build me a little staircase of gray blocks, one, two and three high from left to right, "
    "and put the red block on its lowest step.": {
        "assets": {"gray": 6, "red": 1},
        "hold": ["gray^red gray^gray gray^gray^gray"],
        "miss": ["gray gray^gray^red gray^gray^gray", "gray^gray^gray gray^gray gray^red"],
    },
    "Build a staircase of six red blocks and put a blue block on the highest step "
    "and a green one in front of the lowest step.": {
        "assets": {"red": 6, "blue": 1, "green": 1},
        "hold": ["red red^red red^red^red^blue | green . .", "red^red^red^blue red^red red | . . green"],
        "miss": ["red red^red red^red^red^blue | . . green", "red^blue red^red red^red^red | green . ."],
    },
    "Spell CAT in a row and put a red block directly behind whichever letter is in the middle.": {
        "assets": {"C": 1, "A": 1, "T": 1, "red": 1},
        "hold": [". red . | C A T"],
        "miss": ["red . . | C A T", "C A T | . red ."],
    },
    "The letters A to D stand in a row in alphabetical order; a white block is on the first and a black one on the "
    "last.": {
        "assets": {"A": 1, "B": 1, "C": 1, "D": 1, "white": 1, "black": 1},
        "hold": ["A^white B C D^black"],
        "miss": ["A^black B C D^white", "D^black C B A^white"],
    },
    "Build a wall two blocks high and three wide, its lower row blue and its upper row white, "
    "and put a red block on the middle of the upper row.": {
        "assets": {"blue": 3, "white": 3, "red": 1},
        "hold": ["blue^white blue^white^red blue^white"],
        "miss": ["blue^white^red blue^white blue^white", "white^blue white^blue^red white^blue"],
    },
    "3 black towers with 2 blocks each, lined up left to right, and an orange block goes on top of the middle one": {
        "assets": {"black": 6, "orange": 1},
        "hold": ["black^black black^black^orange black^black"],
        "miss": ["black^black^orange black^black black^black", "black^black black^orange^black black^black"],
    },
    "Build a row of five yellow blocks; counting from the left, the second and the fourth carry a purple block each "
    "and the rest carry nothing.": {
        "assets": {"yellow": 5, "purple": 2},
        "hold": ["yellow yellow^purple yellow yellow^purple yellow"],
        "miss": [
            "yellow^purple yellow yellow yellow^purple yellow",
            "yellow yellow^purple^purple yellow yellow yellow",
        ],
    },
    "In a 2x2 square the far blocks are green, the near ones are yellow, and on the far left one lies a red block.": {
        "assets": {"green": 2, "yellow": 2, "red": 1},
        "hold": ["green^red green | yellow yellow"],
        "miss": ["green green^red | yellow yellow", "yellow^red yellow | green green"],
    },
    "Put red blocks on the first and the last letter of the word HOME.": {
        "assets": {"H": 1, "O": 1, "M": 1, "E": 1, "red": 2},
        "hold": ["H^red O M E^red"],
        "miss": ["H^red O^red M E", "H O M E^red^red", "E^red M O H^red"],
    },
}


@pytest.mark.parametrize("text", CASES)
def test_figures(text: str) -> None:
    assert_means(text, CASES[text])


@pytest.mark.parametrize(
    ("text", "meaning"),
    [
        (
            "Build a row of six blocks alternating red and blue, and put a white block in front of it.",
            "in a row in alternating colors",
        ),
        (
            "Make a V of five white blocks, with a red block on its point.",
            "form a V from its first drawn place on in the order",
        ),
        ("Put a red block on every other block of a row of six white blocks.", "block 3 must be on white block 5."),
        (
            "Put a stack of two white blocks on each of the red, green and blue patches.",
            "White block 5 and white block 6 must be on the blue patch.",
        ),
        (
            "Build three orange towers, two, three and four blocks high, in any order, and put a green block on the "
            "highest one.",
            "on the tower of orange block 6, orange block 7, orange block 8 and orange block 9.",
        ),
        (
            "Leave the tower of two red blocks where it is and build a row of three blue blocks behind it.",
            "At the start, red block 1 and red block 2 must form a tower of exactly two",
        ),
        (
            "Put a red block on one of the corners of a 2x3 grid of white blocks.",
            "or the red block must be on white block 6",
        ),
        (
            "The red tower of two has a green block in front of it.",
            "in front of the tower of red block 1 and red block 2",
        ),
        ("Place a red block behind the plus sign of the equation 2+2=4.", "The red block must be behind the + block."),
    ],
)
def test_told_again(text: str, meaning: str) -> None:
    assert [meaning in said for said in told(text)] == [True]


@pytest.mark.parametrize(
    "text",
    [
        "Build a row of six blocks alternating red and blue, with a green block on the leftmost one.",  # red or blue
        "A red and a blue tower of two stand in a row; a white block is on the left one.",  # which one is at the left
        "An L made of white blocks, four long and three wide.",  # lengths that have no place
        "a tower of four blue blocks with the top one red",  # four, or three
        "build a square 3 wide and 4 deep",
        "5 blocks, V shape",  # of these, or of further ones
        "Build a U of seven green blocks with a red block on each end.",  # on top of it, or in line with it
        "Keep the row of A, B and C as it is and put a red block on its left block.",  # which one is at the left
        "Put the digits 1 to 5 in a row and a red block on the first one.",  # in which order
    ],
)
def test_not_told_again(text: str) -> None:
    assert told(text) == []
