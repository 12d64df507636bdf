"""Symbols told by their class, or by where they stand among digits and letters, with those that there are behind."""

from __future__ import annotations

import pytest

from tests.language.meaning import code_of, means


@pytest.mark.parametrize(
    ("text", "goals"),
    [
        ("The odd numbers form a row, the even numbers a tower: 1 to 6.",
         "The blocks 1, 3 and 5 must be in a row. The blocks 2, 4 and 6 must be stacked."),
        ("The vowels are in a tower with A at the top; the consonants in a row: A, E, B, C, D.",
         "The blocks A and E must be stacked from bottom to top in the order E, A. The blocks B, C and D must be"),
        ("The digits below 5 are stacked, the others are on the mat: 2, 3, 7, 8.",
         "The blocks 2 and 3 must be stacked. The blocks 7 and 8 must be on the gray patch."),
        ("The letters that come after M are on the patch: K, L, P, Q.",
         "The blocks P and Q must be on the gray patch."),
        ("The letters before M are in a row, the letters after M in a tower: A, B, X, Y.",
         "The blocks A and B must be in a row. The blocks X and Y must be stacked."),
        ("Put 3 below 5.", "The 5 block must be somewhere above the 3 block."),
    ],
)  # fmt: skip
def test_classes(text: str, goals: str) -> None:
    assert goals in means(text).replace("\n", " ")


def test_after_tells_of_a_time() -> None:
    assert code_of("The letters after A are B and C.") == "misplaced"
    assert "First, the A block must be on" in means("Put B and C on the mat after A is on the mat.")
