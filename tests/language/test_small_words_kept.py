"""Small words and signs that change what is meant, wherever they stand: bounds behind a number, parts of a number, ways
along a line, views, when something is so, and what must not be."""

from __future__ import annotations

from typing import Any

import pytest

from rpg.passes.schema.frontend import BuiltinFrontEnd
from tests.language.meaning import assert_means

FOUR = {"red": 4, "blue_patch": 1}
TWO_OR_MORE = {"assets": FOUR, "hold": ["red red at=blue_patch ; red ; red", "red red red at=blue_patch ; red"],
               "miss": ["red at=blue_patch ; red ; red ; red"]}  # fmt: skip
JUST_TWO = {"assets": FOUR, "hold": ["red red at=blue_patch ; red ; red"],
            "miss": ["red at=blue_patch ; red ; red ; red", "red red red at=blue_patch ; red"]}  # fmt: skip
THREE_COLORS = {"red": 1, "green": 1, "blue": 1}
UPWARDS = {"assets": THREE_COLORS, "hold": ["red^green^blue"], "miss": ["blue^green^red", "green^red^blue"]}
DOWNWARDS = {"assets": THREE_COLORS, "hold": ["blue^green^red"], "miss": ["red^green^blue", "green^red^blue"]}
ROW = {"assets": {"A": 1, "B": 1, "C": 1}, "hold": ["A B C"], "miss": ["C B A", "B A C"]}
MOVED = {"assets": {"red": 1, "green": 1, "blue_patch": 1}, "hold": [["red at=blue_patch ; green", "green^red"]],
         "miss": [["red at=blue_patch ; green", "red at=blue_patch ; green"]],
         "start": ["red at=blue_patch ; green"], "start_miss": ["red ; green"]}  # fmt: skip


@pytest.mark.parametrize(
    ("text", "meant"),
    [
        ("Put two of the four red blocks at least on the blue mat.", TWO_OR_MORE),
        ("Put ≥2 of the 4 red blocks on the blue mat.", TWO_OR_MORE),
        ("Put 2+ of the 4 red blocks on the blue mat.", TWO_OR_MORE),
        ("Over one of the four red blocks must be on the blue mat.", TWO_OR_MORE),
        ("Put over one of the four red blocks on the blue mat.", TWO_OR_MORE),
        ("Put no more and no fewer than two of the four red blocks on the blue mat.", JUST_TWO),
        ("Put 1/2 of the four red blocks on the blue mat.", JUST_TWO),
        ("Put a couple of the four red blocks on the blue mat.", JUST_TWO),
        ("Put 3/4 of the four red blocks on the blue mat.",
         {"assets": FOUR, "hold": ["red red red at=blue_patch ; red"],
          "miss": ["red red at=blue_patch ; red ; red", "red*"]}),
        ("Make a row of two pieces of red block and a yellow block.",
         {"assets": {"red": 2, "yellow": 1}, "hold": ["red red yellow"], "miss": ["red yellow ; red"]}),
        ("Make a row of 2 pcs red blocks and a yellow block.",
         {"assets": {"red": 2, "yellow": 1}, "hold": ["red red yellow"], "miss": ["red yellow ; red"]}),
        ("Build a tower from above: red, green, blue.", DOWNWARDS),
        ("Stack the red, green and blue blocks from above.", DOWNWARDS),
        ("Stack the red, green and blue blocks from below.", UPWARDS),
        ("Stack the red, green and blue blocks in order from bottom to top.", UPWARDS),
        ("Stack red, green and blue, working your way up.", UPWARDS),
        ("Line up the letters A, B and C L to R.", ROW),
        ("A row, L-R: A, B, C", ROW),
        ("Line up A, B and C rightwards.", ROW),
        ("Line up A, B and C starting with the leftmost.", ROW),
        ("The red block has been placed on the blue mat. Move it onto the green block.", MOVED),
        ("Situation: the red block is on the blue mat. Move it onto the green block.", MOVED),
        ("Move the red block onto the green block. Precondition: the red block is on the blue mat.", MOVED),
        ("Imagine that the red block is on the blue mat. Move it onto the green block.", MOVED),
        ("The red block at t=0 is on the blue mat. Move it onto the green block.", MOVED),
        ("First stack the two red blocks, then unstack them.",
         {"assets": {"red": 2}, "hold": [["red ; red", "red^red", "red ; red"]],
          "miss": [["red ; red", "red ; red"], ["red ; red", "red^red"]],
          "start": ["red ; red"]}),
        ("Put the red block left of the blue block, but it is not allowed to touch it.",
         {"assets": {"red": 1, "blue": 1}, "hold": ["red . blue"], "miss": ["red(0,-0.25) blue", "blue . red"]}),
    ],
)  # fmt: skip
def test_small_words_are_kept(text: str, meant: dict[str, Any]) -> None:
    assert_means(text, meant)


@pytest.mark.parametrize(
    "text",
    [
        "Put 2/4 red blocks on the mat.",
        "Stack the blocks 1, 2 and 3 from lowest to highest.",
        "Stack A, B and C from the highest to the lowest.",
        "I want the two red blocks away from me.",
        "Put the red block back left.",
        "Rotate A by -90 degrees.",
        "In the end ≠ 2 of the 4 red blocks are on the blue mat.",
        "Put the red block on the mat without contact with the blue block.",
    ],
)
def test_what_they_leave_open_is_refused(text: str) -> None:
    assert BuiltinFrontEnd().read(text)[0] is None
