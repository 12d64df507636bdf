"""Towers in a row told by their heights, in which order and of what: states that must hold, and near misses."""

from __future__ import annotations

from typing import Any

import pytest

from tests.language.meaning import assert_means, code_of

CASES: dict[str, dict[str, Any]] = {
    "three towers in one row, 3, 2 and 3 high from left to right, made of eight brown cubes": {
        "assets": {"brown": 8},
        "hold": ["brown^brown^brown brown^brown brown^brown^brown"],
        "miss": [
            "brown^brown brown^brown^brown brown^brown^brown",
            "brown^brown^brown brown^brown . . brown^brown^brown",
        ],
    },
    "Build three stacks with heights 2, 3 and 4 out of nine red blocks in a row, tallest on the left and shortest on "
    "the right.": {
        "assets": {"red": 9},
        "hold": ["red^red^red^red red^red^red red^red"],
        "miss": ["red^red red^red^red red^red^red^red", "red^red^red red^red^red^red red^red"],
    },
    "Three pink towers of two, three and four blocks in a row, the tallest in the middle.": {
        "assets": {"pink": 9},
        "hold": ["pink^pink pink^pink^pink^pink pink^pink^pink", "pink^pink^pink pink^pink^pink^pink pink^pink"],
        "miss": ["pink^pink pink^pink^pink pink^pink^pink^pink", "pink^pink^pink^pink pink^pink pink^pink^pink"],
    },
    "Three towers in a row made of nine gray blocks, from right to left 4, 3 and 2 high.": {
        "assets": {"gray": 9},
        "hold": ["gray^gray gray^gray^gray gray^gray^gray^gray"],
        "miss": ["gray^gray^gray^gray gray^gray^gray gray^gray"],
    },
}
REFUSED = (
    "Line up three blue towers, 4, 2 and 2 high, sorted by height, tallest on the right.",
    "Three towers in a row made of eight gray blocks, 4, 3 and 2 high from left to right.",
    "Four black towers in a row, 2, 3, 4 and 2 high, with the tallest on the left.",
    "Four black towers in a row, 2, 3, 4 and 2 high, with the tallest in the middle.",
)


@pytest.mark.parametrize("text", CASES)
def test_states(text: str) -> None:
    assert_means(text, CASES[text])


@pytest.mark.parametrize("text", REFUSED)
def test_refused(text: str) -> None:
    assert code_of(text)
