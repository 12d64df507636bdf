"""Short words that say which blocks, how many, and in what order: the 1 at the bottom, out of them, in that order."""

from __future__ import annotations

from typing import Any

import pytest

from rpg.passes.schema.frontend import BuiltinFrontEnd
from tests.language.meaning import assert_means

UP: dict[str, Any] = {"assets": {"1": 1, "2": 1, "3": 1}, "hold": ["1^2^3"], "miss": ["3^2^1", "1^3^2"]}
OTHER_WAY: dict[str, Any] = {
    "assets": {"red": 1, "yellow": 1, "blue": 1}, "start": ["red^yellow^blue"], "start_miss": ["blue^yellow^red"],
    "hold": ["blue^yellow^red"], "miss": ["red^yellow^blue"],
}  # fmt: skip
FROM_THE_HEAP: dict[str, Any] = {
    "assets": {"red": 6}, "heap": 6, "hold": ["red^red^red"], "miss": ["red^red"],
}  # fmt: skip


@pytest.mark.parametrize(
    ("text", "meant"),
    [
        ("Build a tower with the 1 at the bottom, the 2 in the middle and the 3 on top.", UP),
        ("At the start there is a tower with red at the bottom, yellow in the middle and blue on top. At the end the "
         "same three cubes are to form a tower in the opposite order.", OTHER_WAY),
        ("Initially the blocks are stacked with red at the bottom, yellow in the middle and blue at the top; invert "
         "the order of the stack.", OTHER_WAY),
        ("At the start there is a row of A, B and C from left to right. In the end these three should form a row in "
         "the opposite order.",
         {"assets": {"A": 1, "B": 1, "C": 1}, "start": ["A B C"], "hold": ["C B A"], "miss": ["A B C", "C A B"]}),
        ("We begin with a heap of six red blocks. From it make a tower of three.", FROM_THE_HEAP),
        ("Six red blocks lie in a heap. Make a tower of three from these.", FROM_THE_HEAP),
        ("There are three purple and three white blocks. Make a purple row and a white row out of them.",
         {"assets": {"purple": 3, "white": 3}, "hold": ["purple purple purple ; white white white"],
          "miss": ["purple white purple ; white purple white"]}),
        ("At least two of the three black cubes must lie on the pink mat. The others may be anywhere.",
         {"assets": {"black": 3, "pink_patch": 1}, "hold": ["black black at=pink_patch"],
          "miss": ["black at=pink_patch"]}),
        ("White between two blues in a row, and yellow stacked on white.",
         {"assets": {"white": 1, "blue": 2, "yellow": 1}, "hold": ["blue white^yellow blue"],
          "miss": ["white^yellow blue blue", "blue^yellow white blue"]}),
        ("Put A between B and C in a row.",
         {"assets": {"A": 1, "B": 1, "C": 1}, "hold": ["B A C", "C A B"], "miss": ["A B C", "B C A"]}),
        ("Put the white block on the red one and, in turn, the blue one on the white one.",
         {"assets": {"white": 1, "red": 1, "blue": 1}, "hold": ["red^white^blue"], "miss": ["red^white blue"]}),
        ("Put the red block on the mat and the blue one on the table. In this order.",
         {"assets": {"red": 1, "blue": 1, "patch": 1}, "hold": [["red^blue", "red at=patch", "red at=patch ; blue"]],
          "miss": ["blue at=patch ; red"]}),
        ("Two blue cubes carry letters, X and Y; put X on Y.",
         {"assets": {"blue:X": 1, "blue:Y": 1}, "hold": ["blue:Y^blue:X"], "miss": ["blue:X^blue:Y"]}),
        ("All red blocks, two in number, are left of all blue blocks, of which there are also two.",
         {"assets": {"red": 2, "blue": 2}, "hold": ["red red blue blue"], "miss": ["red blue red blue"]}),
        ("Two tan cubes and two green cubes: no green cube stands on the table.",
         {"assets": {"brown": 2, "green": 2}, "hold": ["brown^green brown^green"], "miss": ["green brown^green"]}),
        ("Write 6 - 2 = 4 with cubes, in exactly this order from left to right.",
         {"assets": {"6": 1, "-": 1, "2": 1, "=": 1, "4": 1}, "hold": ["6 - 2 = 4"], "miss": ["2 - 6 = 4"]}),
        ("A row of a red, a green and a blue block, in which nothing is to the left of the blue one.",
         {"assets": {"red": 1, "green": 1, "blue": 1}, "hold": ["blue red green", "blue green red"],
          "miss": ["red blue green", "red green blue"]}),
        ("A red tower and a yellow tower, both four high, with a single green block between them.",
         {"assets": {"red": 4, "yellow": 4, "green": 1}, "hold": ["red^red^red^red green yellow^yellow^yellow^yellow"],
          "miss": ["red^red^red^red yellow^yellow^yellow^yellow green",
                   "red^red^red red green yellow^yellow^yellow^yellow"]}),
        ("The cubes are red, green and blue, and so are the three mats. Each cube goes on the mat of its own colour.",
         {"assets": {"red": 1, "green": 1, "blue": 1, "red_patch": 1, "green_patch": 1, "blue_patch": 1},
          "hold": ["red at=red_patch ; green at=green_patch ; blue at=blue_patch"],
          "miss": ["green at=red_patch ; red at=green_patch ; blue at=blue_patch"]}),
        ("A long orange mat and four blue blocks are on the table. None of the blocks may remain off the mat.",
         {"assets": {"blue": 4, "patch{long}": 1}, "hold": ["blue^blue^blue^blue at=patch"],
          "miss": ["blue^blue^blue at=patch"]}),
        ("One red block, one blue tower of three: red goes in front of the tower.",
         {"assets": {"red": 1, "blue": 3}, "hold": ["blue^blue^blue | red"], "miss": ["red | blue^blue^blue"]}),
        ("Red starts on the table and blue starts on green; the goal is red on green, with blue on the table.",
         {"assets": {"red": 1, "blue": 1, "green": 1}, "start": ["green^blue red"], "hold": ["green^red blue"],
          "miss": ["green^blue red", "blue^red green"]}),
    ],
)  # fmt: skip
def test_small_words_say_what_is_meant(text: str, meant: dict[str, Any]) -> None:
    assert_means(text, meant)


@pytest.mark.parametrize(
    "text",
    [
        "Four blocks are stacked with red at the bottom, yellow in the middle and blue at the top.",
        "There are three purple and three white blocks. Make a green row from them.",
        "There are three red and three blue blocks. Make a tower of three out of them.",
        "At the start there is a row of A, B and C from left to right. In the end these three should form a tower in "
        "the opposite order.",
        "Put two black cubes on the pink mat, the others can be anywhere.",
        "Put a black cube between four white ones in a row.",
        "Put the red block, alternating, on the blue one.",
        "A is on B. C is on D. In that order.",
        "Build two towers of three, each of a different color. In the middle.",
        "The red blocks, at least two in number, go on the mat.",
        "Two blue cubes carry letters, X and Y and Z; put X on Y.",
        "Build a tower of three: red at the bottom, blue in the middle and green at the top. The top one is yellow.",
        "The two mats are red, green and blue. Put a white block on the red mat.",
        "Put the red block on the mat: red, green, blue.",
        "A red tower of two and a yellow tower of three, both two high.",
        "The blocks are red and green. There are six of them. Stack them.",
        "Put the cubes in a tower such that the equation 8 - 3 = 5 can be read.",
        "Put red on blue. In a row.",
    ],
)
def test_what_these_words_do_not_say_is_refused(text: str) -> None:
    schema, _ = BuiltinFrontEnd().read(text)
    assert schema is None
