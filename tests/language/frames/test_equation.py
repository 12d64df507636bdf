"""Equations told part by part, in whatever order and syntax."""

from __future__ import annotations

import pytest

from tests.language.frames.told import told


@pytest.mark.parametrize(
    ("text", "plain"),
    [
        ("Build the equation 2+3=5 out of cubes.", "Make the equation 2+3=5."),
        (
            "Make a correct addition with the digits 1, 2, 3, plus and equals.",
            "Make a true equation from 1, 2, 3, + and =.",
        ),
        ("use 7 - 4 = 3 and put them as an equation in a row", "Make the equation 7-4=3."),
        (
            "Lay out a true subtraction using the cubes 9, 4, 5, minus and equals.",
            "Make a true equation from 9, 4, 5, - and =.",
        ),
        ("write 6 divided by 2 equals 3 with blocks", "Make the equation 6/2=3."),
        (
            "take the blocks 2, 2, 4, + and = and make an equation that is right",
            "Make a true equation from 2, 2, 4, + and =.",
        ),
        ("I want three times two equals six, in blocks, in a row", "Make the equation 3*2=6."),
        (
            "Create a valid equation using each of the following cubes once: 8, 3, 5, minus, equals.",
            "Make a true equation from 8, 3, 5, - and =.",
        ),
        ("line up blocks so they read 6 = 2 x 3", "Make the equation 6=2*3."),
        (
            "Using the digits 2, 3 and 6 together with a multiplication sign and an equals sign, form a true equation.",
            "Make a true equation from 2, 3, 6, * and =.",
        ),
        ("With 1, 5, 6, + and = show a right sum.", "Make a true equation from 1, 5, 6, + and =."),
        ("The equation 4 + 4 = 8, written from top to bottom.", "Make the equation 4+4=8 from top to bottom."),
        (
            "use the numbers one four and five to make a correct addition equation",
            "Make an addition from the digits 1, 4, 5.",
        ),
        (
            "Produce a correct multiplication using the digit cubes 2, 3 and 6 together with the operator cubes * "
            "and =.",
            "Make a true equation from 2, 3, 6, * and =.",
        ),
    ],
)
def test_parts_are_put_together(text: str, plain: str) -> None:
    assert told(text) == plain


@pytest.mark.parametrize(
    "text",
    [
        "Make a wrong equation from 1, 2, 3, + and =.",
        "Make an equation from 1, 2, 3, + and = that is not true.",
        "Make an addition and a subtraction from 1, 2, 3, +, - and =.",
        "Make the equation 2+3=5 without the 3.",
        "Make 2+3=5 or 3+2=5.",
        "Make an equation.",
        "Make an addition from 1, 2, 3, - and =.",
        "Make 2+3=5, then 5-3=2.",
        "Make a true equation from some of 1, 2, 3, + and =.",
        "Is 2+3=5?",
        "Make an equation from 1, 2 and 3.",
        "Make 2+3=5 from 1, 2, 3, + and =.",
        "make an equation that is false with 1, 2, 4, + and =",
    ],
)
def test_what_is_not_clear_is_not_told(text: str) -> None:
    assert told(text) is None
