"""Blocks on patches told part by part, in whatever order and syntax."""

from __future__ import annotations

import pytest

from tests.language.frames.told import told


@pytest.mark.parametrize(
    ("text", "plain"),
    [
        (
            "Even digits end on the blue patch, odd digits on the red patch: 1, 2, 3, 4",
            "Put the blocks 2 and 4 on the blue patch. Put the blocks 1 and 3 on the red patch.",
        ),
        (
            "odd: red mat. even: blue mat. digits 1 2 3 4 5 6",
            "Put the blocks 1, 3 and 5 on the red patch. Put the blocks 2, 4 and 6 on the blue patch.",
        ),
        (
            "Sort the vowels onto the pink mat and everything else onto the gray mat: A E B C",
            "Put the blocks A and E on the pink patch. Put the blocks B and C on the gray patch.",
        ),
        (
            "All cubes bearing a vowel (A, E, I) are to be deposited on the green target, and all those bearing a "
            "consonant (B, C, D) on the red target.",
            "Put the blocks A, E and I on the green patch. Put the blocks B, C and D on the red patch.",
        ),
        (
            "every red block goes on the red patch and every yellow block goes on the yellow patch there are two red "
            "and three yellow",
            "Put the 2 red blocks on the red patch. Put the 3 yellow blocks on the yellow patch.",
        ),
        (
            "reds on red mat, blues on blue mat, 3 each",
            "Put the 3 red blocks on the red patch. Put the 3 blue blocks on the blue patch.",
        ),
        (
            "Two red, one blue, match each block with the mat of its colour",
            "Put the 2 red blocks on the red patch. Put the blue block on the blue patch.",
        ),
        (
            "Let every cube be transferred to the patch sharing its color: three yellow cubes, two purple cubes.",
            "Put the 3 yellow blocks on the yellow patch. Put the 2 purple blocks on the purple patch.",
        ),
        (
            "all yellow to yellow zone and all pink to pink zone. yellow 3 pieces, pink 2 pieces",
            "Put the 3 yellow blocks on the yellow patch. Put the 2 pink blocks on the pink patch.",
        ),
        (
            "for every color one patch. put cube on patch of own color. 2 red 2 green",
            "Put the 2 red blocks on the red patch. Put the 2 green blocks on the green patch.",
        ),
    ],
)
def test_parts_are_put_together(text: str, plain: str) -> None:
    assert told(text) == plain


@pytest.mark.parametrize(
    "text",
    [
        "each block on the mat that does not match its colour: red, blue",
        "every block but one on the patch of its colour: 2 red, 2 blue",
        "Everything but the green block goes on the red patch.",
        "Line up A, B and C, standing on the green patch.",
        "only the red ones on the red mat, 2 red, 2 blue",
        "exactly two of the digits 1, 2, 3 on the red patch",
        "odd digits on the red patch, even digits on the red patch: 1, 2, 3, 4",
        "even digits on the red patch or the blue patch: 2, 4",
        "the reds on the red mat, 2 red, 2 blue",
        "all vowels on the red mat: A, E, B",
        "the red ones on the red mat and the blue ones on the green: 2 red, 2 blue, 2 green",
        "Is every block on the patch of its colour? 2 red, 2 blue",
        "Each block on the mat of its colour: two red and one green block, a red mat and a blue mat",
    ],
)
def test_what_is_not_clear_is_not_told(text: str) -> None:
    assert told(text) is None
