"""Several structures told one by one: what "one" is of them, and what stands beside which."""

from __future__ import annotations

from typing import Any

import pytest

from rpg.passes.schema.frontend import BuiltinFrontEnd
from tests.language.meaning import assert_means

TWO: dict[str, Any] = {
    "assets": {"red": 3, "blue": 2}, "hold": ["red^red^red blue^blue"], "miss": ["blue^blue red^red^red"],
}  # fmt: skip
SQUARES: dict[str, Any] = {
    "assets": {"yellow": 4, "black": 4},
    "hold": ["yellow yellow | yellow yellow pitch=1,1 ; black black | black black pitch=1,1"],
    "miss": ["black black | black black pitch=1,1 ; yellow yellow | yellow yellow pitch=1,1"],
}


@pytest.mark.parametrize(
    ("text", "meant"),
    [
        ("Goal: two towers, a red one of height 3 on the left and a blue one of height 2 on the right", TWO),
        ("two towers, a red one three high on the left and a blue one two high on the right", TWO),
        ("Build two towers, a red one with three blocks and a blue one with two, the red one on the left.", TWO),
        ("Build a red tower with three blocks and a blue tower with two, the blue one on the right.", TWO),
        ("Lay two 2x2 squares, a yellow one and a black one, the former to the left of the latter.", SQUARES),
        ("a yellow 2x2 square and a black 2x2 square, the yellow one to the left of the black one", SQUARES),
        ("Two little pyramids, three blocks each: a red pyramid and a gray one.",
         {"assets": {"red": 3, "gray": 3},
          "hold": [". red . | red . red side pitch=0.525,1; . gray . | gray . gray side pitch=0.525,1"],
          "miss": ["red^red^red gray^gray^gray"]}),
        ("Three towers: a pink one two high, a cyan one three high, and a white one four high.",
         {"assets": {"pink": 2, "cyan": 3, "white": 4}, "hold": ["pink^pink cyan^cyan^cyan white^white^white^white"],
          "miss": ["pink^pink^cyan cyan^cyan white^white^white^white"]}),
        ("Build a tower of three red blocks and a tower of three blue blocks. Put a green block on the red one.",
         {"assets": {"red": 3, "blue": 3, "green": 1}, "hold": ["red^red^red^green blue^blue^blue"],
          "miss": ["red^red^red blue^blue^blue^green"]}),
        ("A row of three red and a row of three blue blocks. The red one is behind the blue one.",
         {"assets": {"red": 3, "blue": 3}, "hold": ["red red red | . . . | blue blue blue"],
          "miss": ["blue blue blue | . . . | red red red"]}),
        ("a red tower of two and a green row of two, the red one on the left",
         {"assets": {"red": 2, "green": 2}, "hold": ["red^red green green"],
          "miss": ["green green red^red", "red red green^green", "green red^red green"]}),
    ],
)  # fmt: skip
def test_structures_told_one_by_one(text: str, meant: dict[str, Any]) -> None:
    assert_means(text, meant)


@pytest.mark.parametrize(
    "text",
    [
        "Two towers, a red one at the bottom and a blue one on top",
        "Two towers, a red one on each mat",
        "Three towers, a red one of two and a blue one of three",
        "Put two towers on the mat, a red one of two and a blue one of three.",
    ],
)
def test_what_is_not_one_for_one_is_refused(text: str) -> None:
    schema, _ = BuiltinFrontEnd().read(text)
    assert schema is None
