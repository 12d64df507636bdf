"""Numbers of blocks on mats: both bounds of one, so many of different blocks and the others, so many taken off."""

from __future__ import annotations

import pytest

from tests.language.meaning import assert_means, code_of, means


@pytest.mark.parametrize(
    ("text", "goal"),
    [
        ("There are four red blocks. Goal: at most two of them on the blue patch, but not zero.",
         "Between one and two of the four red blocks must be on the blue patch."),
        ("Put one or two, but no more, of the four black blocks on the mat.",
         "Between one and two of the four black blocks must be on the gray patch."),
        ("At least one but at most two of the five green cubes may end up on the red patch.",
         "Between one and two of the five green blocks must be on the red patch."),
        ("There are four white blocks. Put exactly two on the red mat and at least one on the blue mat.",
         "At least one of the four white blocks must be on the blue patch."),
        ("Each of the mats red, blue and green must have at least one of the five white blocks.",
         "At least one of the five white blocks must be on the green patch."),
        ("Of the cubes A and B, one but not both shall lie on the blue patch.",
         "Exactly one of the blocks A and B must be on the blue patch."),
    ],
)  # fmt: skip
def test_both_bounds_of_a_number(text: str, goal: str) -> None:
    assert goal in means(text)


@pytest.mark.parametrize(
    "text",
    [
        "Exactly one of the cubes X, Y and Z is on the red patch, the other two are on the green one.",
        "Of the cubes X, Y and Z exactly one is on the red patch, the others are on the green patch.",
    ],
)
def test_some_of_different_blocks_and_the_others(text: str) -> None:
    told = means(text)
    assert "Exactly one of the blocks X, Y and Z must be on the red patch." in told
    assert "Exactly two of the blocks X, Y and Z must be on the green patch." in told


@pytest.mark.parametrize("text", ["Take all but one off it.", "Take everything off except one.", "Take two off."])
def test_some_are_taken_off(text: str) -> None:
    assert_means(
        f"Three red blocks are on the blue patch. {text}",
        {
            "assets": {"red": 3, "blue_patch": 1},
            "start": ["red red red pitch=1 at=blue_patch"],
            "hold": [["red red red pitch=1 at=blue_patch", "red at=blue_patch"]],
            "miss": [["red red red pitch=1 at=blue_patch", "red red at=blue_patch"],
                     ["red red red pitch=1 at=blue_patch", "red at=blue_patch+0,3 ; red at=blue_patch+0,-3"]],
        },
    )  # fmt: skip


def test_so_many_on_each_of_several_mats() -> None:
    told = means("Place one green block on the red mat, two on the blue one and three on the white one.")
    assert "There are six green blocks." in told
    assert "Another two green blocks must be on the blue patch. The other three" in told


def test_the_mat_of_the_other_color() -> None:
    told = means("A red and a blue block, a red and a blue mat: each block goes on the mat of the other colour.")
    assert "The red block must not be on the red patch. The blue block must not be on the blue patch." in told


def test_the_same_mat_as_another_block() -> None:
    told = means("A is on the red patch, C is on the blue patch. Put B on the same patch as A.")
    assert "The B block must be on the red patch." in told


@pytest.mark.parametrize(
    "text",
    [
        "Exactly two of the four cubes may be on the red patch.",
        "A tower of five red blocks is on the mat. Take two off.",
        "One of the cubes X, Y and Z is on the red patch, the others are on the table.",
    ],
)
def test_what_leaves_it_open_is_asked_about(text: str) -> None:
    assert code_of(text) in ("ambiguous", "no-goal")
