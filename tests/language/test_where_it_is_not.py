"""Places told by where they are not: a corner but one, anywhere but there, in no row; and who is nowhere there."""

from __future__ import annotations

from typing import Any

import pytest

from tests.language.meaning import assert_means

A_CORNER = {
    "assets": {"red": 1},
    "hold": ["red at=-3.25,5.5", "red at=3.25,5.5", "red at=-3.25,-5.5"],
    "miss": ["red at=3.25,-5.5", "red at=0,0"],
}
NEAR = {
    "assets": {"red": 1},
    "hold": ["red at=-3.25,5.5", "red at=-3.25,-5.5"],
    "miss": ["red at=3.25,-5.5", "red at=0,0"],
}
APART = {
    "assets": {"red": 1, "blue": 1, "green": 1},
    "hold": ["red blue pitch=1 ; green"],
    "miss": ["red blue green pitch=1", "red ; blue ; green"],
}


@pytest.mark.parametrize(
    ("text", "meant"),
    [
        ("Put the red block in any corner but the far right one.", A_CORNER),
        ("Put the red block in a corner, but not the far right one.", A_CORNER),
        ("Put the red block in one of the near corners.", NEAR),
        ("Put both red blocks in one corner of the table.",
         {"assets": {"red": 2}, "hold": ["red red pitch=1 at=3.25,5.5", "red red pitch=1 at=-3.25,-5.5"],
          "miss": ["red at=3.25,5.5 ; red at=3.25,-5.5"]}),
        ("Put the red block and the blue block next to each other, and the green one by itself.", APART),
        ("Lay five green blocks in a row. The two red ones must not be in the row.",
         {"assets": {"green": 5, "red": 2}, "hold": ["green green green green green ; red red"],
          "miss": ["green green green green green red ; red", "green green green ; green green"]}),
        ("The A goes next to the B. The C goes next to neither.",
         {"assets": {"A": 1, "B": 1, "C": 1}, "hold": ["A B pitch=1 ; C"], "miss": ["A B C pitch=1"]}),
        ("Some of the four green blocks must be on the white patch, but not all of them.",
         {"assets": {"green": 4, "white_patch": 1}, "hold": ["green at=white_patch"], "miss": ["green ; green"]}),
        ("The 2 is not left but right of the 1.",
         {"assets": {"1": 1, "2": 1}, "hold": ["1 2"], "miss": ["2 1", "1 | 2"]}),
        ("Neither the red nor the blue block may move. Put the green block between them.",
         {"assets": {"red": 1, "blue": 1, "green": 1},
          "hold": [["red at=0,3 ; blue at=0,-3 ; green at=3,0", "red at=0,3 ; blue at=0,-3 ; green at=0,0"]],
          "miss": [["red at=0,3 ; blue at=0,-3 ; green at=3,0", "red at=2,3 ; blue at=2,-3 ; green at=2,0"]]}),
        ("Put two yellow blocks on one patch and two on the other. The patches are red and blue.",
         {"assets": {"yellow": 4, "red_patch": 1, "blue_patch": 1},
          "hold": ["yellow . yellow at=red_patch ; yellow . yellow at=blue_patch"],
          "miss": ["yellow . yellow at=red_patch ; yellow at=blue_patch"]}),
        ("Put the red cube in the middle of the table and the blue cube anywhere but there.",
         {"assets": {"red": 1, "blue": 1}, "hold": ["red at=0,0"], "miss": ["red blue pitch=1 at=0,0"]}),
    ],
)  # fmt: skip
def test_where_it_is_not(text: str, meant: dict[str, Any]) -> None:
    assert_means(text, meant)
