"""What is told last, of all that was told or of the last alone: gaps, towers, counts; what "them" is; which blocks the
start is made of; and what is no wish at all."""

from __future__ import annotations

from typing import Any

import pytest

from rpg.passes.schema.frontend import BuiltinFrontEnd
from tests.language.meaning import assert_means

_GAPS = {"assets": {"A": 1, "B": 1, "C": 1}, "hold": ["A B C pitch=1.5"],
         "miss": ["A B C pitch=1", "A B . . C pitch=1.5", "A . . B C pitch=1.5"]}  # fmt: skip
_TOUCH = {"assets": {"D": 1, "E": 1, "F": 1}, "hold": ["D E F pitch=1"],
          "miss": ["D . E F pitch=1", "D E . F pitch=1", "F E D pitch=1"]}  # fmt: skip
_EACH = {"assets": {"red": 3, "blue": 2, "red_patch": 1, "blue_patch": 1},
         "hold": ["red^red^red at=red_patch ; blue^blue at=blue_patch"],
         "miss": ["red red at=red_patch ; red ; blue^blue at=blue_patch",
                  "red^red^red at=red_patch ; blue ; blue"]}  # fmt: skip
_MOVED = {"assets": {"red": 1, "yellow": 1}, "start": ["yellow^red"], "start_miss": ["red^yellow", "red ; yellow"],
          "hold": [["yellow^red", "red ; yellow"]], "miss": [["yellow^red", "yellow^red"]]}  # fmt: skip
_BEHIND = {"assets": {"red": 1, "blue": 1, "green": 2},
           "hold": ["green^green . | red blue", ". green^green | red blue"],
           "miss": ["red blue | green^green .", "red . blue green^green"]}  # fmt: skip
_STOCK = {"assets": {"red": 3, "green": 1}, "start": ["red^red^red ; green"], "start_miss": ["red ; red ; red ; green"],
          "hold": [["red^red^red ; green", "red^red^green ; red"]],
          "miss": [["red^red^red ; green", "red^red ; red^green"]]}  # fmt: skip
_LOTS = {
    "assets": {"red": 3, "blue": 3},
    "hold": ["red^red^red ; blue^blue^blue"],
    "miss": ["red^blue^red ; blue^red^blue"],
}
_APART = {"assets": {"red": 2, "blue": 2}, "start": ["red^red ; blue^blue"], "start_miss": ["red^blue ; blue^red"],
          "hold": [["red^red ; blue^blue", "red ; red ; blue ; blue", "red^blue^red^blue"]],
          "miss": [["red^red ; blue^blue", "red ; red ; blue ; blue", "red^red^blue^blue"]]}  # fmt: skip


@pytest.mark.parametrize(
    ("text", "meant"),
    [
        *((text, _GAPS) for text in (
            "A left of B and B left of C with 2 cm between each", "A left of B, B left of C, with gaps of 2 cm",
            "A is left of B and B is left of C with 2 cm gaps between them",
            "Put A left of B and B left of C with 2 cm between each",
        )),
        *((text, _TOUCH) for text in (
            "D left of E, F right of E, no gaps", "D left of E, F right of E, without gaps",
            "Put D left of E and F right of E, no gaps",
        )),
        *((text, _EACH) for text in (
            "Put all the red blocks, there are three, on the red mat, and all the blue blocks, there are two, on the "
            "blue mat, each as a tower",
            "Put three red blocks on the red mat and two blue blocks on the blue mat, each as a tower",
            "Three red blocks on the red mat, two blue blocks on the blue mat, both as towers",
            "The three red blocks go on the red mat and the two blue ones on the blue mat, each as a tower",
            "put three red ones on the red mat and two blue ones on the blue mat, as towers",
            "put three red blocks and two blue blocks on the mats of their colors, each as a tower",
        )),
        *((text, _MOVED) for text in (
            "Move the red block from the yellow block to the table", "Bring the red block from the yellow one to the "
            "table.", "Put the red block from the yellow block on the table",
            "Take the red block from the yellow block and put it on the table",
        )),
        ("Move the red block from the yellow block to the left of the blue block",
         {"assets": {"red": 1, "yellow": 1, "blue": 1}, "start": ["yellow^red ; blue"],
          "hold": [["yellow^red ; blue", "red blue ; yellow"]],
          "miss": [["yellow^red ; blue", "yellow blue ; red"]]}),
        *((text, _BEHIND) for text in (
            "Put the red block to the left of the blue one and the tower of two greens behind them",
            "Put the red block to the left of the blue one. Put a tower of two green blocks behind them",
            "red left of blue and a tower of two greens behind them",
        )),
        *((text, _STOCK) for text in (
            "There are 3 red blocks and 1 green block. At the start, there is a tower from 3 red blocks. Build a tower "
            "from 2 red and 1 green",
            "There are three red blocks and a green block. There is a tower of three red blocks at the start. Build a "
            "tower of two red blocks and one green block.",
        )),
        ("There are four blue blocks. At the start, there is a row of three blue blocks. Build a tower of four blue "
         "blocks.", {"assets": {"blue": 4}, "hold": [["blue blue blue ; blue", "blue^blue^blue^blue"]], "miss": []}),
        ("There is a red block and a blue block. At the start, there is a tower of a red and a blue block. Take it "
         "apart.", {"assets": {"red": 1, "blue": 1}, "hold": [["red^blue", "red ; blue"]], "miss": [["red^blue"] * 2]}),
        ("There are 2 red blocks and a blue block. At the start there is a red block on the blue block. Put the other "
         "red block on it.", {"assets": {"red": 2, "blue": 1}, "start": ["blue^red ; red"],
                              "hold": [["blue^red#1 ; red#2", "blue^red#1^red#2"]], "miss": [["blue^red ; red"] * 2]}),
        ("There are 4 red blocks. Two of them are stacked. Build a tower of four.",
         {"assets": {"red": 4}, "start": ["red^red ; red ; red"], "start_miss": ["red ; red ; red ; red"],
          "hold": [["red^red ; red ; red", "red^red^red^red"]],
          "miss": [["red^red ; red ; red", "red^red^red ; red"]]}),
        *((text, {"assets": {"red": 1, "blue_patch": 1}, "hold": ["red at=blue_patch"], "miss": ["red"]}) for text in (
            "put the red block on a patch that is 15 cm wide and blue", "put the red block on a mat that is blue and "
            "round", "put the red block on a patch which is round and blue",
        )),
        ("put the red block on a patch that is round and blue on green",
         {"assets": {"red": 1, "blue": 1, "green": 1, "patch": 1}, "hold": ["red at=gray_patch ; green^blue"],
          "miss": ["red at=gray_patch ; blue ; green"]}),
        ("Red is next to blue but not touching it, and green is too",
         {"assets": {"red": 1, "blue": 1, "green": 1}, "hold": ["red blue green pitch=1.5"],
          "miss": ["red blue green pitch=1", "red blue . . green pitch=1.5"]}),
        ("Put red on a mat. Green must not be on a mat.",
         {"assets": {"red": 1, "green": 1, "patch": 1}, "hold": ["red at=gray_patch ; green"],
          "miss": ["red green at=gray_patch pitch=1"]}),
        ("There are three red blocks. There is another tower of two red blocks at the start. Build a tower of three "
         "red blocks.", {"assets": {"red": 5}, "hold": [], "miss": []}),
        *((text, _LOTS) for text in (
            "please do tower red, 3 block, and tower blue, 3 block", "tower red, three blocks, and tower blue, three "
            "blocks",
        )),
        ("a tower: red, three blocks", {"assets": {"red": 3}, "hold": ["red^red^red"], "miss": ["red^red ; red"]}),
        *((text, _APART) for text in (
            "Take apart the tower of two red and the tower of two blue and build one tower with alternating colors",
            "Disassemble the tower of two red blocks and the tower of two blue blocks and make one tower with "
            "alternating colors",
        )),
        ("Two towers of three blocks, the red one left of the blue one",
         {"assets": {"red": 3, "blue": 3}, "hold": ["red^red^red . blue^blue^blue"],
          "miss": ["blue^blue^blue . red^red^red", "red^blue^red . blue^red^blue"]}),
    ],
)  # fmt: skip
def test_what_is_meant_is_read(text: str, meant: dict[str, Any]) -> None:
    assert_means(text, meant)


@pytest.mark.parametrize(
    ("text", "code"),
    [
        ("A left of B and B left of C with 2 cm between them", "ambiguous"),
        ("A left of B, B left of C, with a gap of 2 cm", "ambiguous"),
        ("D is left of E, F is right of E, 6 cm apart", "ambiguous"),
        ("Red left of blue, green left of white, touching", "ambiguous"),
        ("Put red left of blue and green left of white, 5 cm apart", "ambiguous"),
        ("A next to B, C next to D, but not touching", "ambiguous"),
        ("A is left of B, which is left of C, with 2 cm between each", "ambiguous"),
        ("Put red on blue and green on white with a 5 cm gap between them", "ambiguous"),
        ("Put three red blocks on the red mat and three blue ones on the blue mat, as a tower", "ambiguous"),
        ("Put the three red blocks in a tower and the three blue blocks in a row, each on its patch", "ambiguous"),
        ("Put the red block on the blue one and the green block on the white one, both in the left half", "ambiguous"),
        ("Three red on the left and two blue on the right, each in a row.", "ambiguous"),
        ("Put two red blocks on the red mat and two blue blocks on the blue mat, touching each other", "ambiguous"),
        ("Put two red blocks on the red mat and two blue blocks on the blue mat, not stacked", "ambiguous"),
        ("Put the red block on a mat and the blue block on a mat, each with a green block on top", "ambiguous"),
        ("Build two towers of two blocks each. Put the red one on the mat.", "ambiguous"),
        ("tower red, blue, 3 blocks", "ambiguous"),
        ("a tower of red and 3 blocks", "misplaced"),
        ("Put a tower of two red blocks left of the blue block and a tower of two white ones behind them", "ambiguous"),
        ("a tower of three red blocks and a blue block next to it, or a green one", "ambiguous"),
        ("Put a blue block next to the red one, or a green one", "ambiguous"),
        ("There are two red blocks. At the start there is a tower of three red blocks. Build a row of two red blocks.",
         "count-mismatch"),
        ("There are 3 red blocks. Build a tower of 3 red blocks and a tower of 2 red blocks.", "count-mismatch"),
        ("There are 3 red blocks. First build a tower of 3 red blocks, then a row of 3 red blocks", "count-mismatch"),
        ("Take the tower of two red blocks and the tower of two blue blocks and build one tower", "ambiguous"),
        ("It was like this: red on blue", "no-goal"),
        ("It looked like this: red on blue. Now put green on red.", "no-goal"),
        ("Is this so: red on blue", "no-goal"),
        ("Is it true that red is on blue", "no-goal"),
    ],
)  # fmt: skip
def test_what_may_be_told_of_another_is_asked(text: str, code: str) -> None:
    schema, diagnostics = BuiltinFrontEnd().read(text)
    assert schema is None
    assert [d.code for d in diagnostics if d.severity == "error"] == [code]


@pytest.mark.parametrize(
    "text",
    ["It is like this: red on blue", "Is it possible: put red on blue?", "Put red on blue, or on green",
     "Put the red and the blue block on the table, each next to a white block",
     "Put red left of blue, 6 cm apart, and green left of white", "A left of B and C left of D touching each other",
     "Put three red blocks on the mat and six blue blocks on the table in towers of two",
     "two towers, one red, one blue, two blocks each. The red one stands to the left of the blue one.",
     "Build a tower of two red blocks. Put a green block next to them.",
     "There are two red blocks and a mat. Put a red block on the mat and a red block on the table."],
)  # fmt: skip
def test_what_is_told_plainly_is_read(text: str) -> None:
    schema, diagnostics = BuiltinFrontEnd().read(text)
    assert schema is not None, diagnostics
