"""Of what something is said: a part or the whole, one of a list or all, a block or the figure that it is in."""

from __future__ import annotations

from typing import Any

import pytest

from rpg.ir.relations import Facing
from rpg.ir.walk import atoms
from rpg.passes.schema.frontend import BuiltinFrontEnd
from tests.language.meaning import assert_means

ASKED = {
    "ambiguous": (
        # more than its colour is told of a part
        "Put four blocks in a row, the outer two red, the inner two blue and touching.",
        "Put four blocks in a row, the first two red and touching, the last two blue.",
        "Four blocks in a row. The first two are red and touching, the last two are blue.",
        "Two towers of three, the left one red and on the mat, the right one blue.",
        "Three blocks in a row. The middle one is red and turned by 45 degrees, the others are blue.",
        "A row of three blocks, the middle one red, in the middle of the table, the others blue.",
        "Stack three red and two blue blocks, the blue ones on top and turned by 45 degrees.",
        "Four blocks in a row, two red, touching, two blue.",
        "A row of three blocks, the middle one red and big, the others blue.",
        # a part of several blocks is no single block
        "A row of four blocks, the left ones red, the right ones blue.",
        "A tower of three blocks, the top blocks blue, the rest red.",
        "A staircase of three steps, the top blocks blue, the rest red.",
        "A row of five blocks, the first ones red, the last one blue.",
        "A row of five red blocks with a blue block on every second one.",
        # one of those that were counted, or a further one
        "A stack of five blocks, alternating red and blue, with the bottom one green.",
        "A stack of three red and two blue blocks, the top one green.",
        "Stack four blocks, red and blue alternating, but the top one is white.",
        # a block, or what was named before
        "Two red towers of three with a blue one between them.",
        "A red tower of three. Put a blue one next to it.",
        "A red tower of five and a blue one.",
        "Stack three blocks. Make another one behind it.",
        "Put the red block on the blue block. It is a small block.",
        "Put the red block on the mat. It is a green block.",
        "Put two red blocks and a blue block on the mat. The first one is green.",
        # told at the end of two
        "Stack red on blue and green on yellow, turned by 45 degrees.",
        "Stack red on blue and green on yellow, touching.",
        "A red block, a blue block on the mat and a green block on the table.",
        "A red block with a blue block on the left and a green one on the right, all on the mat.",
        "A red tower of three with a blue block on top and a green block on either side, touching.",
        "Place four red blocks in a square, 2 cm between them, with a blue one in the middle.",
        "Build a tower of three red blocks, with a yellow block on each.",
        "Put a red block on a blue block, and a green block on a yellow block next to it.",
        "Put A on B and C on D, 10 cm from the mat.",
        "Put red on blue and green on yellow, next to the mat.",
        "Stack A on B and C on D, behind the mat.",
        # the middle of the table, of a patch or of what lies there
        "Put four red blocks on the mat, touching, with a blue one in the middle.",
        "Put six red blocks on the mat, a blue one in the middle.",
        "Put A and B on the mat, C in the middle.",
        # each of several, or all of them together
        "Put red, blue and green on the mat and yellow next to them.",
        "Red and blue are on the mat. Put yellow beside them.",
        "There are 5 blocks and two patches. All of them are on one of the patches.",
        "All red blocks must be on one of the two mats.",
        # a tower like the one before it, or a block; the ends of what is there
        "Leave the red tower as it is and put a yellow block on top of the blue one.",
        "Don't touch the red tower. Put the green block on the blue one.",
        "There is a tower of A, B and C. C should be on top and A at the bottom.",
        "There is a row of red, green and blue. Red should be on the left and blue on the right.",
        # blocks below letters, or those that show them
        "The word CAT on red blocks",
        "Spell CAT on the red blocks.",
        "Spell DOG on a row of blue blocks.",
        # a big block of the same colour, or of any; the first of a row, or in front of it
        "Put a small red block on a big one.",
        "Put the blue block at the front of the row of red, green and white.",
        # it: the block spoken of before, or nobody
        "Put red on the mat. It is not allowed to touch the blue block.",
        # before an order, or after it
        "Swap red and blue, the red one is on the mat.",
        "Put the red block on the mat. It is on the blue block.",
        "Put A on B. A is on C.",
        "The red block is wedged under two blue ones. Put it on the mat.",
        # told of all
        "Put A on B and C on D, both red.",
        "Put A on B and C on D, all upside down.",
        "Make a row of two red and two blue blocks, all blue.",
    ),
    "contradiction": (
        "Put the red block between the blue and the green one, none of them red.",
        "A row of three red blocks, each of a different color.",
        "Put red and blue on the mat. Stack them with green in between.",
    ),
    "no-goal": (
        "Initially C is on A and B is on the table.",
        "At first red is on blue, and green is on the mat.",
        "In the beginning, red is on blue and green on the mat.",
        "There is a tower of red, blue and green. Put a green one on top.",
        "Put two red blocks and a blue block on the mat. Use only red blocks.",
    ),
    "between-two": ("There is a tower of red, blue and green. Put a yellow one between them.",),
    "misplaced": ("Build two towers of three blocks, one red and one blue, but not the blue one.",),
    "misplaced-word": (
        # brackets that tell which block it is, or where it is
        "Put the red block (the big one) on the blue block.",
        "Put the red block on the blue block (the second one).",
        "Put the red block on the blue one (the smallest).",
        "A red block, a blue block (on the mat), and a green block (on the blue one).",
        "A red block (left of the blue one) and a green block.",
    ),
    "no-referent": (
        "Make a row of four blocks. The others are white.",
        "First red, then blue, then green go on the mat, in a row.",
    ),
}  # fmt: skip


@pytest.mark.parametrize(("text", "code"), [(text, code) for code, texts in ASKED.items() for text in texts])
def test_what_could_be_said_of_something_else_is_asked(text: str, code: str) -> None:
    schema, diagnostics = BuiltinFrontEnd().read(text)
    assert schema is None
    assert [d.code for d in diagnostics if d.severity == "error"] == [code]


@pytest.mark.parametrize(
    "text",
    ["Put three red blocks in a row, all upside down.", "Stack the red block on the blue one, both upside down."],
)
def test_no_letters_are_made_up_to_be_turned(text: str) -> None:
    assert BuiltinFrontEnd().read(text)[0] is None


APART: dict[str, Any] = {
    "assets": {"red": 1, "white": 1},
    "hold": ["white red pitch=1.5"],
    "miss": ["red white pitch=1.5", "white red pitch=1.1", "white . red"],
}
SWAPPED: dict[str, Any] = {
    "assets": {"red": 1, "blue": 1},
    "hold": [["red blue", "blue red"]],
    "miss": [["red blue", "red blue"]],
    "start_miss": ["red . . . blue"],
}
TO_THE_TABLE: dict[str, Any] = {
    "assets": {"red": 1, "patch": 1},
    "hold": [["red at=patch", "red at=patch+0,5"]],
    "miss": [["red at=patch", "red at=patch"]],
    "start_miss": ["red"],
}
STACKED_BESIDE: dict[str, Any] = {
    "assets": {"red": 1, "blue": 1, "green": 1, "yellow": 1},
    "hold": ["red^blue^green yellow", "yellow green^red^blue"],
    "miss": ["red^blue^green ; yellow", "red blue green yellow"],
}
RED_FROM_MAT: dict[str, Any] = {
    "assets": {"red": 1, "blue": 1, "patch": 1},
    "hold": [["red at=patch ; blue", "blue^red"]],
    "miss": [["red at=patch ; blue", "red at=patch ; blue"]],
    "start_miss": ["red ; blue"],
}
IN_TURN: dict[str, Any] = {
    "assets": {"red": 1, "blue": 1, "green": 1, "patch": 1},
    "hold": ["red^blue^green at=patch"],
    "miss": ["green^blue^red at=patch", "red blue green pitch=1 at=patch"],
}


@pytest.mark.parametrize(
    ("text", "meant"),
    [
        ("Stack red, blue and green and put a yellow block next to it.", STACKED_BESIDE),
        ("Put red, blue and green in a tower. Put a yellow block next to it.", STACKED_BESIDE),
        ("Put red, blue and green in a row, and a yellow block next to it.",
         {"assets": {"red": 1, "blue": 1, "green": 1, "yellow": 1}, "hold": ["red blue green | . yellow ."],
          "miss": ["red blue green ; yellow", "red^blue^green yellow"]}),
        ("The red block, which is on the mat, belongs on the blue one.", RED_FROM_MAT),
        ("The red block, which is on the mat, should be on the blue one.", RED_FROM_MAT),
        ("Put red on blue without moving green, which is on yellow.",
         {"assets": {"red": 1, "blue": 1, "green": 1, "yellow": 1}, "start_miss": ["red ; blue ; yellow ; green"],
          "hold": [["red at=0,-3 ; blue at=0,0 ; yellow^green at=0,3", "blue^red at=0,0 ; yellow^green at=0,3"]]}),
        ("Put red on blue and leave green, which is on yellow, where it is.",
         {"assets": {"red": 1, "blue": 1, "green": 1, "yellow": 1}, "start_miss": ["red ; blue ; yellow ; green"]}),
        ("First red, then blue, then green go on the mat, on top of each other.", IN_TURN),
        ("Put red, then blue, then green on top of each other on the mat.", IN_TURN),
        ("Put red, then blue, then green on top of each other.",
         {"assets": {"red": 1, "blue": 1, "green": 1}, "hold": ["red^blue^green"], "miss": ["blue^red^green"]}),
        ("There is a tower of three red blocks. Replace the top one with a blue one.",
         {"assets": {"red": 3, "blue": 1}, "hold": [["red^red^red ; blue", "red^red^blue"]],
          "miss": [["red^red^red ; blue", "red^blue^red"]]}),
        ("Put each of two red blocks on a blue one, one after the other.",
         {"assets": {"red": 2, "blue": 2},
          "hold": [["red ; red ; blue ; blue", "blue^red ; red ; blue", "blue^red ; blue^red"]],
          "miss": [["red ; red ; blue ; blue", "blue^red ; red ; blue", "blue^red^red ; blue"]]}),
        ("A red block (on the mat) and a blue block (on the table).",
         {"assets": {"red": 1, "blue": 1, "patch": 1}, "hold": ["red at=patch ; blue"],
          "miss": ["blue at=patch ; red"]}),
        ("Stack red, blue and green (on the mat).",
         {"assets": {"red": 1, "blue": 1, "green": 1, "patch": 1}, "hold": ["red^blue^green at=patch"],
          "miss": ["red^blue^green"]}),
        ("Two towers of three, the left one red and on the red mat, the right one blue and on the blue mat.",
         {"assets": {"red": 3, "blue": 3, "red_patch": 1, "blue_patch": 1}}),
        ("Make a row of two red and two blue blocks, all 5 cm wide.",
         {"assets": {"red{5}": 2, "blue{5}": 2}, "hold": ["red{5} red{5} blue{5} blue{5}"]}),
        ("A wall of two layers of three, the top blocks blue, the rest red.",
         {"assets": {"red": 3, "blue": 3}, "hold": ["red^blue red^blue red^blue pitch=1"],
          "miss": ["blue^red blue^red blue^red pitch=1"]}),
        ("Make a line of five blue blocks and put a red block on top of the first and last.",
         {"assets": {"blue": 5, "red": 2}, "hold": ["blue^red blue blue blue blue^red"],
          "miss": ["blue^red blue^red blue blue blue", "blue blue blue blue blue^red"]}),
        ("A row of three blocks, the middle one red, the others blue, touching.",
         {"assets": {"red": 1, "blue": 2}, "hold": ["blue red blue pitch=1"], "miss": ["blue red blue"]}),
        ("There is a tower of A, B and C. Put a D on top.",
         {"assets": {"A": 1, "B": 1, "C": 1, "D": 1}, "hold": [["A^B^C ; D", "A^B^C^D"]],
          "miss": [["A^B^C ; D", "A^B^D ; C"]]}),
        ("Red is right of white. The gap must be 2 cm.", APART),
        ("Red is to the right of white. There should be 2 cm between them.", APART),
        ("Red stands right of white, and the gap must be 2 cm.", APART),
        ("Swap red and blue, they are standing next to each other.", SWAPPED),
        ("Swap red and blue. They are next to each other.", SWAPPED),
        ("Put red on the table, it is on the mat.", TO_THE_TABLE),
        ("Move the red block to the table. It is on the mat.", TO_THE_TABLE),
        ("Move red to the mat. It is now on the table.",
         {"assets": {"red": 1, "patch": 1}, "hold": [["red", "red at=patch"]], "start": ["red"]}),
        ("Put red on the mat. It is next to blue.",
         {"assets": {"red": 1, "blue": 1, "patch": 1}, "hold": ["red blue pitch=1 at=patch"],
          "miss": ["red at=patch ; blue"]}),
        ("Initially C is on A and B is on the table. Put A on B.",
         {"assets": {"A": 1, "B": 1, "C": 1}, "start": ["A^C ; B"], "start_miss": ["A ; C ; B"], "hold": ["B^A ; C"]}),
        ("Red starts on top of blue, and I want blue on top of red.",
         {"assets": {"red": 1, "blue": 1}, "start": ["blue^red"], "start_miss": ["red ; blue"], "hold": ["red^blue"],
          "miss": ["blue^red"]}),
        ("Write CAT on red cubes.",
         {"assets": {"red:C": 1, "red:A": 1, "red:T": 1}, "hold": ["red:C red:A red:T"],
          "miss": ["red:T red:A red:C"]}),
        ("Put red and blue on the mat and keep them next to each other.",
         {"assets": {"red": 1, "blue": 1, "patch": 1}, "hold": ["red blue pitch=1 at=patch"],
          "miss": ["red . blue at=patch", "red blue"], "start": ["red ; blue"]}),
        ("Put red on the mat and keep blue next to green.",
         {"assets": {"red": 1, "blue": 1, "green": 1, "patch": 1}, "start_miss": ["red ; blue ; green"]}),
        ("Below the red block is a blue one and below that a green one.",
         {"assets": {"red": 1, "blue": 1, "green": 1}, "hold": ["green^blue^red"], "miss": ["blue^green^red"]}),
        ("On the red block is a blue one and on that a green one.",
         {"assets": {"red": 1, "blue": 1, "green": 1}, "hold": ["red^blue^green"], "miss": ["red^green^blue"]}),
        ("Put all blocks on one of the patches.",
         {"assets": {"plain": 3, "patch": 2}}),
        ("Put A, B and C in a row, all upside down.",
         {"assets": {"A": 1, "B": 1, "C": 1}, "hold": ["A~180 B~180 C~180"], "miss": ["A B C"]}),
    ],
)  # fmt: skip
def test_what_is_said_of_it(text: str, meant: dict[str, Any]) -> None:
    assert_means(text, meant)


@pytest.mark.parametrize(
    ("text", "ways"),
    [
        ("A faces left and B right.", {"A_block": "left", "B_block": "right"}),
        ("Put A and B side by side, A facing left and B right.", {"A_block": "left", "B_block": "right"}),
        ("The A faces left, the B right.", {"A_block": "left", "B_block": "right"}),
        ("A faces left and B is on the right.", {"A_block": "left"}),
        ("A faces left and B in the right half.", {"A_block": "left"}),
    ],
)
def test_which_way_the_next_one_faces(text: str, ways: dict[str, str]) -> None:
    schema, _ = BuiltinFrontEnd().read(text)
    assert schema is not None
    assert {x.block: x.toward for x in atoms(schema.goal) if isinstance(x, Facing)} == ways
