"""Nothing on a block, and a block on nothing: without, never, neither, anything, carry."""

from __future__ import annotations

from typing import Any

import pytest

from rpg.passes.schema.frontend import BuiltinFrontEnd
from tests.language.meaning import assert_means


@pytest.mark.parametrize(
    ("text", "meant"),
    [
        ("Put the red block on the blue one without anything on top of the yellow cube.",
         {"assets": {"red": 1, "blue": 1, "yellow": 1}, "hold": ["blue^red yellow"], "miss": ["yellow^blue^red"]}),
        ("Put the red block on the blue one without any block on the yellow cube.",
         {"assets": {"red": 1, "blue": 1, "yellow": 1}, "hold": ["blue^red yellow"], "miss": ["yellow^blue^red"]}),
        ("Stack cyan on gray, without putting anything on the brown cube.",
         {"assets": {"cyan": 1, "gray": 1, "brown": 1}, "hold": ["gray^cyan brown"], "miss": ["brown^gray^cyan"]}),
        ("Stack cyan on gray, never putting anything on the brown cube.",
         {"assets": {"cyan": 1, "gray": 1, "brown": 1}, "hold": [["cyan gray brown", "gray^cyan brown"]],
          "miss": [["cyan gray brown", "brown^gray^cyan"], ["gray brown^cyan", "gray^cyan brown"]]}),
        ("The white cube should lie on the table and carry nothing on itself.",
         {"assets": {"white": 1}, "hold": ["white"], "miss": []}),
        ("The white block must be on the black one and carry nothing.",
         {"assets": {"white": 1, "black": 1}, "hold": ["black^white"], "miss": ["white^black", "white black"]}),
        ("The red block lies on the mat and carries the blue one on itself.",
         {"assets": {"red": 1, "blue": 1, "patch": 1}, "hold": ["red^blue at=patch"], "miss": ["blue^red at=patch"]}),
        ("Please don't put the blue cube on top of anything, just lay it to the right of the red one.",
         {"assets": {"blue": 1, "red": 1}, "hold": ["red blue"], "miss": ["blue red", "red^blue"]}),
        ("The red and the green one are both to the right of the black one; neither is on anything.",
         {"assets": {"red": 1, "green": 1, "black": 1}, "hold": ["black red green", "black green red"],
          "miss": ["black green^red", "red black green"]}),
        ("Neither of the two red cubes lies on anything.",
         {"assets": {"red": 2}, "hold": ["red red"], "miss": ["red^red"]}),
        ("A blue block stands between two red ones, both of which carry a white block.",
         {"assets": {"blue": 1, "red": 2, "white": 2}, "hold": ["red^white blue red^white"],
          "miss": ["red^white blue red white", "blue red^white red^white"]}),
    ],
)  # fmt: skip
def test_what_carries_nothing_and_what_lies_on_nothing(text: str, meant: dict[str, Any]) -> None:
    assert_means(text, meant)


@pytest.mark.parametrize(
    "text",
    [
        "Put nothing on anything.",
        "Don't put the red block on anything; there is a blue mat.",
        "Neither red nor blue may lie on anything but green.",
        "Neither red nor blue is on nothing.",
    ],
)
def test_what_nothing_is_left_of_is_refused(text: str) -> None:
    schema, _ = BuiltinFrontEnd().read(text)
    assert schema is None
