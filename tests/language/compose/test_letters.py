"""Letters told by their parts: states that must hold, and near misses; and parts that make no letter."""

from __future__ import annotations

from typing import Any

import pytest

from tests.language.compose.test_meanings import told
from tests.language.meaning import assert_means

CASES: dict[str, dict[str, Any]] = {
    "Make a T from six gray blocks with a crossbar of three on the left side, and put a white block on the end of the "
    "stem.": {
        "assets": {"gray": 6, "white": 1},
        "hold": ["gray . . . | gray gray gray gray^white | gray . . ."],
        "miss": [
            ". . . gray | gray^white gray gray gray | . . . gray",
            "gray . . . | gray^white gray gray gray | gray . . .",
            "gray gray gray | . gray . | . gray . | . gray^white .",
        ],
    },
    "I see a T: five blocks for the bar, and three more blocks come from its middle away from me. all blocks are red": {
        "assets": {"red": 8},
        "hold": [". . red . . | . . red . . | . . red . . | red red red red red"],
        "miss": ["red red red red red | . . red . . | . . red . . | . . red . .", ". red . | . red . | . red . | "
        "red red red"],
    },
    "a capital T made of seven pink blocks lying on the table: its bar is five long and lies at the back.": {
        "assets": {"pink": 7},
        "hold": ["pink pink pink pink pink | . . pink . . | . . pink . ."],
        "miss": [
            ". . pink . . | . . pink . . | pink pink pink pink pink",
            "pink pink pink | . pink . | . pink . | . pink . | . pink .",
        ],
    },
    "an L of five black cubes, the long arm of four blocks running away from me and the foot to the left, and "
    "behind it a "
    "white block": {
        "assets": {"black": 5, "white": 1},
        "hold": [". white . | . black . | . black . | . black . | black black ."],
        "miss": [
            "white . | black . | black . | black . | black black",
            ". black . | . black . | . black . | black black . | . white .",
        ],
    },
    "letter L from four cyan blocks: a line of three running away from us, and one foot block to the right of the "
    "nearest": {
        "assets": {"cyan": 4},
        "hold": ["cyan . | cyan . | cyan cyan"],
        "miss": [". cyan | . cyan | cyan cyan", "cyan cyan | cyan . | cyan ."],
    },
    "A U shape of nine blue blocks, three wide and four deep, open to the front. Put a red block on each tip.": {
        "assets": {"blue": 9, "red": 2},
        "hold": ["blue blue blue | blue . blue | blue . blue | blue^red . blue^red"],
        "miss": [
            "blue^red . blue^red | blue . blue | blue . blue | blue blue blue",
            "blue^red blue blue^red | blue . blue | blue . blue | blue . blue",
        ],
    },
    "make a U shape from eight orange blocks. 3 on the left side, 3 on the right side and two blocks in the middle "
    "that "
    "connect them at the back": {
        "assets": {"orange": 8},
        "hold": ["orange orange orange orange | orange . . orange | orange . . orange"],
        "miss": ["orange . . orange | orange . . orange | orange orange orange orange"],
    },
}  # fmt: skip


@pytest.mark.parametrize("text", CASES)
def test_letters(text: str) -> None:
    assert_means(text, CASES[text])


@pytest.mark.parametrize(
    "text",
    [
        "a T of six green cubes, its bar four long and its stem pointing towards me",
        "a T of five green cubes, its bar on the far side and its stem pointing away from me, and a pink cube on "
        "the foot "
        "of the stem",
        "an L of four red blocks, the long arm runs away from me and the foot is at the far end and points to the "
        "right",
        "an L of five red blocks, the long arm runs to the left and the foot points towards me",
        "a U from eight red blocks. 3 on the left side, 4 on the right side and one block in the middle that connects "
        "them at the back",
        "a T of red blocks, its bar four long and its stem two long",
    ],
)
def test_no_such_letter(text: str) -> None:
    assert told(text) == []


def test_further_blocks_are_no_part() -> None:
    meanings = told("a T of five red blocks and two blue blocks to the left of it. The T is in front of a white block.")
    assert not any("stem" in meaning for meaning in meanings)
