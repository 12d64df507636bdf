"""What the parser reads of colours in turn, gaps between two things, shapes of mats, and of what none of two may be."""

from __future__ import annotations

import pytest

from tests.language.compose.test_meanings import told


@pytest.mark.parametrize(
    ("text", "meaning"),
    [
        ("Three pink and two white blocks in a row with alternating colors, and a gray block in front of the row.",
         "Pink block 1, white block 1, pink block 2, white block 2 and pink block 3 must be in a row in alternating "
         "colors The gray block must be in front of pink block 1, white block 1, pink block 2, white block 2 and pink "
         "block 3."),
        ("Leave a gap of 5 cm between the pink and the white block.",
         "There must be a gap of 5 cm between the pink block and the white block."),
        ("Put a white block on the round mat and two pink blocks on the long mat.",
         "The white block must be on the round gray patch Pink block 1 and pink block 2 must be on the long gray "
         "patch."),
        ("Neither the pink nor the white block may be on the green mat, but the gray one must be on it.",
         "The pink block must not be on the green patch The white block must not be on the green patch The gray block "
         "must be on the green patch."),
        ("Could the pink block be placed behind the tower of two white blocks?",
         "White block 1 and white block 2 must form a tower of exactly two The pink block must be behind the tower of "
         "white block 1 and white block 2."),
        ("Put the pink block on the white one, but do not move the white one at all.",
         "The pink block must be on the white block The white block must stay where it is."),
        ("A staircase of six white blocks that goes up to the left is behind the pink block.",
         "White block 1, white block 2, white block 3, white block 4, white block 5 and white block 6 must form a "
         "staircase of three steps going up to the left White block 1, white block 2, white block 3, white block 4, "
         "white block 5 and white block 6 must be behind the pink block."),
    ],
)  # fmt: skip
def test_it_is_read(text: str, meaning: str) -> None:
    assert told(text) == [meaning]


@pytest.mark.parametrize(
    "text",
    [
        "Four pink and two white blocks in a row with alternating colors.",  # they cannot take turns
        "Put a pink block on the green mat and a white one on the long mat.",  # that mat, or another one
        "The pink block must not move at all times.",
        "A tower of four whose colors alternate, and a pink block.",  # which colours?
    ],
)
def test_what_may_be_meant_otherwise_is_not_read(text: str) -> None:
    assert told(text) == []
