"""Places told by where they are not: a corner but one, anywhere but there, and a block by itself."""

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
        ("Put the red block and the blue block next to each other, and the green one by itself.", APART),
        ("Put the red cube in the middle of the table and the blue cube anywhere but there.",
         {"assets": {"red": 1, "blue": 1}, "hold": ["red at=0,0"], "miss": ["red blue pitch=1 at=0,0"]}),
    ],
)  # fmt: skip
def test_where_it_is_not(text: str, meant: dict[str, Any]) -> None:
    assert_means(text, meant)
