"""Misspelt words that several known ones are near to: the one that makes sense is meant."""

from __future__ import annotations

import pytest

from rpg.passes.schema.frontend import BuiltinFrontEnd
from tests.language.meaning import code_of, means


@pytest.mark.parametrize(
    ("typed", "meant"),
    [
        ("pt the red blok on teh blue blok", "put the red block on the blue block"),
        ("make a row of grean, yelow and purpel", "make a row of green, yellow and purple"),
        (
            "put al the blocks on the balck mat. threre are 2 red 2 white",
            "put all the blocks on the black mat. there are 2 red, 2 white",
        ),
        (
            "move the yelow block so its behnd the green block nd not tuching it",
            "move the yellow block so it is behind the green block and not touching it",
        ),
        ("put the red block too the left of the blue block", "put the red block to the left of the blue block"),
        ("put orange to the luft of pink", "put orange to the left of pink"),
        ("group the digits 0, 1, 2, 3 into odd and eben", "group the digits 0, 1, 2, 3 into odd and even"),
        ("put ared block onthe blue one", "put a red block on the blue one"),
    ],
)
def test_the_word_that_makes_sense_is_meant(typed: str, meant: str) -> None:
    """It is read as if it had been typed right."""
    assert means(typed) == means(meant)


def test_it_is_told_how_a_word_is_read() -> None:
    """The task is one of the text that was typed."""
    task, _ = BuiltinFrontEnd().read("pt the red blok on the blue block")
    assert task is not None
    assert task.instruction == "pt the red blok on the blue block"
    assert task.assumptions[:2] == ("read 'pt' as 'put'", "read 'blok' as 'block'")


@pytest.mark.parametrize(
    ("text", "code"),
    [
        ("put thre red blocks on the blue mat", "unknown-word"),  # three, or the red ones?
        ("no two blucks next to each other", "unknown-word"),  # blocks, or blacks?
        ("put the range block on the blue block", "unknown-word"),  # an ordinary word is no slip
        ("put the thin block on the blue block", "unknown-word"),
    ],
)
def test_what_may_mean_two_things_is_asked_about(text: str, code: str) -> None:
    """Nothing is guessed where two words make sense, or where another one is meant."""
    assert code_of(text) == code
