"""Several structures told at once: what is so of each of them, or of one alone, states that must hold, near misses."""

from __future__ import annotations

from typing import Any

import pytest

from tests.language.meaning import assert_means, code_of

CASES: dict[str, dict[str, Any]] = {
    "Line up three towers of two white blocks each, and only the left one gets a red block on its top.": {
        "assets": {"white": 6, "red": 1},
        "hold": ["white^white^red white^white white^white"],
        "miss": ["white^white white^white white^white^red", "white^white red white^white white^white"],
    },
    "Two gray towers of two; directly in front of each one is a pink block.": {
        "assets": {"gray": 4, "pink": 2},
        "hold": ["gray^gray . gray^gray | pink . pink"],
        "miss": [
            "gray^gray . gray^gray | pink . .",
            "gray^gray gray^gray | . pink",
            "gray^gray . gray^gray | . . pink",
        ],
    },
    "Put up two towers of two gray blocks, and immediately to the right of each tower is a pink block.": {
        "assets": {"gray": 4, "pink": 2},
        "hold": ["gray^gray pink . gray^gray pink"],
        "miss": ["pink gray^gray . pink gray^gray", "gray^gray . gray^gray pink"],
    },
    "Line up four green blocks from left to right, and behind each of the two outer ones put a red block.": {
        "assets": {"green": 4, "red": 2},
        "hold": ["red . . red | green green green green"],
        "miss": [". red red . | green green green green", "green green green green | red . . red"],
    },
    "There are two brown towers, each three high. Put a white block on exactly one of them and leave the other one "
    "free.": {
        "assets": {"brown": 6, "white": 1},
        "hold": ["brown^brown^brown^white . brown^brown^brown", "brown^brown^brown . brown^brown^brown^white"],
        "miss": ["brown^brown^white^brown . brown^brown^brown", "brown^brown^brown white brown^brown^brown"],
    },
    "There are two black towers of two. Put a cyan block on each.": {
        "assets": {"black": 4, "cyan": 2},
        "hold": ["black^black^cyan . black^black^cyan"],
        "miss": ["black^black^cyan^cyan . black^black", "black^cyan^black . black^black^cyan"],
    },
    "Build a plus sign out of five red blocks; on its center lies a green block.": {
        "assets": {"red": 5, "green": 1},
        "hold": [". red . | red red^green red | . red ."],
        "miss": [". red^green . | red red red | . red ."],
    },
    "K, L and M form one row and P, Q and R another one just behind it, both in alphabetical order from left to "
    "right.": {
        "assets": dict.fromkeys("KLMPQR", 1),
        "hold": ["P Q R | K L M"],
        "miss": ["K L M | P Q R", "P R Q | K L M", "R Q P | K L M", "P Q R . K L M"],
    },
    "Directly behind each block of a row of two blue blocks stands a tower of two white ones.": {
        "assets": {"blue": 2, "white": 4},
        "hold": ["white^white white^white | blue blue"],
        "miss": ["white^white . | blue blue | . white^white", "blue blue | white^white white^white"],
    },
}
REFUSED = (
    "Two red and two green towers of two; only the left one gets a red block on its top.",
    "Three towers of two gray blocks stand in a row, and only the middle one is next to a blue block.",
    "A tower of two green blocks is left of both blocks of a row of two red ones.",
)


@pytest.mark.parametrize("text", CASES)
def test_states(text: str) -> None:
    assert_means(text, CASES[text])


@pytest.mark.parametrize("text", REFUSED)
def test_refused(text: str) -> None:
    assert code_of(text)
