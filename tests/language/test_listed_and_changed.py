"""Lines that are told as a list and then changed, who may move, what is denied of "it", and what stands at one end."""

from __future__ import annotations

from typing import Any

import pytest

from rpg.passes.schema.frontend import BuiltinFrontEnd
from tests.language.meaning import assert_means

Meant = dict[str, Any]

SWAPPED_ENDS: Meant = {
    "assets": {"red": 1, "blue": 1, "green": 1},
    "start": ["red blue green"],
    "start_miss": ["green blue red"],
    "hold": [["red blue green at=0,0", "green blue red at=0,0"]],
    "miss": [["red blue green at=0,0", "red green blue at=0,0"], "red blue green"],
}
BLUE_LEFT: Meant = {
    "assets": {"red": 1, "blue": 1, "green": 1},
    "start": ["red blue green"],
    "hold": ["blue red green", "blue green red"],
    "miss": ["red blue green", "green red blue"],
}
TWO_OFF: Meant = {
    "assets": {"red": 1, "blue": 1, "green": 1, "yellow": 1},
    "start": ["red^blue^green^yellow"],
    "hold": ["red^blue ; green ; yellow"],
    "miss": ["red^blue^green ; yellow", "red^blue^green^yellow"],
}
REVERSED: Meant = {
    "assets": {"red": 1, "blue": 1, "green": 1},
    "start": ["red^blue^green"],
    "start_miss": ["green^blue^red"],
    "hold": ["green^blue^red"],
    "miss": ["red^blue^green"],
}
ONLY_WHITE: Meant = {
    "assets": {"white": 1, "black": 1},
    "hold": [["black at=0,0 ; white at=0,-4", "white black at=0,0.625"]],
    "miss": [["black at=0,0 ; white at=0,-4", "white black at=4,0"]],
}
BIGGEST_LOW: Meant = {
    "assets": {"red{3}": 1, "blue{5}": 1, "green{6}": 1},
    "hold": ["green{6}^red{3}^blue{5}", "green{6}^blue{5}^red{3}"],
    "miss": ["blue{5}^green{6}^red{3}", "red{3}^blue{5}^green{6}"],
}
SORTED: Meant = {
    "assets": {"red{3}": 1, "blue{5}": 1, "green{6}": 1},
    "hold": ["green{6}^blue{5}^red{3}"],
    "miss": ["green{6}^red{3}^blue{5}"],
}
ONE_IN_THE_MIDDLE: Meant = {
    "assets": {"red": 1, "blue": 8},
    "hold": ["blue^blue^blue blue^red^blue blue^blue^blue pitch=1"],
    "miss": ["blue^red^blue blue^blue^blue blue^blue^blue pitch=1"],
}
TWO_TOWERS: Meant = {
    "assets": {"yellow": 3, "green": 2},
    "hold": ["yellow^yellow^yellow ; green^green"],
    "miss": ["yellow^yellow^yellow^green^green", "yellow^yellow^yellow ; green ; green"],
}
ONE_TOPPED: Meant = {
    "assets": {"white": 4, "red": 1},
    "hold": ["white^white^red ; white^white"],
    "miss": ["white^white ; white^white ; red", "white^white^white^white^red"],
}
TWO_OR_THREE: Meant = {
    "assets": {"orange": 4, "white_patch": 1},
    "hold": [
        "orange orange pitch=1 at=white_patch ; orange ; orange",
        "orange orange orange pitch=1 at=white_patch ; orange",
    ],
    "miss": ["orange at=white_patch", "orange orange | orange orange pitch=1 at=white_patch"],
}
NOT_BOTH: Meant = {
    "assets": {"blue": 1, "red": 1, "green": 1},
    "hold": ["blue red ; green", "blue green ; red"],
    "miss": ["red blue green", "blue ; red ; green"],
}


@pytest.mark.parametrize(
    ("text", "meant"),
    [
        ("The row is red, blue, green from left to right. Swap the two outer ones.", SWAPPED_ENDS),
        ("The row is red, blue, green. Swap the first and the last one.", SWAPPED_ENDS),
        ("A red, a blue and a green block stand in a row from left to right. Swap the two at the ends.", SWAPPED_ENDS),
        ("The row is red, blue, green from left to right. Change it so that blue is at the left end.", BLUE_LEFT),
        ("The row is red, blue, green from left to right. Rearrange it so that blue is on the left.", BLUE_LEFT),
        ("A tower is red, blue, green, yellow from the bottom up. Take the top two off.", TWO_OFF),
        ("The tower is red, blue, green, yellow from bottom to top. Take off the top two blocks.", TWO_OFF),
        ("Start with a tower of red, blue and green, red at the bottom. Reverse the order.", REVERSED),
        ("Red, blue and green are stacked, green on top. Reverse it.", REVERSED),
    ],
)
def test_a_line_that_is_listed_and_then_changed_is_there_at_the_start(text: str, meant: Meant) -> None:
    assert_means(text, meant)


@pytest.mark.parametrize(
    "text",
    [
        "Put the white block right next to the black one, on its left. Only the white one may be moved.",
        "Put the white block right next to the black one, on its left. Only the white block may move.",
    ],
)
def test_of_whom_alone_it_is_said_may_move(text: str) -> None:
    assert_means(text, ONLY_WHITE)


@pytest.mark.parametrize(
    ("text", "meant"),
    [
        (
            "Stack a red block of 3 cm, a blue block of 5 cm and a green block of 6 cm, the biggest one at the bottom.",
            BIGGEST_LOW,
        ),
        ("Stack a 3 cm red, a 5 cm blue and a 6 cm green block so that the biggest is at the bottom.", BIGGEST_LOW),
        ("Stack a 3 cm red, a 5 cm blue and a 6 cm green block by size, biggest at the bottom.", SORTED),
        ("Stack a 3 cm red, a 5 cm blue and a 6 cm green block, biggest at the bottom, smallest on top.", SORTED),
        (
            "In a wall three wide and three high, the block in the middle is red and all others are blue.",
            ONE_IN_THE_MIDDLE,
        ),
        ("A wall three wide and three high with a red block in the middle, the others blue.", ONE_IN_THE_MIDDLE),
        ("Stack the three yellow blocks, and the two green ones too, but separately.", TWO_TOWERS),
        ("Stack the three yellow blocks and, separately, the two green blocks.", TWO_TOWERS),
        ("Build two towers of two white blocks and put a red block on top of one of them.", ONE_TOPPED),
        ("At least two of the four orange blocks go on the white mat, but not all.", TWO_OR_THREE),
        ("Not all of the four orange blocks may be on the white mat, but at least two.", TWO_OR_THREE),
        ("Put the blue block next to the red one or the green one, but not next to both.", NOT_BOTH),
        (
            "Stack two gray and two pink cubes, the two pinks not directly on top of each other.",
            {
                "assets": {"gray": 2, "pink": 2},
                "hold": ["pink^gray^pink^gray", "pink^gray^gray^pink"],
                "miss": ["gray^pink^pink^gray"],
            },
        ),
        (
            "Stack a red, a blue, a green and a white block with red higher than blue but not directly on it.",
            {
                "assets": {"red": 1, "blue": 1, "green": 1, "white": 1},
                "hold": ["blue^green^red^white"],
                "miss": ["blue^red^green^white", "red^green^blue^white", "blue^green^red ; white"],
            },
        ),
        ("All the brown blocks in an L shape, use 5.", {"assets": {"brown": 5}}),
        (
            "Put A on B and C on D, separately.",
            {"assets": {"A": 1, "B": 1, "C": 1, "D": 1}, "hold": ["B^A ; D^C"], "miss": ["D^C^B^A", "A^B ; D^C"]},
        ),
    ],
)
def test_no_more_and_no_less_than_is_said(text: str, meant: Meant) -> None:
    assert_means(text, meant)


def test_a_line_that_is_only_told_is_built() -> None:
    task, _ = BuiltinFrontEnd().read("The row is red, blue, green from left to right.")
    assert task is not None
    assert not task.init.arranged
