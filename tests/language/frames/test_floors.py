"""Towers that are told floor by floor, one or several."""

from __future__ import annotations

import pytest

from tests.language.frames.told import told
from tests.language.meaning import means

_UP = "Build a tower, from bottom to top:"
_RED, _BLUE = "a red block", "a blue block"


@pytest.mark.parametrize(
    ("text", "plain"),
    [
        (
            "The final picture shows a tower: a blue one at the bottom, above it a red one, and a blue one at the top.",
            f"{_UP} {_BLUE}, {_RED}, {_BLUE}.",
        ),
        (
            "Two red blocks at the bottom, then one blue, then two red ones on top: stack them.",
            f"{_UP} {_RED}, {_RED}, {_BLUE}, {_RED}, {_RED}.",
        ),
        (
            "Red on top of the tower, under it two blue ones and at the bottom another red one.",
            f"{_UP} {_RED}, {_BLUE}, {_BLUE}, {_RED}.",
        ),
        ("The first floor is blue, the third one red, the second floor red: a tower of three.", None),
        ("Level 1 is blue, level 3 is blue, level 2 is red.", f"{_UP} {_BLUE}, {_RED}, {_BLUE}."),
        (
            "A tower has five levels: the second level is blue and all other levels are red.",
            f"{_UP} {_RED}, {_BLUE}, {_RED}, {_RED}, {_RED}.",
        ),
        ("Stack three blocks. The middle one is red and the others are blue.", f"{_UP} {_BLUE}, {_RED}, {_BLUE}."),
        ("Tower of four. The ends are red, the middle ones blue.", f"{_UP} {_RED}, {_BLUE}, {_BLUE}, {_RED}."),
        ("Tower of four. The bottom one is red, the middle ones are blue.", None),  # and the top one?
        (
            "A tower of five blocks: the two lowest are red, the third is blue, the top two are red.",
            f"{_UP} {_RED}, {_RED}, {_BLUE}, {_RED}, {_RED}.",
        ),
        ("A tower of four blocks: the third is blue, all others are red.", None),  # from which end?
        (
            "The stack must contain exactly two red blocks and one blue one, the blue block between the two red ones.",
            f"{_UP} {_RED}, {_BLUE}, {_RED}.",
        ),
        (
            "There must be no green block in the stack, only three red ones and a blue one at the top.",
            f"{_UP} {_RED}, {_RED}, {_RED}, {_BLUE}.",
        ),
        ("There must be no red block in the stack, only three red ones and a blue one at the top.", None),
        (
            "Stack red and blue blocks, five in total, alternating, red at the bottom.",
            f"{_UP} {_RED}, {_BLUE}, {_RED}, {_BLUE}, {_RED}.",
        ),
        ("A tower with red and blue at the bottom and red on top", None),  # both at the bottom?
        ("Stack three blocks so that the red one is under the blue one and above the green one.", None),
        ("The stack has red at the bottom and blue on top", None),  # now, or in the end?
        ("Build a tower with red at the bottom and blue on top. A red block is on the table.", None),
        ("Stack red and blue. Then put a red one on it.", None),  # first this, then that
        ("Stack red, then blue, then green, and green at the bottom.", None),  # is it the same one?
        ("A tower of red on blue. The blue block is at the top of it.", None),
        ("A tower of three red blocks on the blue mat and a green block on it.", None),  # on the mat?
        (
            "A tower of five red blocks except the top one, which is blue.",
            f"{_UP} {_RED}, {_RED}, {_RED}, {_RED}, {_BLUE}.",
        ),
    ],
)
def test_floors_are_put_in_order(text: str, plain: str | None) -> None:
    found = told(text)
    assert found == plain if plain else not (found or "").startswith(_UP), found


_TWO = "Build 2 towers: 1 blue block on 1 red block and 1 red block on 1 blue block."


@pytest.mark.parametrize(
    ("text", "plain"),
    [
        (
            "The left tower has red below and blue above, the right tower has blue below and red above.",
            f"{_TWO} The first tower is left of the second tower.",
        ),
        (
            "Two towers: one has red at the bottom and blue on top, the other in reverse order. They are 10 cm apart.",
            f"{_TWO} The towers are 10 cm apart.",
        ),
        (
            "Tower A consists of red, blue; tower B consists of blue, red (from the bottom up). B is behind A.",
            f"{_TWO} The second tower is behind the first tower.",
        ),
        (
            "A tower with red at the bottom and blue on top, and to the left of it, one with a blue block at the "
            "bottom and a red one on top.",
            f"{_TWO} The second tower is to the left of the first tower.",
        ),
        (
            "Two stacks of two: red at the bottom, blue on top.",
            f"{_TWO.split(' and ')[0]} and 1 blue block on 1 red block.",
        ),
        ("Two stacks, red at the bottom, blue on top.", None),  # each of them, or one of each color?
        ("First tower: blue on top of red. Second tower: red on top of blue.", _TWO),
        ("Three towers: one has red at the bottom, blue on top, the other in reverse order.", None),
        (
            "A tower with red below and blue above, a second one with blue below and red above, to the left of it, a "
            "third one with red below and blue above.",
            None,  # which of them is left?
        ),
    ],
)
def test_each_of_several_is_told(text: str, plain: str | None) -> None:
    assert told(text) == plain


@pytest.mark.parametrize(
    "text",
    [
        "The bottom one is black and above it is a white one.",  # of a tower that is told elsewhere
        "Put red at the bottom and blue and green above it.",  # in which order?
        "One green block stacked between two white ones, white below it and white above it.",  # these, or two more?
        "Stack one of the two red blocks and one of the two blue blocks.",
    ],
)
def test_what_may_be_another_tower_is_not_told(text: str) -> None:
    assert told(text) is None


def test_what_is_seen_from_the_top_is_told_downwards() -> None:
    assert "from top to bottom in the order blue, green, red" in means("A stack, seen from the top: blue, green, red.")
    assert "from left to right in the order A, B, C" in means("A row of letters, seen from the top: A, B, C.")


@pytest.mark.parametrize(
    "text", ["Stack two red blocks and on top a blue block.", "A tower of two red blocks and on top a blue one."]
)
def test_what_comes_on_top_is_no_ground(text: str) -> None:
    assert "The blue block must be on the tower of the two red blocks." in means(text)
