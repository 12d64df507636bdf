"""Everyday ways to tell what is at the ends of a line, on each of some patches, as high as another, or taken back."""

from __future__ import annotations

from typing import Any

import pytest

from rpg.passes.schema.frontend import BuiltinFrontEnd
from tests.language.meaning import assert_means

ORDERED = {"assets": {"red": 1, "yellow": 1, "blue": 1}}
TOWER = {**ORDERED, "hold": ["red^yellow^blue"], "miss": ["red^blue^yellow", "blue^yellow^red", "yellow^red^blue"]}
ROW = {**ORDERED, "hold": ["red yellow blue"], "miss": ["red blue yellow", "blue yellow red", "red^yellow^blue"]}
ON_ENDS = {
    "assets": {"gray": 3, "white": 2},
    "hold": ["gray^white gray gray^white"],
    "miss": ["gray^white gray^white gray", "gray gray gray ; white ; white", "white gray gray gray white"],
}
ON_EACH = {
    "assets": {"yellow": 2, "red_patch": 1, "blue_patch": 1},
    "hold": ["yellow at=red_patch ; yellow at=blue_patch"],
    "miss": ["yellow^yellow at=red_patch", "yellow at=red_patch ; yellow"],
}
BY_COLOR = {
    "assets": {"red": 2, "blue": 2, "red_patch": 1, "blue_patch": 1},
    "hold": ["red^red at=red_patch ; blue^blue at=blue_patch"],
    "miss": ["red^red at=blue_patch ; blue^blue at=red_patch", "red^blue at=red_patch ; blue^red at=blue_patch"],
}
GRID = {"assets": {"black": 8}, "hold": ["black black black black | black black black black"],
        "miss": ["black black | black black | black black | black black"]}  # fmt: skip
HIGHER = {"assets": {"blue": 3, "red": 4}, "hold": ["blue^blue^blue ; red^red^red^red"],
          "miss": ["blue^blue ; blue ; red^red^red^red", "blue^blue^blue ; red^red^red ; red"]}  # fmt: skip
SANDWICH = {"assets": {"purple": 2, "yellow": 1}, "hold": ["purple^yellow^purple"],
            "miss": ["purple yellow purple", "purple^purple^yellow", "yellow^purple^purple"]}  # fmt: skip
THREES = {"assets": {"3": 2, "5": 1}, "hold": ["3 3 5"], "miss": ["3 3 ; 5", "3^3 5"]}
CAT = {"assets": {"C": 1, "A": 1, "T": 1}, "hold": ["C A T"], "miss": ["T A C", "A C T"]}
SIDES = {"assets": {"red": 1, "blue": 4}, "hold": [". blue . | blue red blue | . blue ."],
         "miss": ["blue red blue ; blue ; blue"]}  # fmt: skip


@pytest.mark.parametrize(
    ("texts", "meant"),
    [
        (("tower: red at the bottom, yellow, blue at the top", "red at the bottom, yellow, and blue on top",
          "tower red (bottom), yellow, blue (top)", "blue at the top, yellow, red at the bottom",
          "red, then yellow on it, then blue on that", "start with red, put yellow on it and blue on that one",
          "layer them red, yellow, blue from the bottom up",
          "a tower in layers: red, yellow, blue, from the bottom up"),
         TOWER),
        (("row: red on the left, yellow, blue on the right", "red on the left, yellow, blue on the right",
          "blue on the right, yellow, red on the left"), ROW),
        (("a row of three gray cubes, with a white cube on top of each end",
          "Make a row of three gray cubes and put a white block on each of its two end blocks",
          "Make a row of three gray blocks with a white block on top of the first and the last one",
          "A row of three gray blocks in which the two at the ends each have a white block on top",
          "Line up three gray blocks, the outer two each bearing a white one"), ON_ENDS),
        (("the red patch and the blue patch get one yellow block each", "red mat and blue mat each get a yellow block",
          "each of the two patches, the red one and the blue one, gets one yellow block",
          "two yellow cubes, two patches, red and blue: one cube on each"), ON_EACH),
        (("on each patch build a tower of blocks of its color: two red, two blue",
          "For each patch, stack the blocks of that color on it. There are two red and two blue blocks.",
          "For each of the colours red and blue, stack the two blocks of the colour on the mat of the same colour."),
         BY_COLOR),
        (("4 columns 2 rows, all black", "2 rows, 4 columns, all black", "4 columns and 2 rows, all black"), GRID),
        (("a blue tower of three and a red tower one block taller",
          "From three blue and four red blocks build a blue tower and a red tower that is one block higher",
          "a red tower of 4 and a blue tower that is one block shorter"), HIGHER),
        (("two purple cubes with a yellow one sandwiched in between",
          "a tower of two purple cubes with a yellow block sandwiched in the middle"), SANDWICH),
        (("put two 3s and a 5 in a row", "a 5 and two 3s in a row", "put 2 3s and a 5 in a row"), THREES),
        (("spell c-a-t", "the word C-A-T", "make it say cat", "i want it to say CAT"), CAT),
        (("Put one blue block to the left of the red block, one to its right, one in front of it and one behind it.",),
         SIDES),
        (("put the red one no wait the green one on the blue one",
          "put the green block on the red no sorry on the blue one",
          "drop the green block on the red one, no, on the blue one"),
         {"assets": {"green": 1, "blue": 1}, "hold": ["blue^green"], "miss": ["green^blue", "green blue"]}),
        (("stack red and green, no wait, red and blue",),
         {"assets": {"red": 1, "blue": 1}, "hold": ["red^blue"], "miss": ["red blue"]}),
        (("drop the brown block on the green one, no, on the yellow one and put a red one on it",),
         {"assets": {"brown": 1, "yellow": 1, "red": 1}, "hold": ["yellow^brown^red"], "miss": ["yellow^brown ; red"]}),
        (("put the purple block behind the orange one, directly behind it, not off to one side",),
         {"assets": {"purple": 1, "orange": 1}, "hold": ["purple | orange"], "miss": [". purple | orange ."]}),
        (("a tower of red and blue, nothing on top",),
         {"assets": {"red": 1, "blue": 1}, "hold": ["red^blue", "blue^red"], "miss": ["red blue"]}),
    ],
)  # fmt: skip
def test_everyday_words_are_read(texts: tuple[str, ...], meant: dict[str, Any]) -> None:
    for text in texts:
        assert_means(text, meant)


@pytest.mark.parametrize(
    "text",
    [
        "make a row of four blue blocks with a yellow block on top of the second and the third one",
        "make a row of four blue blocks. Put a yellow block behind the first and the last one.",
        "the red patch and the blue patch get one yellow block",
        "the red patch and the blue block get one yellow block each",
        "From three blue and five red blocks build a blue tower and a red tower that is one block taller",
        "a red tower of three and a blue tower and a green tower of the same height",
        "put red and green on the mat, no, blue and yellow",
        "put a red and a green block on the mat, sorry, a blue and a yellow one",
        "3s and 5s in separate piles",
        "From a settled heap of five blocks, three red and three blue, sort by colour.",
        "red behind blue, i.e. nearer to me",
        "stack red and blue on the mat, nothing on top",
    ],
)
def test_what_does_not_fit_is_refused(text: str) -> None:
    schema, diagnostics = BuiltinFrontEnd().read(text)
    assert schema is None
    assert diagnostics
