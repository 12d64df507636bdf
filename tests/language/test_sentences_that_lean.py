"""Short sentences that lean on one another: one of two and the other, how it starts and how it ends, what there is told
behind, what stays, and what was said before told again."""

from __future__ import annotations

from typing import Any

import pytest

from rpg.passes.schema.frontend import BuiltinFrontEnd
from tests.language.meaning import assert_means

Meant = dict[str, Any]

ON_ONE: Meant = {"assets": {"A": 1, "B": 1, "patch": 1}, "hold": ["A at=patch ; B", "B at=patch ; A"],
                 "miss": ["A ; B", "A B pitch=1 at=patch"]}  # fmt: skip
LEFT_OVER: Meant = {"assets": {"yellow": 5}, "hold": ["yellow^yellow^yellow^yellow yellow"],
                    "miss": ["yellow yellow^yellow^yellow^yellow", "yellow^yellow^yellow^yellow^yellow"]}  # fmt: skip
NOT_GREEN: Meant = {"assets": {"red": 3, "green": 1, "white_patch": 1},
                    "hold": ["red red red pitch=1 at=white_patch ; green"],
                    "miss": ["red red pitch=1 at=white_patch ; red ; green",
                             "red red | red green pitch=1 at=white_patch"]}  # fmt: skip
TWO_EACH: Meant = {"assets": {"red": 4, "blue_patch": 1, "white_patch": 1},
                   "hold": ["red red pitch=1 at=blue_patch ; red red pitch=1 at=white_patch"],
                   "miss": ["red red red pitch=1 at=blue_patch ; red at=white_patch",
                            "red red pitch=1 at=blue_patch"]}  # fmt: skip
OFF_THE_TOP: Meant = {"assets": {"white": 3}, "start": ["white^white^white"], "start_miss": ["white^white ; white"],
                      "hold": ["white^white ; white"], "miss": ["white^white^white"]}  # fmt: skip
BACKWARDS: Meant = {"assets": {"P": 1, "O": 1, "T": 1}, "start": ["P O T pitch=1"], "start_miss": ["T O P pitch=1"],
                    "hold": ["T O P pitch=1"], "miss": ["P O T pitch=1"]}  # fmt: skip
STEPS: Meant = {"assets": {"A": 1, "B": 1, "C": 1}, "hold": [["A ; B ; C", "C^B ; A", "C^B^A"]],
                "miss": [["A ; B ; C", "B^A ; C", "C^B^A"], "B^A ; C"]}  # fmt: skip
SWAPPED_SIDES: Meant = {"assets": {"red": 1, "blue": 1}, "start": ["red at=0,4 ; blue at=0,-4"],
                        "start_miss": ["blue at=0,4 ; red at=0,-4"], "hold": ["blue at=0,4 ; red at=0,-4"],
                        "miss": ["red at=0,4 ; blue at=0,-4"]}  # fmt: skip


@pytest.mark.parametrize("text", [
    "Put one of A and B on the mat. The other must not be on the mat.",
    "Put exactly one of the blocks A and B on the mat, the other is not on the mat.",
    "There is an A block and a B block. One of them must be on the mat; the other one must not be on it.",
    "A or B goes on the mat. The other must not be on the mat.",
    "One of the two letters A and B is on the mat and the other is not on the mat.",
])  # fmt: skip
def test_one_of_two_and_the_other(text: str) -> None:
    assert_means(text, ON_ONE)


KEPT: Meant = {
    "assets": {"red": 1, "blue": 1, "green": 1},
    "hold": [["red at=0,4 ; blue at=0,0 ; green at=0,-4", "blue at=0,0 ; green^red at=0,-4"],
             ["red at=0,4 ; blue at=0,0 ; green at=0,-4", "red at=0,4 ; green^blue at=0,-4"]],
    "miss": [["red at=0,4 ; blue at=0,0 ; green at=0,-4", "blue at=0,3 ; green^red at=0,-4"]],
}  # fmt: skip
BY_COLOR: Meant = {"assets": {"yellow": 1, "green": 1, "red_patch": 1, "blue_patch": 1},
                   "hold": ["yellow at=red_patch ; green at=blue_patch", "green at=red_patch ; yellow at=blue_patch"],
                   "miss": ["yellow green pitch=1 at=red_patch", "yellow at=red_patch ; green"]}  # fmt: skip


@pytest.mark.parametrize(
    ("text", "meant"),
    [
        ("Move either the red or the blue block onto the green one. The other one stays where it is.", KEPT),
        ("Put one of the red and the blue block on the green block, and leave the other where it is.", KEPT),
        ("Put the yellow block on the red or the blue mat and the green block on the other mat.", BY_COLOR),
        ("There is a red patch and a blue patch. Put the yellow block on one of them and the green block on the other "
         "one.", BY_COLOR),
        ("There is a yellow and a green block. One should be on the red patch. The other should be on the blue patch.",
         BY_COLOR),
        ("Turn one of the letters K and F upside down and leave the other upright.",
         {"assets": {"K": 1, "F": 1}, "hold": ["K~180 ; F", "K ; F~180"], "miss": ["K ; F", "K~180 ; F~180"]}),
        ("There is a white mat and a black mat. Put a red block on one of the mats and a blue one on the other.",
         {"assets": {"red": 1, "blue": 1, "white_patch": 1, "black_patch": 1},
          "hold": ["red at=white_patch ; blue at=black_patch", "blue at=white_patch ; red at=black_patch"],
          "miss": ["red blue pitch=1 at=white_patch"]}),
        ("Either turn K upside down and leave F where it is, or turn F upside down and leave K where it is.",
         {"assets": {"K": 1, "F": 1}, "hold": [["K at=0,3 ; F at=0,-3", "K~180 at=0,3 ; F at=0,-3"],
                                               ["K at=0,3 ; F at=0,-3", "K at=0,3 ; F~180 at=0,-3"]],
          "miss": [["K at=0,3 ; F at=0,-3", "K~180 at=0,3 ; F at=0,-5"]]}),
    ],
)  # fmt: skip
def test_both_ways_are_told_in_full(text: str, meant: Meant) -> None:
    assert_means(text, meant)


@pytest.mark.parametrize(
    ("text", "meant"),
    [
        *((text, NOT_GREEN) for text in (
            "put all of them on the white mat apart from the green one. 3 reds and 1 green.",
            "There are three red blocks and a green one. All of them go on the white mat, apart from the green one.",
            "Put all the blocks on the white mat except the green one, there are three red blocks and a green one.")),
        *((text, {"assets": {"orange": 3, "black": 1}, "hold": ["orange orange orange at=0,3 ; black at=0,-3"],
                  "miss": ["orange orange orange at=0,-3 ; black at=0,3", "orange orange orange black at=0,3"]})
          for text in ("Everything goes on the left side of the table except for the black block, there are three "
                       "orange ones and a black one.",
                       "Put everything in the left half of the table except the black one. 3 orange blocks and 1 "
                       "black.")),
        ("There are a red, a blue and a green patch. Put the red block on any patch but the red one.",
         {"assets": {"red": 1, "red_patch": 1, "blue_patch": 1, "green_patch": 1},
          "hold": ["red at=blue_patch", "red at=green_patch"], "miss": ["red at=red_patch", "red"]}),
        ("Put the digits 1 to 5 in a row in order from left to right, except for the 3. It goes in front of the 5.",
         {"assets": dict.fromkeys("12345", 1), "hold": ["1 2 4 5 | . . . . | . . . 3"],
          "miss": ["1 2 3 4 5", ". . . 3 | . . . . | 1 2 4 5"]}),
        ("Put the letters A to D but C in a row from left to right.",
         {"assets": {"A": 1, "B": 1, "D": 1}, "hold": ["A B D"], "miss": ["B A D"]}),
        ("A yellow, a blue and a green block start on the red patch. Take them all off except the yellow one.",
         {"assets": {"yellow": 1, "blue": 1, "green": 1, "red_patch": 1},
          "start": ["yellow blue | green pitch=1 at=red_patch"], "hold": ["yellow at=red_patch ; blue ; green"],
          "miss": ["blue at=red_patch ; yellow ; green", "yellow ; blue ; green"]}),
        ("There are two red blocks and a blue one on the mat. Get rid of the blue one.",
         {"assets": {"red": 2, "blue": 1, "patch": 1}, "start": ["red red | blue pitch=1 at=patch"],
          "hold": ["red red pitch=1 at=patch ; blue"], "miss": ["red red | blue pitch=1 at=patch"]}),
        *((text, {"assets": {"blue": 2, "red": 1, "patch": 1},
                  "hold": [["blue at=0,3 ; blue at=0,6 ; red at=0,-3", "blue at=0,3 ; blue at=0,6 ; red at=patch"]],
                  "miss": [["blue at=0,3 ; blue at=0,6 ; red at=0,-3", "blue at=0,3 ; blue at=0,5 ; red at=patch"]]})
          for text in ("All the blocks stay where they are, only the red one moves onto the mat. There are two blue "
                       "ones and a red one.",
                       "There are two blue blocks and a red one. All stay put, just the red one goes on the mat.")),
    ],
)  # fmt: skip
def test_exceptions_that_are_told_last(text: str, meant: Meant) -> None:
    assert_means(text, meant)


@pytest.mark.parametrize(
    ("text", "meant"),
    [
        *((text, SWAPPED_SIDES) for text in (
            "The red block is on the left and the blue one on the right at the start. At the end it is the other way "
            "round.",
            "At the start the red block is on the left and the blue one on the right. At the end it should be the "
            "other way around.")),
        ("At the start red is on blue and blue is on green. At the end it should be the other way round.",
         {"assets": {"red": 1, "blue": 1, "green": 1}, "start": ["green^blue^red"], "start_miss": ["red^blue^green"],
          "hold": ["red^blue^green"], "miss": ["green^blue^red", "red^blue ; green"]}),
        *((text, BACKWARDS) for text in (
            "At the start the blocks spell POT, at the end they should spell it backwards.",
            "The letters start as POT and should end as TOP.", "The word is POT. Make TOP of it.",
            "Start with POT and end with TOP.",
            "The letters start out as POT. They should end up as TOP.")),
        *((text, OFF_THE_TOP) for text in (
            "There is a tower of three white blocks. Take the top block off.",
            "Take the top block off the tower. The tower is made of three white blocks.",
            "There is a tower of three white blocks. Take the top block off it.")),
        ("Unstack the tower. It consists of a red and a white block.",
         {"assets": {"red": 1, "white": 1}, "start": ["red^white"], "start_miss": ["red white"],
          "hold": ["red ; white"], "miss": ["red^white"]}),
        ("Keep the blue tower as it is and put a red block next to it. The tower has two blocks.",
         {"assets": {"blue": 2, "red": 1}, "start": ["blue^blue ; red"], "start_miss": ["blue blue ; red"],
          "hold": [["blue^blue at=0,0 ; red at=0,5", "blue^blue at=0,0 ; red at=0,1.5"]],
          "miss": [["blue^blue at=0,0 ; red at=0,5", "blue^blue at=0,3 ; red at=0,4.5"]]}),
        ("There is a tower of three red blocks and a tower of two blue ones. Move only the top red block onto the blue "
         "tower.",
         {"assets": {"red": 3, "blue": 2}, "start": ["red^red^red ; blue^blue"],
          "start_miss": ["red red red ; blue^blue"],
          "hold": [["red^red^red at=0,3 ; blue^blue at=0,-3", "red^red at=0,3 ; blue^blue^red at=0,-3"]],
          "miss": [["red^red^red at=0,3 ; blue^blue at=0,-3", "red^red at=0,5 ; blue^blue^red at=0,-3"]]}),
        ("The red block is on the blue block. Move the blue block to the white patch with the red one still on top.",
         {"assets": {"red": 1, "blue": 1, "white_patch": 1}, "start": ["blue^red"], "start_miss": ["blue ; red"],
          "hold": ["blue^red at=white_patch"], "miss": ["blue at=white_patch ; red", "blue^red"]}),
        ("Start with a tower of red, blue and green from bottom to top. Swap its top and its bottom block.",
         {"assets": {"red": 1, "blue": 1, "green": 1}, "start": ["red^blue^green"],
          "hold": [["red^blue^green at=0,0", "green^blue^red at=0,0"]],
          "miss": [["red^blue^green", "red^green^blue"]]}),
        ("A tower has red at the bottom, blue in the middle and green on top. Take the bottom block and put it on top.",
         {"assets": {"red": 1, "blue": 1, "green": 1}, "start": ["red^blue^green"], "start_miss": ["green^blue^red"],
          "hold": ["blue^green^red"], "miss": ["red^blue^green", "green^blue^red"]}),
        ("There is a white and a black patch, and the blue block starts on the white one. Put the red block on the "
         "empty patch.",
         {"assets": {"blue": 1, "red": 1, "white_patch": 1, "black_patch": 1}, "start": ["blue at=white_patch ; red"],
          "hold": ["red at=black_patch"], "miss": ["red at=white_patch"]}),
        ("Three red blocks start in the left half. At least one of them must leave it.",
         {"assets": {"red": 3}, "start": ["red red red at=0,4"], "start_miss": ["red red red at=0,-4"],
          "hold": ["red red at=0,4 ; red at=0,-4"], "miss": ["red red red at=0,4"]}),
        ("The blue block starts in the left half and must stay in that half the whole time. Put the red block on it.",
         {"assets": {"red": 1, "blue": 1}, "start": ["blue at=0,4"], "start_miss": ["blue at=0,-4"],
          "hold": [["blue at=0,4 ; red at=0,-4", "blue^red at=0,4"]],
          "miss": [["blue at=0,4 ; red at=0,-4", "blue^red at=0,-4"]]}),
        *((text, {"assets": dict.fromkeys(("c1", "c2", "c3", "c4"), 1), "heap": 4, "hold": ["c1^c2 ; c3^c4"],
                  "miss": ["c1^c2^c3^c4"]})
          for text in ("Make two towers of two from the heap of four blocks.",
                       "Build two towers of two out of the heap of four blocks.")),
        *((text, {"assets": {"blue": 2, "red": 1}, "start": ["blue^blue ; red"], "start_miss": ["blue blue ; red"],
                  "hold": ["blue^blue^red"], "miss": ["blue^blue ; red"]})
          for text in ("You will find a tower of two blue cubes. Put the red cube on the tower.",
                       "In front of you stands a tower of two blue cubes. Put a red cube on it.")),
        ("Begin with a red tower of two and a blue tower of two. End with one tower of four.",
         {"assets": {"red": 2, "blue": 2}, "start": ["red^red ; blue^blue"], "start_miss": ["red^blue ; red^blue"],
          "hold": ["red^blue^red^blue"], "miss": ["red^red ; blue^blue"]}),
    ],
)  # fmt: skip
def test_starts_and_ends(text: str, meant: Meant) -> None:
    assert_means(text, meant)


@pytest.mark.parametrize(
    ("text", "meant"),
    [
        *((text, LEFT_OVER) for text in (
            "Stack all but one of the five yellow blocks. The one left over goes to the right of the tower.",
            "Stack four of the five yellow blocks. The one that is left over goes to the right of the tower.",
            "There are five yellow blocks. Stack all but one. Put what is left over to the right of the tower.")),
        *((text, TWO_EACH) for text in (
            "Four red blocks, two on each mat. One mat is blue, the other is white.",
            "Put four red blocks on the mats, two on each. There are a blue mat and a white mat.",
            "There are four red blocks, a blue mat and a white mat. Put the blocks on the mats, two on each.",
            "Put two red blocks on each mat. One of the mats is blue and the other one white.",
            "Distribute four red blocks over the blue and the white mat, two per mat.")),
        ("The red block goes on the left half of the table. The other two are blue and go on the right half.",
         {"assets": {"red": 1, "blue": 2}, "hold": ["red at=0,4 ; blue blue at=0,-4"],
          "miss": ["blue red at=0,4 ; blue at=0,-4"]}),
        ("can u sort the blocks by color? there r 3 red 2 blue n 2 yellow",
         {"assets": {"red": 3, "blue": 2, "yellow": 2}, "hold": ["groups=color"],
          "miss": ["red red blue ; red blue yellow ; yellow"]}),
        ("so there's a red a green and a blue block and the green one goes between the other two",
         {"assets": {"red": 1, "green": 1, "blue": 1}, "hold": ["red green blue"], "miss": ["green red blue"]}),
        ("dont stack anything just put the 3 blocks (red, green, blue) next to each other in a row, red in the middle",
         {"assets": {"red": 1, "green": 1, "blue": 1}, "hold": ["green red blue"], "miss": ["red green blue"]}),
        ("put the three on the five and the five on the eight please",
         {"assets": {"3": 1, "5": 1, "8": 1}, "hold": ["8^5^3"], "miss": ["3^5^8"]}),
        ("move the orange one to the left a little bit, about five centimeters",
         {"assets": {"orange": 1}, "hold": [["orange at=0,0", "orange at=0,1.25"]],
          "miss": [["orange at=0,0", "orange at=0,3"], ["orange at=0,0", "orange at=0,-1.25"]]}),
        ("Stack 2 yellow. 2 black on table, do not move.",
         {"assets": {"yellow": 2, "black": 2},
          "hold": [["yellow at=0,5 ; yellow at=0,3 ; black at=0,0 ; black at=0,-3",
                    "yellow^yellow at=0,5 ; black at=0,0 ; black at=0,-3"]],
          "miss": [["yellow at=0,5 ; yellow at=0,3 ; black at=0,0 ; black at=0,-3",
                    "yellow^yellow at=0,5 ; black at=0,1 ; black at=0,-3"]]}),
        ("Rotate cube A 90 deg ccw. Position unchanged.",
         {"assets": {"A": 1}, "hold": [["A at=0,0", "A~90 at=0,0"]],
          "miss": [["A at=0,0", "A~90 at=0,2"], ["A at=0,0", "A~-90 at=0,0"]]}),
        *((text, STEPS) for text in (
            "Build the stack in this order: B onto C first, A onto B after that.",
            "B onto C first, A onto B afterwards.",
            "First put B on C, then A on B; doing it the other way round counts as a failure.",
            "First put B on C, then A on B. In any other order it would be wrong.",
            "Do the B block first: put it on C. Then put A on B.")),
    ],
)  # fmt: skip
def test_what_there_is_and_what_is_done(text: str, meant: Meant) -> None:
    assert_means(text, meant)


@pytest.mark.parametrize(
    ("text", "code"),
    [
        (
            "There are a red, a blue and a green block. Put one of them on the mat and the other on the table.",
            "ambiguous",
        ),
        ("First put one of A and B on the mat, then put the other on it.", "ambiguous"),
        ("Put either A or B on the mat and the other next to C. It must be upright.", "no-referent"),
        ("Put one of A and B on the mat and two red blocks on the other.", "ambiguous"),
        ("Put red or blue on one mat and green on the other.", "ambiguous"),
        ("Put A or B on the left side and C on the other side.", "ambiguous"),
        (
            "Put red on the mat and leave blue where it is or put blue on the mat and leave red where it is.",
            "ambiguous",
        ),
        ("Red and blue stay where they are. Put red on the mat.", "contradiction"),
        ("Leave red where it is. Put red on blue.", "contradiction"),
        ("At the start red is on blue, green on yellow. At the end it should be the other way round.", "ambiguous"),
        (
            "There are a white, a black and a red patch. A starts on the white one. Put A on the empty patch.",
            "ambiguous",
        ),
        (
            "There is a white patch, and the blue block starts on it. Put the red block on the empty patch.",
            "no-referent",
        ),
        ("There are two towers of three red blocks. Put the top red block on the mat.", "no-referent"),
        ("There are three red blocks and two blue ones. Put the three on the two.", "ambiguous"),
        ("Put the two on the left.", "no-referent"),
        ("Build a tower of three from the four red blocks. The last one goes on top of a white block.", "ambiguous"),
        ("There are two red blocks and a blue one. Clear away the blue one.", "no-goal"),
        ("Put A, B, C but B in a row.", "no-goal"),
        ("Put red left of blue. In any other order it is wrong.", "misplaced-word"),
        ("The tower should be next to the mat. It consists of red and blue blocks.", "incomplete"),
    ],
)
def test_what_could_be_meant_otherwise_is_asked(text: str, code: str) -> None:
    schema, diagnostics = BuiltinFrontEnd().read(text)
    assert schema is None
    assert [d.code for d in diagnostics if d.severity == "error"] == [code]
