"""How many, which of them, none of these, one of that: quantity and alternatives in ordinary words."""

from __future__ import annotations

from typing import Any

import pytest

from rpg.passes.schema.frontend import BuiltinFrontEnd
from tests.language.meaning import assert_means

Meant = dict[str, Any]
TWO_OF_FIVE: Meant = {
    "assets": {"blue": 5, "red_patch": 1},
    "hold": ["at=red_patch blue^blue"],
    "miss": ["at=red_patch blue", "at=red_patch blue^blue^blue", "blue blue"],
}


@pytest.mark.parametrize(
    "behind",
    [
        ", no matter which two.",
        ". It makes no difference which ones.",
        "; which two is up to you.",
        ", whichever two you like.",
        ", any two will do.",
        ". I don't care which two you take.",
        ". You can choose which.",
        " - never mind which.",
        ". Any of them are fine.",
        ". Which ones you pick is entirely your choice.",
        ", I have no preference as to which.",
        ", it's not important which of them.",
    ],
)
def test_which_ones_is_left_open(behind: str) -> None:
    assert_means(f"Put two of the five blue blocks on the red mat{behind}", TWO_OF_FIVE)


@pytest.mark.parametrize(
    "text",
    [
        "Which two of the five blue blocks are on the red mat does not matter, but exactly two of them have to be.",
        "It doesn't matter which two of the five blue blocks are on the red mat, but exactly two of them must be.",
        "I don't care which two of the five blue blocks are on the red mat, as long as exactly two of them are.",
    ],
)
def test_which_ones_is_left_open_ahead_of_how_many(text: str) -> None:
    assert_means(text, TWO_OF_FIVE)


ROW: Meant = {"assets": {"red": 2, "white": 3}, "miss": ["red ; red ; white white white"]}
NOT_IN_THE_MIDDLE: Meant = {
    **ROW,
    "hold": ["red red white white white", "red white white white red", "white red white red white"],
    "miss": [*ROW["miss"], "red white red white white", "white white red white red"],
}
AT_NO_END: Meant = {
    **ROW,
    "hold": ["white red red white white", "white red white red white"],
    "miss": [*ROW["miss"], "red white white white red", "white red white white red", "red white red white white"],
}
TOWER: Meant = {
    "assets": {"red": 2, "white": 2},
    "hold": ["red^red^white^white", "red^white^red^white"],
    "miss": ["white^white^red^red", "red^white^white^red", "red^red ; white^white"],
}


@pytest.mark.parametrize(
    ("text", "meant"),
    [
        *(
            (f"Make a row of two red and three white blocks{told}", NOT_IN_THE_MIDDLE)
            for told in (
                ". No red block may be in the middle.",
                " with no red block in the middle.",
                "; the middle one mustn't be red.",
                ", and in the middle can not be red one.",
                ". There must not be a red block in the middle.",
                ". The one in the middle can't be red.",
                ". The red ones must not be in the middle.",
                ". Red ones may be anywhere except in the middle.",
            )
        ),
        *(
            (f"Make a row of two red and three white blocks{told}", AT_NO_END)
            for told in (
                ". No red one may be at an end.",
                ", but no red at the ends.",
                ". Neither of the red blocks may be at either end.",
                ". The red ones must not be first or last.",
                ". The red blocks may stand anywhere but at the end.",
                " so that the ends are not red.",
                ". The red blocks are not allowed at the ends.",
            )
        ),
        *(
            (f"Build a tower of two red and two white blocks{told}", TOWER)
            for told in (
                ". No red block may be on top.",
                ", but the top one can't be red.",
                " without a red block on top.",
                " whose top block is not red.",
                ". Red is not permitted at the top.",
                ". There must be no red block at the top.",
                ". The top block must not be red.",
            )
        ),
        ("Make two towers of one red and two white blocks each. No red block may be on top.",
         {"assets": {"red": 2, "white": 4}, "hold": ["red^white^white ; white^red^white"],
          "miss": ["red^white^white ; white^white^red", "white^white^red ; red^white^white"]}),
        ("Three green, one black in a row. Black may not be at the end.",
         {"assets": {"green": 3, "black": 1}, "hold": ["green black green green"],
          "miss": ["black green green green", "green green green black"]}),
    ],
)  # fmt: skip
def test_what_a_line_must_not_have_at_a_place(text: str, meant: Meant) -> None:
    assert_means(text, meant)


CARRYING: Meant = {
    "assets": {"red": 4, "blue": 4},
    "hold": ["red^blue ; red^blue ; red^blue ; red ; blue", "red^blue ; red^blue ; red^blue ; red^blue"],
    "miss": ["red^blue ; red^blue ; red ; red ; blue ; blue", "blue^red ; blue^red ; blue^red ; blue^red"],
}
BEHIND: Meant = {
    "assets": {"blue": 2, "yellow": 2},
    "hold": ["yellow . yellow | blue . blue"],
    "miss": ["blue . blue | yellow . yellow"],
}
EACH_OF_BOTH: Meant = {
    "assets": {"red": 2, "blue": 2, "red_patch": 1},
    "hold": ["at=red_patch red^blue", "at=red_patch red^blue^blue"],
    "miss": ["at=red_patch red^red", "at=red_patch blue", "red blue"],
}


@pytest.mark.parametrize(
    ("text", "meant"),
    [
        ("At least three of the four red cubes carry a blue cube. There are four blue cubes too.", CARRYING),
        ("There are four blue cubes. At least three of the four red cubes support a blue one.", CARRYING),
        ("For every blue block there has to be a yellow block directly behind it. Use two of each colour.", BEHIND),
        ("For each of the two blue blocks there must be a yellow one behind it. There are two yellow blocks.", BEHIND),
        ("Behind every blue block there is a yellow one. There are two of each.", BEHIND),
        ("At least one of each colour has to be on the red mat (two red and two blue blocks)", EACH_OF_BOTH),
        ("There are two red and two blue blocks. The red mat must hold at least one of each colour.", EACH_OF_BOTH),
        ("There are two red and two blue blocks. Put at least one of each color on the red mat.", EACH_OF_BOTH),
        ("Half of the six yellow blocks go on the red mat, the other half in a row.",
         {"assets": {"yellow": 6, "red_patch": 1}, "hold": ["at=red_patch yellow^yellow^yellow ; yellow yellow yellow"],
          "miss": ["at=red_patch yellow^yellow^yellow", "yellow yellow yellow ; yellow"]}),
        ("There are three red blocks. All of them go on a patch, more on the blue one than on the green one.",
         {"assets": {"red": 3, "blue_patch": 1, "green_patch": 1},
          "hold": ["at=blue_patch red^red ; at=green_patch red", "at=blue_patch red^red^red"],
          "miss": ["at=blue_patch red ; at=green_patch red^red", "at=blue_patch red^red ; red"]}),
        ("There are three red and two blue blocks. Put both blue ones on the mat and just as many red ones.",
         {"assets": {"red": 3, "blue": 2, "patch": 1}, "hold": ["at=patch red^red^blue^blue"],
          "miss": ["at=patch red^red^red^blue^blue", "at=patch red^blue", "at=patch blue^blue"]}),
        ("Put both green blocks on the mat and as many red ones. There are three red blocks.",
         {"assets": {"red": 3, "green": 2, "patch": 1}, "hold": ["at=patch red^red^green^green"],
          "miss": ["at=patch red^red^red^green^green", "at=patch red^green", "at=patch green^green"]}),
        ("There are five red cubes. In the end there is exactly one tower, it is made of exactly three of them, and "
         "the other two are on the table.",
         {"assets": {"red": 5}, "hold": ["red^red^red ; red ; red"],
          "miss": ["red^red^red^red ; red", "red^red^red ; red^red"]}),
        ("At the end every vowel among the cubes A, E, K and T rests on a consonant.",
         {"assets": {"A": 1, "E": 1, "K": 1, "T": 1}, "hold": ["K^A ; T^E", "T^A ; K^E"],
          "miss": ["K^A ; T ; E", "A^K ; E^T", "K^A^E ; T"]}),
        ("No stack may be higher than two. Store all three red boxes on the black mat.",
         {"assets": {"red": 3, "black_patch": 1},
          "hold": ["at=black_patch red^red ; at=black_patch+0,1.1 red"], "miss": ["at=black_patch red^red^red"]}),
    ],
)  # fmt: skip
def test_how_many(text: str, meant: Meant) -> None:
    assert_means(text, meant)


ONE_WHITE: Meant = {
    "assets": {"red": 3, "white": 3},
    "hold": ["red^red^white^red", "white^red^red^red"],
    "miss": ["red^white^red^white", "red^red^red", "red^red^red^white^white"],
}
TWO_RED: Meant = {
    "assets": {"red": 3, "white": 3},
    "hold": ["red^white^red^white", "red^red^red^white"],
    "miss": ["red^white^white^white", "white^white^white ; red^red", "red^red^white^white^white"],
}


@pytest.mark.parametrize(
    ("text", "meant"),
    [
        ("We have three red and three white blocks. Make a tower of 4 with at most one white block in it.", ONE_WHITE),
        ("From three red and three white blocks build a tower of four with exactly one white block in it.", ONE_WHITE),
        ("There are three red and three white blocks. Build a stack of 4 containing only one white one.", ONE_WHITE),
        ("There are three red and three white blocks. Build a tower of four that has at least two red ones.", TWO_RED),
        ("There are three red and three white blocks. Make a tower of four with no fewer than 2 red cubes.", TWO_RED),
        ("There are two red blocks. Stack two red blocks or put two red blocks in a row.",
         {"assets": {"red": 2}, "hold": ["red^red", "red red"], "miss": ["red ; red"]}),
    ],
)  # fmt: skip
def test_a_limit_inside_of_a_line(text: str, meant: Meant) -> None:
    assert_means(text, meant)


OTHER_COLORS: Meant = {
    "assets": {"red": 1, "green": 1, "blue": 1, "red_patch": 1, "green_patch": 1, "blue_patch": 1},
    "hold": ["at=red_patch green ; at=green_patch blue ; at=blue_patch red"],
    "miss": [
        "at=red_patch red ; at=green_patch blue ; at=blue_patch green",
        "at=red_patch green ; at=green_patch blue",
    ],
}


@pytest.mark.parametrize(
    "text",
    [
        "Each patch gets exactly one box: three patches, red, green and blue, and three boxes of the same colours, but "
        "no box may sit on its own colour.",
        "Red, green and blue patches, one block each of the same three colours. Every block lies on a patch, but none "
        "on the patch of its own colour.",
        "There are a red, a green and a blue block and three mats of the same colours. Each mat gets one block of "
        "another colour.",
        "There are red, green and blue patches and one block of each of these colors. Each patch gets a block that "
        "does not match it.",
        "There are three patches (red, green, blue) and three blocks in the same colors. Put a block on each patch, "
        "but none on the patch of its own color.",
    ],
)
def test_none_is_on_its_own_color(text: str) -> None:
    assert_means(text, OTHER_COLORS)


THREE_WAYS: Meant = {
    "assets": {"A": 1, "B": 1, "C": 1},
    "hold": ["B^A ; C", "C^B ; A", "A^C ; B"],
    "miss": ["A ; B ; C", "A^B ; C"],
}


@pytest.mark.parametrize(
    ("text", "meant"),
    [
        ("Either A is on B, B is on C, or C is on A.", THREE_WAYS),
        ("Put A on B, B on C, or C on A.", THREE_WAYS),
        ("At least one of the following must be true: A is on B, B is on C, or C is on A.", THREE_WAYS),
        ("Red must be on blue, on green, or on white.",
         {"assets": {"red": 1, "blue": 1, "green": 1, "white": 1},
          "hold": ["blue^red", "green^red", "white^red"], "miss": ["red^blue"]}),
        ("Put A on B, C on D or on E.",
         {"assets": {"A": 1, "B": 1, "C": 1, "D": 1, "E": 1}, "hold": ["B^A ; D^C", "B^A ; E^C"],
          "miss": ["B^A", "D^C"]}),
        ("Exactly one of these should hold: the red cube is on the mat, or the blue cube is on the mat.",
         {"assets": {"red": 1, "blue": 1, "patch": 1}, "hold": ["at=patch red", "at=patch blue"],
          "miss": ["at=patch red^blue", "red ; blue"]}),
        ("Accept either a tower of four red blocks or a row of four red blocks.",
         {"assets": {"red": 4}, "hold": ["red^red^red^red", "red red red red"], "miss": ["red^red ; red red"]}),
        ("There must be a tower or a row of four red blocks.",
         {"assets": {"red": 4}, "hold": ["red^red^red^red", "red red red red"], "miss": ["red^red ; red red"]}),
    ],
)  # fmt: skip
def test_one_of_several_ways(text: str, meant: Meant) -> None:
    assert_means(text, meant)


@pytest.mark.parametrize(
    ("text", "code"),
    [
        ("Put two of the five blue blocks on the mat, no matter which three.", "misplaced-word"),
        ("Put the red block on the blue or the green block, whichever is closer.", "misplaced-word"),
        ("Exactly two of the four yellow cubes have a green cube on top of them.", "ambiguous"),
        ("There are three red, one green and three blue blocks. Build a tower of three with at least two red ones.",
         "ambiguous"),
        ("One of the following shall hold: A is on B, or C is on D.", "misplaced-word"),
        ("A is on B, B is on C or C is on D.", "ambiguous"),
        ("A is on B and B is on C, or C is on D.", "ambiguous"),
        ("Exactly one of these must hold: A is left of B, B is left of C, or C is left of A.", "misplaced-word"),
        ("Make a tower of three white blocks or a row of four white blocks.", "ambiguous"),
        ("There are two red blocks. At least one of each color is on the mat.", "misplaced-word"),
        ("There are three red and three blue blocks. Build a tower of 3 with at least 4 red ones.", "count-mismatch"),
        ("Make a row of two red and three white blocks. The middle one must not be green.", "no-referent"),
        ("None of the four red cubes may stand on a blue cube. There are two blue cubes. They are on the mat.",
         "ambiguous"),
        ("The red cube is on a blue cube. There are two blue cubes, and both of them are on the mat.", "ambiguous"),
    ],
)  # fmt: skip
def test_what_is_left_unclear_is_asked(text: str, code: str) -> None:
    schema, diagnostics = BuiltinFrontEnd().read(text)
    assert schema is None
    assert [d.code for d in diagnostics if d.severity == "error"] == [code]


@pytest.mark.parametrize(
    ("text", "meant"),
    [
        ("None of the four red cubes may be on the mat. There are two blue cubes. They must be in a row.",
         {"assets": {"red": 4, "blue": 2, "patch": 1}, "hold": ["blue blue"], "miss": ["red red red red"]}),
        ("There is a green mat. The red cube must be on a blue cube. There are two blue cubes, and the green cube is "
         "on the green mat.",
         {"assets": {"red": 1, "blue": 2, "green": 1, "green_patch": 1}, "hold": ["blue^red ; at=green_patch green"],
          "miss": ["blue^red", "at=green_patch green"]}),
    ],
)  # fmt: skip
def test_what_there_is_told_in_between(text: str, meant: Meant) -> None:
    assert_means(text, meant)


@pytest.mark.parametrize(
    ("text", "meant"),
    [
        ("Either the red block goes on the blue one or the green one.",
         {"assets": {"red": 1, "blue": 1, "green": 1}, "hold": ["blue^red ; green", "green^red ; blue"],
          "miss": ["blue^green ; red", "red ; blue ; green"]}),
        ("Either both red blocks are on the mat, or both blue ones.",
         {"assets": {"red": 2, "blue": 2, "patch": 1}, "hold": ["red . red at=patch", "blue . blue at=patch"],
          "miss": ["red . blue at=patch ; red ; blue", "red at=patch"]}),
        ("Use a red, a blue and a green block. Either the red one is on the blue one, or the red one is left of green.",
         {"assets": {"red": 1, "blue": 1, "green": 1}, "hold": ["blue^red ; green", "red green ; blue"],
          "miss": ["blue green ; red", "green red ; blue"]}),
    ],
)  # fmt: skip
def test_either_of_two(text: str, meant: Meant) -> None:
    assert_means(text, meant)
