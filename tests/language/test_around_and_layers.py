"""Figures told by their parts: what is around a block, arms of letters, layers, and which of several blocks."""

from __future__ import annotations

import pytest

from tests.language.meaning import code_of, means

PLUS = "form a plus sign in the order two blue blocks, then the red block, then two blue blocks"


@pytest.mark.parametrize(
    "text",
    [
        "A red block in the middle and four blue ones around it: one to the left of it, one to the right, one in front "
        "of it, one behind it.",
        "There are 4 blue blocks and 1 red block. Put the blue ones around the red one, one on each side (left, right, "
        "front and back).",
    ],
)
def test_one_on_each_of_four_sides_is_a_plus(text: str) -> None:
    assert PLUS in means(text)


def test_touching_each_side_leaves_no_gaps() -> None:
    text = "Put four red blocks around the blue one, so that each side of it is touched by a red block."
    assert "must form a plus sign without gaps" in means(text)


def test_one_more_in_the_middle_of_a_ring() -> None:
    told = means("8 white blocks in a circle, and in the middle one more thats black")
    assert "eight white blocks and a black block" in told
    assert "the order four white blocks, then the black block, then four white blocks" in told


@pytest.mark.parametrize("side", ["right", "left"])
def test_the_foot_of_an_l_points_where_it_is_told_to(side: str) -> None:
    text = (
        "An L made of five orange blocks lying on the table, three for the upright and two more for the foot, which "
        f"should point to the {side}."
    )
    assert f"The five orange blocks must form an L shape with its foot to the {side}" in means(text)


def test_layers_are_told_from_below() -> None:
    flat = means("Pyramid in one plane: three at the base, two above, one at the tip. All blocks cyan.")
    assert "The six cyan blocks must form a pyramid with a base of three blocks" in flat
    square = means("Base of two by two blue cubes, and one orange cube centered on top of the four.")
    assert "a pyramid with a 2x2 base from top to bottom in the order the orange block, then the four blue" in square


def test_whichever_two_of_four_are_not_guessed() -> None:
    text = "Two of the four cubes A, B, C and D, no matter which two, are to be stacked on each other."
    assert code_of(text) == "misplaced"
