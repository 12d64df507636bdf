"""A word along a column of the table: from which end it is read, told by its letters, and what does not fit it."""

from __future__ import annotations

import pytest

from tests.language.meaning import code_of, means

SUN = "There are an S block, a U block and an N block. The blocks S, U and N must read S, U, N from {} to {}."
AWAY, NEARER = SUN.format("front", "back"), SUN.format("back", "front")


@pytest.mark.parametrize(
    ("text", "meaning"),
    [
        ("Spell SUN in a column on the table, with the S nearest to me.", AWAY),
        ("Spell SUN in a column, with the N closest to the viewer and the S at the back.", NEARER),
        ("Lay SUN out in a column, with the last letter farthest away.", AWAY),
        ("The letters of the word SUN in a column on the table.", NEARER),
        ("Spell SUN in a column, beginning at the near end.", AWAY),
        ("Spell SUN in a column with the N at the front and the U upside down.",
         f"{NEARER} The U block must be upside down."),
    ],
)  # fmt: skip
def test_the_end_at_which_it_begins(text: str, meaning: str) -> None:
    assert means(text).replace("\n", " ") == meaning


@pytest.mark.parametrize(
    ("text", "code"),
    [
        ("Spell SUN in a column, with the U nearest to me.", "contradiction"),
        ("Spell SUN in a column, with the S nearest to me and the N at the front.", "contradiction"),
        ("Spell SUN in a column from back to front, with the S nearest to me.", "contradiction"),
        ("Spell SUN from front to back.", "misplaced"),
        ("The letters of the word SUN in a column.", "ambiguous"),  # down a tower, or away along the table?
    ],
)
def test_ends_that_do_not_fit(text: str, code: str) -> None:
    assert code_of(text) == code
