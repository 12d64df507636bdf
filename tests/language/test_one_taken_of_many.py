"""One of several that look alike, what is left without it, and what a last sentence adds."""

from __future__ import annotations

from typing import Any

import pytest

from rpg.passes.schema.frontend import BuiltinFrontEnd
from tests.language.meaning import assert_means

THREE_RED = {
    "assets": {"red": 3, "patch": 1},
    "start": ["red^red^red"],
    "hold": ["red at=patch ; red^red"],
    "miss": ["red^red^red at=patch", "red^red^red", "red^red at=patch ; red"],
}
ONE_OF_TWO = {
    "assets": {"black": 2, "white": 1, "patch": 1},
    "hold": ["black at=patch ; black ; white"],
    "miss": ["black . black at=patch ; white", "white at=patch ; black ; black"],
}
SUN = {"assets": {"S": 1, "U": 1, "N": 1}, "hold": ["S U N"], "miss": ["N U S", "S N U"]}
THREE_STEPS = {
    "assets": {"A": 1, "B": 1, "C": 1, "red_patch": 1},
    "hold": [["A ; B ; C", "A at=red_patch ; B ; C", "A^B at=red_patch ; C", "A^B^C at=red_patch"]],
    "miss": [["A ; B ; C", "A^B ; C", "A^B^C at=red_patch"], ["A ; B ; C", "A at=red_patch ; B ; C"]],
}


@pytest.mark.parametrize(
    ("text", "meant"),
    [
        ("Take the top cube off the tower of three red cubes and put it on the patch.", THREE_RED),
        ("Take the top cube from the tower of three red cubes and put it on the patch.", THREE_RED),
        ("There is a tower of three red cubes. Put the top one on the patch.", THREE_RED),
        ("Two black blocks and a white one on the table. One black block is on the mat, the other is not.", ONE_OF_TWO),
        ("There are two black blocks and a white one. One black block is on the mat, the other is not.", ONE_OF_TWO),
        ("There are two black and two white blocks. One black block is on a white one, the other is not.",
         {"assets": {"black": 2, "white": 2}, "hold": ["white^black ; black ; white"],
          "miss": ["white^black ; white^black", "black ; black ; white ; white"]}),
        ("Please put the letters of the word SUN next to each other so that the class can read it.", SUN),
        ("Spell SUN so that my little brother can read it.", SUN),
        ("First lay the A on the red mat, then stack the B on the A, and at the end the C on the B.", THREE_STEPS),
        ("First put A on the red mat, then put B on A, and in the end put C on B.", THREE_STEPS),
        ("At the start red is left of green, which is left of a blue block. Put red on blue.",
         {"assets": {"red": 1, "green": 1, "blue": 1}, "start": ["red green blue"],
          "start_miss": ["green red blue", "red blue green"], "hold": ["blue^red ; green"], "miss": ["red blue green"]}),
    ],
)  # fmt: skip
def test_one_taken_of_many(text: str, meant: dict[str, Any]) -> None:
    assert_means(text, meant)


@pytest.mark.parametrize(
    "text",
    [
        "Put the red blocks in turn on the mat.",
        "Two blue blocks stand side by side; the left one has a red one, the right one a green one.",
        "Lay out S, U and N so that the children can read it.",
    ],
)
def test_what_could_be_meant_otherwise_is_refused(text: str) -> None:
    assert BuiltinFrontEnd().read(text)[0] is None
