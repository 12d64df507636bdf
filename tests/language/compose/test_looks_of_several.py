"""How several towers look that were told without their colours: wholly, at their ends, one after the other."""

from __future__ import annotations

from typing import Any

import pytest

from tests.language.meaning import assert_means, code_of

CASES: dict[str, dict[str, Any]] = {
    "Both towers are two high. The left one is green at the bottom, the right one is green on top, and everything else "
    "is black.": {
        "assets": {"green": 2, "black": 2},
        "hold": ["green^black . black^green"],
        "miss": ["black^green . green^black", "green^black . green^black", "green^black^black^green"],
    },
    "Three towers of two stand in a row: each has a gray block at the bottom; on top are blue, white and pink, "
    "respectively, from left to right.": {
        "assets": {"gray": 3, "blue": 1, "white": 1, "pink": 1},
        "hold": ["gray^blue gray^white gray^pink"],
        "miss": ["gray^pink gray^white gray^blue", "blue^gray white^gray pink^gray", "gray^blue gray^pink gray^white"],
    },
    "Build three towers of two in a row. The bottom ones are red, blue and red from left to right and everything else "
    "is yellow.": {
        "assets": {"red": 2, "blue": 1, "yellow": 3},
        "hold": ["red^yellow blue^yellow red^yellow"],
        "miss": ["yellow^red yellow^blue yellow^red", "red^yellow red^yellow blue^yellow"],
    },
    "There must be three towers, all two blocks high. Two of them are purple all through, the other one is purple "
    "below and white on top.": {
        "assets": {"purple": 5, "white": 1},
        "hold": ["purple^purple . purple^white . purple^purple"],
        "miss": ["purple^purple . white^purple . purple^purple", "purple^purple^white . purple^purple . purple"],
    },
    "Line up three towers of two. All are completely red except for the middle one, whose bottom block is blue.": {
        "assets": {"red": 5, "blue": 1},
        "hold": ["red^red blue^red red^red"],
        "miss": ["blue^red red^red red^red", "red^red red^blue red^red"],
    },
    "From left to right: a tower of two browns, a tower of three pinks, and the yellow block all on its own.": {
        "assets": {"brown": 2, "yellow": 1, "pink": 3},
        "hold": ["brown^brown pink^pink^pink yellow"],
        "miss": ["yellow pink^pink^pink brown^brown", "yellow brown^brown pink^pink^pink"],
    },
    "right: tower of two cyan. left: tower of three gray. between the two: a red cube.": {
        "assets": {"cyan": 2, "gray": 3, "red": 1},
        "hold": ["gray^gray^gray red cyan^cyan"],
        "miss": ["cyan^cyan red gray^gray^gray", "gray^gray^gray cyan^cyan red"],
    },
    "On the left a tower of three, on the right one of two. The right one is white at the bottom and everything else "
    "is green.": {
        "assets": {"white": 1, "green": 4},
        "hold": ["green^green^green . white^green"],
        "miss": ["white^green . green^green^green", "green^green^green . green^white"],
    },
}
REFUSED = (
    "Both towers are three high. The left one is red below and white above, everything else is blue.",
    "Three towers of two stand in a row: on top are blue, white and pink.",
    "Everything else is white.",
)


@pytest.mark.parametrize("text", CASES)
def test_states(text: str) -> None:
    assert_means(text, CASES[text])


@pytest.mark.parametrize("text", REFUSED)
def test_refused(text: str) -> None:
    assert code_of(text)
