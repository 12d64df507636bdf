"""What is read from blocks, how many are of what there is, and layers: states that must hold, and near misses."""

from __future__ import annotations

from typing import Any

import pytest

from tests.language.compose.test_meanings import told
from tests.language.meaning import assert_means

CASES: dict[str, dict[str, Any]] = {
    "I see a row of the letters N, S and U, and it reads SUN. A pink block is behind the N.": {
        "assets": {"S": 1, "U": 1, "N": 1, "pink": 1},
        "hold": [". . pink | S U N"],
        "miss": ["pink . . | N U S", "S U N | . . pink", "pink . . | S U N"],
    },
    "i see three towers and every tower has two black blocks. the first one is on the red patch, the second on the "
    "pink patch "
    "and the third on the gray patch": {
        "assets": {"black": 6, "red_patch": 1, "pink_patch": 1, "gray_patch": 1},
        "hold": ["black^black at=red_patch ; black^black at=pink_patch ; black^black at=gray_patch"],
        "miss": [
            "black^black at=red_patch ; black^black at=pink_patch ; black^black",
            "black black at=red_patch ; black^black at=pink_patch ; black^black at=gray_patch",
        ],
    },
    "Three cyan blocks. the first is on the red patch, the second on the blue patch and the third on the pink patch": {
        "assets": {"cyan": 3, "red_patch": 1, "blue_patch": 1, "pink_patch": 1},
        "hold": ["cyan at=red_patch ; cyan at=blue_patch ; cyan at=pink_patch"],
        "miss": ["cyan cyan at=red_patch ; cyan at=blue_patch", "cyan at=red_patch ; cyan at=blue_patch ; cyan"],
    },
    "two pink blocks, two gray blocks, one stack of four, no two of the same colour directly on each other": {
        "assets": {"pink": 2, "gray": 2},
        "hold": ["pink^gray^pink^gray", "gray^pink^gray^pink"],
        "miss": ["pink^gray^gray^pink", "pink^pink^gray^gray", "pink^gray ; pink^gray"],
    },
    "three blocks, all white, are on the pink mat. two more blocks, both brown, are outside of the mat": {
        "assets": {"white": 3, "brown": 2, "pink_patch": 1},
        "hold": ["white white white at=pink_patch ; brown brown"],
        "miss": ["white white white brown at=pink_patch ; brown", "white white at=pink_patch ; white ; brown brown"],
    },
    "Out of the five green cubes three belong on the gray mat and the remaining two on the cyan mat.": {
        "assets": {"green": 5, "gray_patch": 1, "cyan_patch": 1},
        "hold": ["green green green at=gray_patch ; green green at=cyan_patch"],
        "miss": ["green green at=gray_patch ; green green green at=cyan_patch"],
    },
}


@pytest.mark.parametrize("text", CASES)
def test_reading(text: str) -> None:
    assert_means(text, CASES[text])


@pytest.mark.parametrize(
    ("text", "meaning"),
    [
        (
            "There's letters P, E and N next to each other so it reads PEN",
            "The P block, the E block and the N block must spell the word PEN.",
        ),
        (
            "Six brown blocks, upright pyramid, layers of 3, 2 and 1, and a white block is on its top.",
            "Brown block 1, brown block 2, brown block 3, brown block 4, brown block 5 and brown block 6 must form a "
            "pyramid with a base of three blocks from top to bottom in the order brown block 1, brown block 2, brown "
            "block 3, brown block 4, brown block 5, brown block 6 The white block must be on brown block 1.",
        ),
    ],
)
def test_told(text: str, meaning: str) -> None:
    assert told(text) == [meaning]


@pytest.mark.parametrize(
    "text",
    [
        "There's letters P, E and N next to each other so it reads PAN",
        "a tower of the letters P, E and N, so it reads PEN",
        "three red blocks, one gray block, one tower of four, no two of the same colour directly on each other",
        "pyramid of blue blocks, layers of 4, 2 and 1",
        "three towers of two in a row. the first one is on the red patch",
    ],
)
def test_not_clear(text: str) -> None:
    assert told(text) == []
