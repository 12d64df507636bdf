"""How cubes are turned, told in the middle of something else."""

from __future__ import annotations

import pytest

from rpg.language.frames.around.beside import stopped
from rpg.language.frames.around.turned import without_turns
from tests.language.frames.told import words


def told(text: str) -> tuple[str, str] | None:
    """What is left of a text, and what is told of turns; None where nothing is."""
    for rest, _, said in without_turns(words(text)):
        return " ".join(token.raw for token in stopped(rest, rest[0])) if rest else "", said
    return None


@pytest.mark.parametrize(
    ("text", "rest", "said"),
    [
        ("The word CAR, but its A has to be upside down.", "The word CAR", "The A block must be upside down."),
        ("Line up K, L and M, the L on its side", "Line up K , L and M", "The L block must be sideways."),
        (
            "R next to P, with the R upright and the P given a quarter turn clockwise as seen from above.",
            "R next to P",
            "The R block must be upright. The P block must be turned by 90 degrees clockwise.",
        ),
        ("Spell HAT, all letters upside down.", "Spell HAT", "All letters must be upside down."),
        ("write cap but the p is upside down", "write cap", "The P block must be upside down."),
        ("Spell TOP and turn only its middle letter upside down.", "Spell TOP",
         "Only the O block must be upside down."),
        (
            "A, B and C in a row with the B upside down, the other two normal.",
            "A , B and C in a row",
            "The B block must be upside down. The A block must be upright. The C block must be upright.",
        ),
        ("I want the F cube to show its letter rotated 90 degrees counterclockwise from upright", "",
         "The F block must be turned by 90 degrees counterclockwise."),
        ("Make the letters L and F upright and readable, L left of F.", "L left of F",
         "The L block must be upright. The F block must be upright."),
        ("W on the table, upside down for me when I look at its top", "W on the table",
         "The W block must be upside down."),
        ("Put R on the mat and rotate it by 90° clockwise", "Put R on the mat",
         "The R block must be turned by 90 degrees clockwise."),
    ],
)  # fmt: skip
def test_turns_are_told_by_themselves(text: str, rest: str, said: str) -> None:
    assert told(text) == (f"{rest} .".strip(" .") + " ." * bool(rest), said)


@pytest.mark.parametrize(
    "text",
    [
        "The letters L and F upright and readable or not, L left of F.",
        "Put R on P, and turn it upside down.",  # which of them?
        "Spell MAMA with its first letter upside down.",  # there are two of it
        "Spell NOON with the middle letter upside down.",
        "The A must not be upside down.",
        "A is upside down or upright.",
        "A upright, A upside down.",
        "Spell CAT. Only the C and the A are upside down.",
        "Turn the red block by 45 degrees.",
        "Turn the A if it is upside down.",
        "Spell CAT with the A as upside down as the T.",
    ],
)
def test_turns_that_are_not_clear_are_left_as_they_are(text: str) -> None:
    assert told(text) is None
