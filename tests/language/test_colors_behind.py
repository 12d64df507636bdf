"""Colours, and who the others are, told in a sentence behind the one that speaks of them."""

from __future__ import annotations

from typing import Any

import pytest

from rpg.passes.schema.frontend import BuiltinFrontEnd
from tests.language.meaning import assert_means


@pytest.mark.parametrize(
    ("text", "meant"),
    [
        ("A, B and C are each on a different patch. The patches are red, green and blue.",
         {"assets": {"A": 1, "B": 1, "C": 1, "red_patch": 1, "green_patch": 1, "blue_patch": 1},
          "hold": ["A at=red_patch ; B at=green_patch ; C at=blue_patch"],
          "miss": ["A B at=red_patch ; C at=blue_patch", "A at=red_patch ; B at=green_patch ; C"]}),
        ("The red block and the blue block have to be on different patches. One patch is white, the other black.",
         {"assets": {"red": 1, "blue": 1, "white_patch": 1, "black_patch": 1},
          "hold": ["red at=white_patch ; blue at=black_patch", "blue at=white_patch ; red at=black_patch"],
          "miss": ["red . blue at=white_patch"]}),
        ("Each of the three patches gets exactly one block. The patches are red, green and blue, and there are four "
         "yellow blocks.",
         {"assets": {"yellow": 4, "red_patch": 1, "green_patch": 1, "blue_patch": 1},
          "hold": ["yellow at=red_patch ; yellow at=green_patch ; yellow at=blue_patch ; yellow"],
          "miss": ["yellow . yellow at=red_patch ; yellow at=green_patch ; yellow at=blue_patch"]}),
        ("Put one block on each mat. The mats are red, white and blue; the three blocks are all gray.",
         {"assets": {"gray": 3, "red_patch": 1, "white_patch": 1, "blue_patch": 1},
          "hold": ["gray at=red_patch ; gray at=white_patch ; gray at=blue_patch"],
          "miss": ["gray . gray at=red_patch ; gray at=white_patch"]}),
        ("The red block is to the left of all the others. The others are green, blue and yellow.",
         {"assets": {"red": 1, "green": 1, "blue": 1, "yellow": 1}, "hold": ["red green blue yellow"],
          "miss": ["green red blue yellow"]}),
        ("Put the red block on the mat and the other four in a row. The others are blue.",
         {"assets": {"red": 1, "blue": 4, "patch": 1}, "hold": ["red at=patch ; blue blue blue blue"],
          "miss": ["red at=patch ; blue blue blue ; blue", "red blue blue blue blue"]}),
    ],
)  # fmt: skip
def test_colors_told_behind(text: str, meant: dict[str, Any]) -> None:
    assert_means(text, meant)


@pytest.mark.parametrize(
    "text",
    [
        "Put red on blue. The others are yellow.",  # how many?
        "A and B are each on a different patch. The three patches are red and green.",
        "The red block is left of all others. The other three are red.",
        "Put A on the red patch and B on another one. The patches are blue and green.",
    ],
)
def test_colors_that_do_not_tell_what_there_is(text: str) -> None:
    assert BuiltinFrontEnd().read(text)[0] is None
