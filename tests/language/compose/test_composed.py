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
}


@pytest.mark.parametrize("text", CASES)
def test_composed(text: str) -> None:
    assert_means(text, CASES[text])
