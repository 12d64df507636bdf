"""The second account: a task that lost something which was said is not taken for what was said."""

from __future__ import annotations

import pytest

from rpg.ir.schema import TaskSchema
from rpg.language.spelling import read_words
from rpg.language.tokens import Token, tokenize
from rpg.passes.schema.evidence import unfounded
from rpg.passes.schema.frontend import BuiltinFrontEnd


def words(text: str) -> list[Token]:
    return read_words(tokenize(text)[0])[0]


def read(text: str) -> TaskSchema:
    task, diagnostics = BuiltinFrontEnd().read(text)
    assert task is not None, diagnostics
    return task


LOST = [
    ("put the red block on the blue block", "put the red and the green block on the blue block", "green"),
    ("put the red block on the blue patch", "put the red block on the blue patch; there is a white patch", "white"),
    ("put the letter T on the red block", "put the letter T on the red block and the digit 7 on it", "digit"),
    ("put the letter T on the red block", "put the letter T on the letter K", "K"),
    ("a row of four blocks", "a row of four blocks with gaps of 3 cm", "3"),
    ("a tower of three blocks", "two towers of five blocks", "two"),
    ("a tower of three blocks", "a tower of five blocks", "five"),
    ("put six white blocks on the green patch", "put six white blocks in lots of three on the green patch", "three"),
    ("a row of the blocks D, B and A in this order", "the row D, B, A in alphabetical order", "alphabetical"),
    ("a row of two red and two blue blocks", "a row of two red and two blue blocks, mirrored", "mirrored"),
    ("the red block and the blue block touch", "swap red and blue; they touch", "swap"),
]


@pytest.mark.parametrize(("less", "said", "lost"), LOST)
def test_what_was_lost_is_found(less: str, said: str, lost: str) -> None:
    token = next(unfounded(words(said), read(less)), None)
    assert token is not None
    assert token.raw == lost


@pytest.mark.parametrize(
    "said",
    [
        "put the red block 12 cm from the blue block",
        "put the red block about four inches from the blue block",
        "turn the letter B by 90 degrees clockwise",
        "put all but three of the five red blocks in a row",
        "cyan on pink, with 3 distractors",
        "write the word CAT",
        "make 2 + 3 = 5 out of number blocks",
        "build a 3x4 wall of green blocks with edges of 5 cm",
        "sort the letters A to F by vowel and consonant",
        "put the four blocks inside the green circle",
        "move the red block at least 15 cm",
        "move the red block by at least 5 cm",
        "Align N cubic blocks in a single straight horizontal line.",
        "Arrange cubes so that their up-faces read A, B, C… in alphabetical order.",
    ],
)
def test_what_was_said_is_found(said: str) -> None:
    assert not [*unfounded(words(said), read(said))]
