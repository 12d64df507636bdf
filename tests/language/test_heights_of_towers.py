"""Towers whose heights are compared, or which stand in an order that is told by their heights: how high each of them
is, and where it stands, follows from what is told of all of them."""

from __future__ import annotations

import pytest

from tests.language.meaning import assert_means, code_of, means


@pytest.mark.parametrize(
    ("text", "plain"),
    [
        ("Build two towers from five red blocks, the left one taller.",
         "Build two red towers of heights 3 and 2 from left to right."),
        ("From nine yellow blocks make three towers of different heights, the tallest on the right and the lowest in "
         "the middle.", "Build three yellow towers of heights 3, 2 and 4 from left to right."),
        ("A tower of four white blocks and one of two; the shorter one stands behind the taller one.",
         "Build two white towers of heights 4 and 2 from front to back."),
        ("Seven white blocks, all in two stacks: one stack exactly 3 high and the other one block higher.",
         "Build two white towers of heights 3 and 4."),
        ("The picture shows a red tower twice as high as the blue one, and the blue one has two blocks.",
         "Build a tower of four red blocks and a tower of two blue blocks."),
        ("A blue tower of three and right next to it a red one that is one block taller.",
         "Build a tower of 3 blue blocks and a tower of 4 red blocks. The red tower is right next to the blue tower."),
        ("A red tower of two, a blue tower of three and a green tower of four in a row, the tallest in the middle.",
         "Build a tower of 2 red blocks, a tower of 3 blue blocks and a tower of 4 green blocks. The green tower is "
         "between the red tower and the blue tower. The towers stand in a row."),
        ("Of three towers in a row the middle one has three blocks and the other two have two each.",
         "Build three towers of heights 2, 3 and 2 from left to right. The towers stand in a row."),
    ],
)  # fmt: skip
def test_heights_follow_from_what_is_told_of_all(text: str, plain: str) -> None:
    assert means(text) == means(plain)


def test_blocks_may_be_left_over_where_the_towers_cannot_take_all() -> None:
    meant = {
        "assets": {"red": 2, "blue": 4},
        "hold": ["red^red ; blue^blue^blue ; blue"],
        "miss": ["red^red ; blue^blue^blue^blue", "red^red ; blue^blue"],
    }
    assert_means("There are two red and four blue blocks. Make a red tower and a blue tower, the blue one exactly one "
                 "block taller.", meant)  # fmt: skip


@pytest.mark.parametrize(
    "text",
    [
        "Build two towers, the left one taller.",
        "Build two towers from nine red blocks, the left one taller.",
        "Build two towers of five blocks, the taller one on the left.",
        "Two towers of three blocks, the left one is taller.",
        "There is a tower of three blue blocks, make it one taller.",
        "Make the tower of four red blocks one block lower.",
        "There is a tower of three and a tower of two. Put the taller one behind the shorter one.",
        "There are two towers, one of three and one of two. Make the left one taller.",
        "Out of three red and three green blocks, make a red tower and a green one, each at least two blocks high.",
    ],
)
def test_heights_that_do_not_follow_are_not_guessed(text: str) -> None:
    assert code_of(text)
