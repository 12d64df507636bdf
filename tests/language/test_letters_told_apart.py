"""Letters that stand several times in a word, of which one is spoken of by its place among them."""

from __future__ import annotations

from typing import Any

import pytest

from tests.language.meaning import assert_means, code_of

Meant = dict[str, Any]
SECOND_A: Meant = {
    "assets": {"A": 2, "N": 2},
    "hold": ["A N N A~180"],
    "miss": ["A~180 N N A", "A N N A", "A~180 N N A~180", "N A N A~180"],
}


@pytest.mark.parametrize(
    ("text", "meant"),
    [
        ("Spell ANNA, but the second A is upside down.", SECOND_A),
        ("Spell ANNA. Turn the last letter upside down.", SECOND_A),
        ("Spell BOB with only the first B upside down.",
         {"assets": {"B": 2, "O": 1}, "hold": ["B~180 O B"], "miss": ["B O B~180", "B~180 O B~180", "B O B"]}),
        ("Spell BOOK and put a green block on the first O.",
         {"assets": {"B": 1, "O": 2, "K": 1, "green": 1}, "hold": ["B O^green O K"],
          "miss": ["B O O^green K", "B O O K ; green"]}),
        ("Spell NOON in a tower, with the second O turned a quarter turn to the left.",
         {"assets": {"N": 2, "O": 2}, "hold": [], "miss": ["N^O^O^N", "N O O N"]}),
    ],
)  # fmt: skip
def test_it_stands_where_it_is_told(text: str, meant: Meant) -> None:
    assert_means(text, meant)


@pytest.mark.parametrize(
    ("text", "code"),
    [
        ("Spell ANNA with the third A upside down.", "no-referent"),
        ("The letters spell ANNA. Turn the second N upside down.", "ambiguous"),
        ("Make 2+2=4 and turn the second 2 upside down.", "ambiguous"),
    ],
)
def test_where_it_is_not_told(text: str, code: str) -> None:
    assert code_of(text) == code
