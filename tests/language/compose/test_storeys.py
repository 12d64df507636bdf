"""Towers told block by block, by where each is: states that must hold, and near misses; and what is not clear."""

from __future__ import annotations

from typing import Any

import pytest

from tests.language.compose.test_meanings import told
from tests.language.meaning import assert_means

CASES: dict[str, dict[str, Any]] = {
    "two towers of three. the left one has a red block at the bottom, a blue one in the middle and a white one on top. "
    "the right one is the other way around. a black block is between them": {
        "assets": {"red": 2, "blue": 2, "white": 2, "black": 1},
        "hold": ["red^blue^white black white^blue^red"],
        "miss": [
            "white^blue^red black red^blue^white",
            "red^blue^white black red^blue^white",
            "red^blue^white white^blue^red black",
        ],
    },
    "I see two stacks with two cubes each. The left stack is gray on the bottom, pink on top. The right stack is "
    "just the "
    "opposite, pink on the bottom and gray on top.": {
        "assets": {"gray": 2, "pink": 2},
        "hold": ["gray^pink pink^gray", "gray^pink . . pink^gray"],
        "miss": ["pink^gray gray^pink", "gray^pink gray^pink"],
    },
    "the left tower is green at the bottom and pink on top, the right one is the other way round": {
        "assets": {"green": 2, "pink": 2},
        "hold": ["green^pink . pink^green"],
        "miss": ["pink^green . green^pink", "green^pink . green^pink"],
    },
    "a tower. brown is on the bottom, then comes blue, then white, and on the top is cyan. it stands behind a black "
    "block": {
        "assets": {"brown": 1, "blue": 1, "white": 1, "cyan": 1, "black": 1},
        "hold": ["brown^blue^white^cyan | black"],
        "miss": ["black | brown^blue^white^cyan", "cyan^white^blue^brown | black", "brown^white^blue^cyan | black"],
    },
}


@pytest.mark.parametrize("text", CASES)
def test_storeys(text: str) -> None:
    assert_means(text, CASES[text])


@pytest.mark.parametrize(
    "text",
    [
        "two towers of two. the left one is red at the bottom and blue on top. the right one is the other way "
        "around, red "
        "at the bottom and blue on top",
        "two towers of two. the left one is red at the bottom and blue on top.",
        "two towers of three. the left one is red at the bottom and blue on top. the right one is the other way around",
        "two towers of two. the left one is red at the bottom and blue at the bottom. the right one is green on white",
        "a tower of three. red is at the bottom, then comes blue, then white. it stands behind a black block",
    ],
)
def test_not_clear(text: str) -> None:
    assert told(text) == []
