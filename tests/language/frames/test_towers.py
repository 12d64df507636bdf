"""Several towers told part by part, in whatever order and syntax."""

from __future__ import annotations

import pytest

from tests.language.frames.told import told


@pytest.mark.parametrize(
    ("text", "plain"),
    [
        (
            "Build three towers of two blocks each; one tower per colour: red, green, blue.",
            "Build 3 towers from 2 red blocks, 2 green blocks and 2 blue blocks, one tower per color.",
        ),
        (
            "two towers next to each other, one red 3 high and one blue 2 high",
            "Build 2 towers, one of 3 red blocks and one of 2 blue blocks. The towers are next to each other.",
        ),
        (
            "I want three stacks, each has two blocks, and each is a different color",
            "Build 3 towers of 2 blocks each, one tower per color.",
        ),
        (
            "make me 2 towers, each one with a red block at the bottom and a blue one on top",
            "Build 2 towers, each with 1 red block at the bottom and 1 blue block at the top.",
        ),
        (
            "a stack of three yellow and next to it a stack of two pink",
            "Build 2 towers, one of 3 yellow blocks and one of 2 pink blocks. The towers are next to each other.",
        ),
        (
            "Two stacks, the left of three white cubes, the right one of three black cubes.",
            "Build 2 towers, one of 3 white blocks and one of 3 black blocks. The white tower is left of the "
            "black tower.",
        ),
        (
            "Six blocks in two towers of three, one tower is green, other tower is orange",
            "Build 2 towers, one of 3 green blocks and one of 3 orange blocks.",
        ),
        (
            "put the red cubes in one tower and the blue cubes in another, 3 cubes each",
            "Build 2 towers, one of 3 red blocks and one of 3 blue blocks.",
        ),
        ("Make stack with A on B and other stack with C on D", "Build 2 towers: A on B and C on D."),
        (
            "tower 1: red, red. tower 2: blue, blue.",
            "Build 2 towers, one of 2 red blocks and one of 2 blue blocks.",
        ),
        ("You should end up with four two-block towers, all gray.", "Build 4 towers of 2 gray blocks each."),
        ("Build towers of heights 2, 3 and 4 from blue blocks.", "Build 3 blue towers of heights 2, 3 and 4."),
        ("Three stacks of equal height from nine cubes", "Build 3 towers of the same height from 9 blocks."),
        (
            "From two red and two green blocks build two towers in such a way that one is red and the other one green.",
            "Build 2 towers, one of 2 red blocks and one of 2 green blocks.",
        ),
        ("two towers: A over B, C over D", "Build 2 towers: A on B and C on D."),
        ("With 6 gray cubes, make 3 equal stacks", "Build 3 towers of 2 gray blocks each."),
        (
            "two three-high towers, one yellow and one green",
            "Build 2 towers, one of 3 yellow blocks and one of 3 green blocks.",
        ),
        (
            "Both towers should have a white block below and a black block above.",
            "Build 2 towers, each with 1 white block at the bottom and 1 black block at the top.",
        ),
        (
            "two towers that do not touch, each 2 red blocks",
            "Build 2 towers of 2 red blocks each. The towers do not touch.",
        ),
        (
            "From the six blocks (three orange, three cyan) build two single-colour towers.",
            "Build 2 towers from 3 orange blocks and 3 cyan blocks, one tower per color.",
        ),
        (
            "can you make three stacks with two blocks each a red stack a green stack and a blue stack",
            "Build 3 towers, one of 2 red blocks, one of 2 green blocks and one of 2 blue blocks.",
        ),
        (
            "red tower (4), blue tower (3)",
            "Build 2 towers, one of 4 red blocks and one of 3 blue blocks.",
        ),
        (
            "3 stacks: red x3, green x3, blue x3",
            "Build 3 towers, one of 3 red blocks, one of 3 green blocks and one of 3 blue blocks.",
        ),
        (
            "Each tower consists of one red block and one gray block on it. Please make three towers",
            "Build 3 towers, each with 1 red block at the bottom and 1 gray block at the top.",
        ),
        (
            "Two towers: 3 red on the red patch, 3 blue on the blue patch",
            "Build 2 towers, one of 3 red blocks and one of 3 blue blocks. The red tower is on the red patch. The "
            "blue tower is on the blue patch.",
        ),
        (
            "Three towers should be built such that each of them contains exactly two cubes, one orange and one "
            "green, with the orange cube below.",
            "Build 3 towers, each with 1 orange block at the bottom and 1 green block at the top.",
        ),
        (
            "build one tower with all the red blocks and another one with all the blue blocks, 3 red, 3 blue",
            "Build 2 towers, one of 3 red blocks and one of 3 blue blocks.",
        ),
    ],
)
def test_parts_are_put_together(text: str, plain: str) -> None:
    assert told(text) == plain


@pytest.mark.parametrize(
    "text",
    [
        "Build three equal towers of nine red blocks.",
        "Build two towers of two red blocks on top of a blue block.",
        "Put red on blue and green on red so that there are two towers.",
        "Build three towers, one of two red, one of two blue.",
        "Build two towers of three blocks each from five red blocks.",
        "Build two towers of two, none of them with a red block.",
        "Two stacks of three white cubes; afterwards put one on the other.",
        "Build a tower of two red blocks and a row of two blue blocks.",
        "Both towers have two red blocks, but the left one also has a blue one.",
        "Build two towers, each from two of the three red blocks.",
        "Build at least two towers of two red blocks each.",
        "two towers, one of them red",
        "Four gray cubes are stacked up; split them into two stacks of two.",
        "There are two towers of two red blocks.",
        "Three towers: A over B, C over D.",
        "Two red towers and a blue one, two blocks each.",
        "Two towers of three, red at the bottom",
        "Two towers of two, one red and one blue block.",
        "Two towers two high, one red",
        "Line up a tower of two red blocks and a tower of two blue blocks.",
        "Put the two green blocks in the right half of the table and stack the two red blocks in the left half.",
        "3 stacks: 2 red, 2 green, 2 blue, mixed colours",
    ],
)
def test_what_is_not_clear_is_not_told(text: str) -> None:
    assert told(text) is None
