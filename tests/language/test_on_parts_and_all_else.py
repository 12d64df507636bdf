"""What lies on a block of a figure is no part of it; all else; towers of a row told by where they are."""

from __future__ import annotations

from typing import Any

import pytest

from tests.language.meaning import assert_means, code_of

_SQUARE = {"white": 4, "red": 1}
_STACKS = {"red": 2, "blue": 2, "green": 2}


@pytest.mark.parametrize(
    ("text", "meant"),
    [
        ("A 2 by 2 square of white blocks, on its back right block a red cube",
         {"assets": _SQUARE, "hold": ["white white^red | white white pitch=1"],
          "miss": ["white^red white | white white pitch=1", "white red | white white pitch=1"]}),
        ("Make a row of three stacks of two, one red, one blue, one green, the green one in the middle",
         {"assets": _STACKS, "hold": ["red^red green^green blue^blue", "blue^blue green^green red^red"],
          "miss": ["green^green red^red blue^blue"]}),
        ("Pink goes on white and gray goes on cyan. The K lies on top of whichever stack has no white in it.",
         {"assets": {"pink": 1, "white": 1, "gray": 1, "cyan": 1, "K": 1}, "hold": ["white^pink cyan^gray^K"],
          "miss": ["white^pink^K cyan^gray"]}),
    ],
)  # fmt: skip
def test_it_is_told_of_the_one_that_is_meant(text: str, meant: dict[str, Any]) -> None:
    assert_means(text, meant)


@pytest.mark.parametrize(
    "text",
    [
        "Make a tower of three with a red block on top and next to it a tower of two with a red block at the bottom, "
        "everything else white.",
    ],
)
def test_all_else_is_all_of_which_no_color_is_told(text: str) -> None:
    assert code_of(text)


def test_what_is_left_of_a_figure_has_the_color_of_all_else() -> None:
    assert_means(
        "A row of three with a pink block in the middle, everything else is cyan",
        {"assets": {"pink": 1, "cyan": 2}, "hold": ["cyan pink cyan"], "miss": ["pink cyan cyan"]},
    )
