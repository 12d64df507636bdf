"""How people put it who ask aloud, and what is told over several sentences."""

from __future__ import annotations

from typing import Any

import pytest

from tests.corpus.entries import entry
from tests.corpus.run import read
from tests.language.meaning import assert_means

_PARITY = {
    "assets": {**dict.fromkeys("123456789", 1), "red_patch": 1, "green_patch": 1},
    "hold": ["at=red_patch 1^3^5^7^9 ; at=green_patch 2^4^6^8"],
    "miss": ["at=red_patch 1^3^5^7 ; at=green_patch 2^4^6^8", "at=red_patch 1^3^5^7^9^2 ; at=green_patch 4^6^8"],
}
_CORNERS = {
    "assets": {"purple": 1, "orange": 1},
    "hold": ["at=9,13 purple ; at=-9,-13 orange"],
    "miss": ["at=9,-13 purple ; at=-9,13 orange"],
}
_ROWS = {
    "assets": {"c1": 3, "c2": 3},
    "hold": ["c1 c1 c1 | c2 c2 c2", "c1 c1 c1 ; c2 c2 c2"],
    "miss": ["c1 c2 c1 | c2 c1 c2"],
}
MEANT: list[tuple[str, dict[str, Any]]] = [
    ("The odd numbers from 1 to 9 go on the red mat and the even ones go on the green mat.", _PARITY),
    ("The odd digits 1 to 9 are on the red mat, the even digits on the green mat.", _PARITY),
    ("Put the even digits 2 to 6 in a row", {"assets": {"2": 1, "4": 1, "6": 1}, "hold": ["2 4 6"], "miss": ["2 4"]}),
    ("purple in the corner behind at the left and orange in the opposite corner", _CORNERS),
    ("Build two rows of three blocks, each row in a different color.", _ROWS),
    ("Place six blocks in two rows of three. Use one color for the front row and another for the back row.", _ROWS),
    ("She stacks red on blue.", {"assets": {"red": 1, "blue": 1}, "hold": ["blue^red"], "miss": ["red^blue"]}),
    ("red on blue no wait blue on red", {"assets": {"red": 1, "blue": 1}, "hold": ["red^blue"], "miss": ["blue^red"]}),
    ("How do I stack red on blue?", {"assets": {"red": 1, "blue": 1}, "hold": ["blue^red"], "miss": ["red^blue"]}),
    (
        "Is the A between the B and the C? If not, please put it there.",
        {"assets": {"A": 1, "B": 1, "C": 1}, "hold": ["B A C"], "miss": ["A B C"]},
    ),
    (
        "One: red block on blue block. Two: yellow block on red block. In that order.",
        {
            "assets": {"red": 1, "blue": 1, "yellow": 1},
            "hold": [["red ; blue ; yellow", "blue^red ; yellow", "blue^red^yellow"]],
            "miss": [["red ; blue ; yellow", "blue^red ; yellow"]],
        },
    ),
    (
        "block A, and only block A, rests on the yellow target. Blocks B and C are distractors.",
        {
            "assets": {"A": 1, "B": 1, "C": 1, "yellow_patch": 1},
            "hold": ["at=yellow_patch A"],
            "miss": ["at=yellow_patch A^B", "B ; A"],
        },
    ),
    (
        "There are A, B and C. Put A on the mat. B and C are distractors.",
        {"assets": {"A": 1, "B": 1, "C": 1, "patch": 1}, "hold": ["at=patch A"], "miss": ["A"]},
    ),
    (
        "Three brown boxes sit on the gray zone. They have to go somewhere else.",
        {
            "assets": {"brown": 3, "gray_patch": 1},
            "start": ["at=gray_patch brown^brown^brown"],
            "hold": [["at=gray_patch brown^brown^brown", "brown ; brown ; brown"]],
            "miss": [["at=gray_patch brown^brown^brown", "at=gray_patch brown ; brown ; brown"]],
        },
    ),
    (
        "Place 1, 2 and 3 in a row, neither in increasing nor in decreasing order from left to right.",
        {"assets": {"1": 1, "2": 1, "3": 1}, "hold": ["1 3 2", "2 1 3"], "miss": ["1 2 3", "3 2 1"]},
    ),
    (
        "Not both of the green cubes may lie on the patch, yet at least one of them must.",
        {"assets": {"green": 2, "patch": 1}, "hold": ["at=patch green"], "miss": ["at=patch green^green", "green"]},
    ),
    (
        "Let's make a rainbow! Red, orange, yellow and green in a row, starting with red on the left.",
        {
            "assets": {"red": 1, "orange": 1, "yellow": 1, "green": 1},
            "hold": ["red orange yellow green"],
            "miss": ["red yellow orange green", "green yellow orange red"],
        },
    ),
    (
        "Let's make a rainbow! One red, one orange, one yellow and one green block in a row from left to right, in "
        "that order.",
        {
            "assets": {"red": 1, "orange": 1, "yellow": 1, "green": 1},
            "hold": ["red orange yellow green"],
            "miss": ["red yellow orange green", "green yellow orange red"],
        },
    ),
    (
        "write CAT, and DOG on the line below",
        {
            "assets": {**dict.fromkeys("CATDOG", 1)},
            "hold": ["C A T | D O G"],
            "miss": ["D O G | C A T", "C A T"],
        },
    ),
    (
        "Make two clusters, one of red cubes and one of blue cubes. Four cubes of each color.",
        {
            "assets": {"red": 4, "blue": 4},
            "hold": ["pitch=1.1 red* | . ; pitch=1.1 blue*"],
            "miss": ["pitch=1.1 red red blue red | blue blue red blue"],
        },
    ),
    (
        "the gap between the black cube and the white cube should be 2 cm, everything else is free.",
        {"assets": {"black": 1, "white": 1}, "hold": ["pitch=1.5 black white"], "miss": ["pitch=1 black white"]},
    ),
    (
        "Red is right of white. The gap is 2 cm.",
        {"assets": {"red": 1, "white": 1}, "hold": ["pitch=1.5 white red"], "miss": ["pitch=1.5 red white"]},
    ),
    (
        "sort the blocks by letter: two A and two B",
        {
            "assets": {"A": 2, "B": 2},
            "hold": ["pitch=1.1 A A ; pitch=1.1 B B"],
            "miss": ["pitch=1.1 A B ; pitch=1.1 A B"],
        },
    ),
    (
        "A stack of three black blocks stands on A at the start. Put A on the mat.",
        {
            "assets": {"A": 1, "black": 3, "patch": 1},
            "start": ["A^black^black^black"],
            "start_miss": ["black^black^black ; A"],
            "hold": ["at=patch A"],
            "miss": ["A"],
        },
    ),
    (
        "The number of blocks on the red patch must be larger than the number of blocks on the blue patch. There are "
        "three blocks.",
        {
            "assets": {"plain": 3, "red_patch": 1, "blue_patch": 1},
            "hold": ["at=red_patch plain", "at=red_patch plain^plain ; at=blue_patch plain"],
            "miss": ["at=red_patch plain ; at=blue_patch plain", "at=blue_patch plain"],
        },
    ),
]


@pytest.mark.parametrize(("text", "meant"), MEANT)
def test_it_is_read_as_it_is_meant(text: str, meant: dict[str, Any]) -> None:
    assert_means(text, meant)


@pytest.mark.parametrize(
    "text",
    [
        "Place seven blocks in two rows of three, each row in a different color.",
        "Make two groups, one of three red blocks and one of two blue blocks, four of each.",
        "In a row I want first the even digits 2 and 4 in increasing order and then the odd digits 1 and 3.",
        "The odd digits 1, 3 and 4 in a row",
        "Scatter four red blocks. Put a blue one on a green one.",
        "Put the primes 2, 3 and 4 in a row.",
    ],
)
def test_what_does_not_fit_is_refused(text: str) -> None:
    assert read(entry("asked", "aloud", text, {"refuse": True}))[0] is None
