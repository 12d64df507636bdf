"""Where no block is: states that must hold, and near misses; and what is not clear."""

from __future__ import annotations

from typing import Any

import pytest

from tests.language.compose.test_meanings import told
from tests.language.meaning import assert_means

CASES: dict[str, dict[str, Any]] = {
    "the pink block has a red block to its right and a black one to its left and a blue one in front of it. nothing "
    "behind "
    "it": {
        "assets": {"pink": 1, "red": 1, "black": 1, "blue": 1},
        "hold": ["black pink red | . blue ."],
        "miss": [". blue . | black pink red", "red pink black | . blue ."],
    },
    "there should not be anything on top of the white block. the gray block is to its left and the cyan block is "
    "behind it": {
        "assets": {"white": 1, "gray": 1, "cyan": 1},
        "hold": [". cyan | gray white"],
        "miss": ["gray white | . cyan", ". cyan | . white gray"],
    },
    "a stack of two green blocks. nothing is next to it. a red block and a blue block are on the black patch": {
        "assets": {"green": 2, "red": 1, "blue": 1, "black_patch": 1},
        "hold": ["green^green ; red blue at=black_patch"],
        "miss": ["green^green red ; blue at=black_patch"],
    },
    "a 3x3 grid of blocks. The back row is all brown, middle row all cyan, front row all gray, and a black block on "
    "the "
    "middle one": {
        "assets": {"brown": 3, "cyan": 3, "gray": 3, "black": 1},
        "hold": ["brown brown brown | cyan cyan^black cyan | gray gray gray"],
        "miss": [
            "gray gray gray | cyan cyan^black cyan | brown brown brown",
            "brown brown brown | cyan^black cyan cyan | gray gray gray",
        ],
    },
}


@pytest.mark.parametrize("text", CASES)
def test_kept_clear(text: str) -> None:
    assert_means(text, CASES[text])


@pytest.mark.parametrize(
    ("text", "meaning"),
    [
        (
            "the red block is next to the blue one. a green block is behind the red one, and nothing else is next "
            "to the red "
            "one",
            "The red block must be next to the blue block The green block must be behind the red block The green block "
            "must not be next to the red block.",
        ),
        (
            "I see two patches, a pink patch and a gray patch. On the pink patch there is a red block and a blue "
            "block. there "
            "is no block on the gray patch",
            "The red block and the blue block must be on the pink patch The gray patch must be empty.",
        ),
        (
            "A ring of eight white blocks and a red block on the green patch. nothing is in the middle of the ring.",
            "White block 1, white block 2, white block 3, white block 4, white block 5, white block 6, white block "
            "7 and "
            "white block 8 must form a circle The red block must be on the green patch.",
        ),
    ],
)
def test_told(text: str, meaning: str) -> None:
    assert meaning in told(text)


@pytest.mark.parametrize(
    "text",
    [
        "the red block is next to the blue one and nothing is next to the red one",
        "a row of five red blocks. nothing is in the middle of it",
        "the red block is left of the blue one. nothing is not on the red one",
    ],
)
def test_not_clear(text: str) -> None:
    assert told(text) == []
