"""Sentences that only the compositional reader reads: states that must hold, and near misses that must not."""

from __future__ import annotations

from typing import Any

import pytest

from tests.language.meaning import assert_means

CASES: dict[str, dict[str, Any]] = {
    "Take the four yellow blocks: two of them become a tower off the blue patch, and the other two go on that patch.": {
        "assets": {"yellow": 4, "blue_patch": 1},
        "hold": ["yellow yellow at=blue_patch ; yellow^yellow"],
        "miss": ["yellow^yellow yellow yellow at=blue_patch", "yellow yellow at=blue_patch", "yellow ; yellow^yellow"],
    },
    "Build a row of three red blocks, with a blue block on top of its middle block and a green block in front of it.": {
        "assets": {"red": 3, "blue": 1, "green": 1},
        "hold": ["red red^blue red | . green ."],
        "miss": ["red^blue red red | . green .", ". green . | red red^blue red", "red red red | . green . ; blue"],
    },
    "I need two stacks, one red on blue and one yellow on green, plus a white block standing between the two stacks.": {
        "assets": {"red": 1, "blue": 1, "yellow": 1, "green": 1, "white": 1},
        "hold": ["blue^red white green^yellow", "green^yellow white blue^red"],
        "miss": ["blue^red green^yellow white", "red^blue white green^yellow", "blue^red ; green^yellow ; white"],
    },
    "The A belongs on the red or the blue cube, and the B on whichever of those two the A is not on.": {
        "assets": {"A": 1, "B": 1, "red": 1, "blue": 1},
        "hold": ["red^A blue^B", "red^B blue^A"],
        "miss": ["red^A^B blue", "A^red B^blue", "red^A blue B", "red blue^A^B"],
    },
    "Build two stacks, red on blue and green on blue. The white block goes to the left of the one with red on top.": {
        "assets": {"red": 1, "green": 1, "blue": 2, "white": 1},
        "hold": ["white blue^red blue^green"],
        "miss": ["blue^red white blue^green", "white blue^green red^blue"],
    },
    "One tower is red on blue, the other green on yellow. The white block stands next to whichever has yellow in it.": {
        "assets": {"red": 1, "blue": 1, "green": 1, "yellow": 1, "white": 1},
        "hold": ["blue^red . . . yellow^green white"],
        "miss": ["white blue^red . . . yellow^green", "blue^red . . . green^yellow white"],
    },
    "Two red and two blue blocks form a row, and neither of the red ones may be at an end of it.": {
        "assets": {"red": 2, "blue": 2},
        "hold": ["blue red red blue"],
        "miss": ["red blue blue red", "blue red blue red", "blue^red red blue"],
    },
    "B, C and D form a tower to the right of A; the D is neither at its top nor at its bottom.": {
        "assets": {"A": 1, "B": 1, "C": 1, "D": 1},
        "hold": ["A B^D^C", "A C^D^B"],
        "miss": ["A B^C^D", "A D^B^C", "B^D^C A", "A B^D C"],
    },
}


@pytest.mark.parametrize("text", CASES)
def test_composed(text: str) -> None:
    assert_means(text, CASES[text])
