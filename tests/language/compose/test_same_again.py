"""A further figure like the one told last, several of the same blocks, what is listed without commas; near misses."""

from __future__ import annotations

from typing import Any

import pytest

from tests.language.meaning import assert_means, code_of

CASES: dict[str, dict[str, Any]] = {
    "A tower that goes blue, red, blue from bottom to top, and the same thing again right beside it.": {
        "assets": {"blue": 4, "red": 2},
        "hold": ["blue^red^blue blue^red^blue"],
        "miss": ["blue^red^blue . . blue^red^blue", "blue^red^blue blue^blue^red", "red^blue^blue blue^red^blue"],
    },
    "A tower of two brown blocks and an identical one to the left of it.": {
        "assets": {"brown": 4},
        "hold": ["brown^brown . brown^brown"],
        "miss": ["brown^brown | brown^brown", "brown^brown^brown brown"],
    },
    "i'd like a row of four, gray cyan gray cyan from left to right, with a red cube behind the rightmost one": {
        "assets": {"gray": 2, "cyan": 2, "red": 1},
        "hold": [". . . red | gray cyan gray cyan"],
        "miss": ["red . . . | gray cyan gray cyan", ". . . red | cyan gray cyan gray"],
    },
    "Each of the two white blocks carries a pink block, and the two pairs are next to each other.": {
        "assets": {"white": 2, "pink": 2},
        "hold": ["white^pink white^pink"],
        "miss": ["pink^white pink^white", "white^pink . . . white^pink", "white^white^pink pink"],
    },
}
REFUSED = (
    "The word CAT and the same again behind it.",
    "A red and a blue tower of two, and the same thing again behind it.",
    "i'd like a row of three, gray cyan gray cyan from left to right, with a red cube behind the rightmost one",
)


@pytest.mark.parametrize("text", CASES)
def test_states(text: str) -> None:
    assert_means(text, CASES[text])


@pytest.mark.parametrize("text", REFUSED)
def test_refused(text: str) -> None:
    assert code_of(text)
