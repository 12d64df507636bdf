"""How people speak who think of no program: what it is read as, and what near it is not."""

from __future__ import annotations

from typing import Any

import pytest

from rpg.passes.schema.frontend import BuiltinFrontEnd
from tests.language.meaning import assert_means

Meant = dict[str, Any]
UP: Meant = {"assets": {"blue": 1, "red": 1, "white": 1}, "hold": ["blue^red^white"], "miss": ["white^red^blue"]}
EITHER: Meant = {"assets": {"red": 3, "blue": 3}, "hold": ["red^red^red", "blue^blue^blue"],
                 "miss": ["red^red ; blue^blue", "red red red"]}  # fmt: skip
TWINS: Meant = {"assets": {"red": 3, "blue": 3}, "hold": ["red^red^red . . blue^blue^blue"],
                "miss": ["blue^blue^blue . . red^red^red"]}  # fmt: skip
UNDONE: Meant = {"assets": {"red": 3}, "hold": [["red ; red#2 ; red#3", "red^red#2^red#3", "red ; red#2 ; red#3"]],
                 "miss": [["red ; red#2 ; red#3", "red^red#2^red#3"]]}  # fmt: skip
AROUND: Meant = {"assets": {"black": 1, "white": 4}, "hold": [[". white . | white black white | . white . pitch=1.25"]],
                 "miss": ["white white black white white"]}  # fmt: skip
ONE_BY_ONE: Meant = {
    "assets": {"red": 1, "blue": 1, "green": 1, "patch": 1},
    "hold": [["red ; blue ; green", "red at=patch", "red blue pitch=1 at=patch", "red blue green pitch=1 at=patch"]],
    "miss": [["red ; blue ; green", "blue at=patch", "red blue pitch=1 at=patch", "red blue green pitch=1 at=patch"]],
}
IN_A_ROW: Meant = {"assets": {"A": 1, "B": 1, "C": 1, "white_patch": 1}, "hold": ["A B C pitch=1 at=white_patch"],
                   "miss": ["A B C", "B A C pitch=1 at=white_patch"]}  # fmt: skip
DIAGONAL: Meant = {"assets": {"blue": 6, "yellow": 3}, "hold": ["yellow blue blue | blue yellow blue | blue blue "
"yellow"],
                   "miss": ["blue blue yellow | blue yellow blue | yellow blue blue"]}  # fmt: skip
UNLIKE: Meant = {"assets": {"red": 3, "black": 3}, "hold": ["red black red black red black"],
                 "miss": ["red red black black red black"]}  # fmt: skip
CHECKED: Meant = {"assets": {"black": 2, "white": 2}, "hold": ["white black | black white"],
                  "miss": ["black white | white black"]}  # fmt: skip
ROWS: Meant = {"assets": {"1": 1, "2": 1, "3": 1, "A": 1, "B": 1, "C": 1}, "hold": ["A B C | 1 2 3"],
               "miss": ["1 2 3 | A B C", "A C B | 1 2 3"]}  # fmt: skip
SIZES: Meant = {"assets": {"any{small}": 1, "any": 1, "any{big}": 1}, "hold": ["any{big}^any^any{small}"],
                "miss": ["any{small}^any^any{big}"]}  # fmt: skip
ENDS: Meant = {"assets": {"green": 3, "black": 2}, "hold": ["black green green green black"],
               "miss": ["black black green green green"]}  # fmt: skip
NOT_THE_REST: Meant = {"assets": {"black": 1, "white": 2, "yellow_patch": 1}, "hold": ["black at=yellow_patch"],
                       "miss": ["black white pitch=1 at=yellow_patch", "black ; white"]}  # fmt: skip
SIDES: Meant = {"assets": {"J": 1, "K": 1}, "hold": ["J K"], "miss": ["K J", "J ; K"]}
HALVES: Meant = {"assets": {"purple": 2}, "hold": [["purple at=0.5,3 ; purple at=2,3", "purple at=0.5,-3 ; purple "
"at=2,-3"]],
                 "miss": [["purple at=0.5,3 ; purple at=2,3", "purple at=0.5,-3 ; purple at=2,3"]]}  # fmt: skip
BY_COLOR: Meant = {
    "assets": {"red": 3, "blue": 2},
    "hold": ["red^red^red ; blue^blue"],
    "miss": ["red^red^blue ; blue^red"],
}
CLEARED: Meant = {"assets": {"plain": 2, "patch": 1}, "start": ["plain plain pitch=1 at=patch"],
                  "hold": ["plain ; plain#2"], "miss": ["plain at=patch"]}  # fmt: skip
TWO_PARTS: Meant = {"assets": {"A": 1, "B": 1, "C": 1, "white_patch": 1}, "hold": ["B^A ; C at=white_patch"],
                    "miss": ["B^A ; C", "C at=white_patch"]}  # fmt: skip
STEPS: Meant = {"assets": {"A": 1, "B": 1, "C": 1}, "hold": [["A ; B ; C", "B^A ; C", "B^A^C"]],
                "miss": [["A ; B ; C", "A^C ; B", "B^A^C"]]}  # fmt: skip
PAIRS: Meant = {"assets": {"red": 4, "blue": 4}, "hold": ["red red blue blue red red blue blue"],
                "miss": ["red blue red blue red blue red blue"]}  # fmt: skip


@pytest.mark.parametrize(
    ("text", "meant"),
    [
        ("Stack blue, red, white in that order, starting from the table.", UP),
        ("Build a tower of blue, red and white, beginning at the table and going up", UP),
        ("Starting from the table, stack blue, red and white", UP),
        ("a tower of blue, red and white from down to up", UP),
        ("we need either a tower of 3 red blocks or a tower of 3 blue blocks, doesn't matter which", EITHER),
        ("Build either a stack of three red cubes or a stack of three blue cubes", EITHER),
        ("Two towers of three, the red tower on the left, the blue one on the right", TWINS),
        ("Two stacks of three blocks: a blue stack on the right, a red one on the left", TWINS),
        ("Build a tower of three red blocks, then take it down again", UNDONE),
        ("build a tower of three red cubes. After that, pull it apart", UNDONE),
        ("In this order: first the red block goes on the mat, after that the blue block, and last the green "
         "one", ONE_BY_ONE),
        ("First red goes on the mat, then blue, finally green", ONE_BY_ONE),
        ("Acceptance criteria: (1) A, B and C form a row, (2) they are in alphabetical order, (3) the row is on the "
         "white "
         "patch", IN_A_ROW),
        ("A, B and C form a row. They are in alphabetical order. The row is on the white patch.", IN_A_ROW),
        ("A 3x3 grid of blue blocks, the main diagonal is yellow", DIAGONAL),
        ("A 3x3 grid of blue blocks with a yellow main diagonal", DIAGONAL),
        ("Two cubes of same color can never be neighbours in the row. Use three red and three black.", UNLIKE),
        ("The corner of a chess board: 2x2, black and white blocks alternating, black at the front left.", CHECKED),
        ("1, 2 and 3 in the front row and A, B, C in the row behind", ROWS),
        ("The biggest cube at the bottom, then the middle one, and the smallest on top", SIZES),
        ("Position a cube at each end of the row of three green blocks, both black", ENDS),
        ("Place a black cube at each end of a row of three green blocks", ENDS),
        ("Keep everything off the yellow mat but the black cube. There are two white cubes as well.", NOT_THE_REST),
        ("I only want one block on the yellow mat, the black one. There are two white blocks too.", NOT_THE_REST),
        ("J and K next to each other, J left", SIDES),
        ("J and K beside each other: K right", SIDES),
        ("Start: all on the left. Goal: all on the right. Two purple blocks.", HALVES),
        ("Make two towers by colour: 3 red and 2 blue blocks", BY_COLOR),
        ("The mat should be empty at the end. At the moment there are two cubes on it.", CLEARED),
        ("The mat should be empty at the end. There are two cubes on it now.", CLEARED),
        ("Acceptance criteria: 1. A is on B. 2. C is on the white patch.", TWO_PARTS),
        ("The goal has two parts: 1. A is on B. 2. C is on the white patch.", TWO_PARTS),
        ("Please do this: 1. put A on B. 2. put C on A.", STEPS),
        ("Make a line with the pattern AABB using red for A and blue for B, 8 blocks", PAIRS),
    ],
)  # fmt: skip
def test_plain_talk_is_read_as_it_is_meant(text: str, meant: Meant) -> None:
    assert_means(text, meant)


GROUP: Meant = {"assets": {"yellow": 5, "purple": 1}, "hold": ["yellow yellow yellow | yellow yellow purple"],
                "miss": ["yellow yellow yellow | yellow yellow ; purple"]}  # fmt: skip
STACKED: Meant = {"assets": {"red": 1, "blue": 1}, "hold": ["blue^red"], "miss": ["red^blue"]}
GRAYS: Meant = {"assets": {"gray": 9}, "hold": ["gray gray gray | gray gray gray | gray gray gray"],
                "miss": ["gray gray gray | gray gray gray | gray gray ; gray"]}  # fmt: skip
SPACED: Meant = {"assets": {"orange": 3}, "hold": ["orange orange orange"], "miss": ["orange orange . orange"]}
FOUR: Meant = {"assets": {"red": 1, "blue": 1, "green": 1, "yellow": 1}, "hold": ["red blue green yellow"],
               "miss": ["red blue green ; yellow"]}  # fmt: skip
VOWELS: Meant = {"assets": {"A": 1, "E": 1, "B": 1, "C": 1}, "hold": ["A^E"], "miss": ["B^C", "A E"]}
STAYS: Meant = {"assets": {"green": 1, "blue": 1}, "hold": [["blue ; green at=0,0", "blue at=1.5,0 ; green at=0,0"]],
                "miss": [["blue ; green at=2,0", "blue at=1.5,0 ; green at=0,0"]]}  # fmt: skip
NEAREST: Meant = {"assets": {"3": 1, "6": 1, "8": 1}, "hold": ["8 | 6 | 3"], "miss": ["3 | 6 | 8"]}
WORD: Meant = {"assets": {"T": 1, "O": 1, "M": 1}, "hold": ["T O M"], "miss": ["M O T"]}
ONLY: Meant = {"assets": {"green": 1, "white": 2, "red_patch": 1}, "hold": ["green at=red_patch"],
               "miss": ["green white pitch=1 at=red_patch"]}  # fmt: skip
LINED: Meant = {"assets": {"white": 4, "yellow": 1}, "hold": ["yellow . . . | white white white white"],
                "miss": ["yellow ; white white white white"]}  # fmt: skip
RING: Meant = {"assets": {"cyan": 8}, "hold": ["cyan* circle=2"], "miss": ["cyan*"]}


@pytest.mark.parametrize(
    ("text", "meant"),
    [
        ("a cluster of five yellow blocks with exactly one purple odd-one-out in it", GROUP),
        ("A group of five yellow blocks with one purple odd one out", GROUP),
        ("Put something red on something blue", STACKED),
        ("Station 3: red on blue", STACKED),
        ("Who can count to five? Put red on blue.", STACKED),
        ("i need something for my grasp planner: a 3x3 grid of gray cubes, nothing else on the table please", GRAYS),
        ("For the photo we want three orange cubes in a row, nicely spaced", SPACED),
        ("four blocks in a row, any colours but no two alike", FOUR),
        ("Stack all blocks that have a vowel on them: A, E, B, C", VOWELS),
        ("Nobody moves the green block! The blue one goes behind it.", STAYS),
        ("A column of the numbers 3, 6 and 8, smallest number nearest the robot", NEAREST),
        ("My son's name is Tom. Write TOM with the blocks, from left to right, so he can read it.", WORD),
        ("Reject station: only the green block goes on the red area, the two white ones must not be moved.", ONLY),
        ("Line up four white blocks like pawns and put one yellow block behind the first from the left", LINED),
        ("a circle of 8 cyan blocks, like the kids in our morning circle", RING),
    ],
)
def test_what_comes_with_it_is_read_or_left_out(text: str, meant: Meant) -> None:
    assert_means(text, meant)


@pytest.mark.parametrize(
    ("text", "code"),
    [
        ("either a row of 4 green cubes or a tower of 3 green cubes", "ambiguous"),
        (
            "build either a tower of 3 red blocks or a tower of 3 blue blocks and put the green block next to it",
            "ambiguous",
        ),
        ("Put the red block on the mat starting from the table", "incomplete"),
        ("a tower of red and blue blocks, like a stripy tower", "misplaced-word"),
        ("The A cube must have its B on top", "misplaced-word"),
        ("four letters in a row, no two the same", "misplaced-word"),
        ("In a row: 1. 2. 3.", "too-few"),
        ("two towers of three blocks, the red tower on the left mat, the blue one on the right mat", "ambiguous"),
        ("something red and blue", "incomplete"),
        ("a row of A, B, C from right to left in front of a row of 1, 2, 3 from left to right", "ambiguous"),
        ("a tower of A, B from the bottom to the top beside a tower of C, D from top to bottom", "ambiguous"),
    ],
)
def test_what_is_near_it_and_means_something_else_is_refused(text: str, code: str) -> None:
    schema, diagnostics = BuiltinFrontEnd().read(text)
    assert schema is None
    assert code in [d.code for d in diagnostics]


OPPOSED: Meant = {"assets": {"A": 1, "B": 1, "1": 1, "2": 1}, "hold": ["1 2 | B A"], "miss": ["2 1 | B A", "1 2 | A B"]}


@pytest.mark.parametrize(
    "text",
    [
        "A, B in the front row from right to left, and 1, 2 in the row behind from left to right",
        "Two rows: A, B in the front row from right to left, and 1, 2 in the back row from left to right",
        "a row of A, B from right to left and behind it a row of 1, 2 from left to right",
    ],
)
def test_each_row_goes_its_own_way(text: str) -> None:
    assert_means(text, OPPOSED)
