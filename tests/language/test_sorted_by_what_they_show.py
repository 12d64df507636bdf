"""What is sorted by what it shows, whether it is listed in that order or only told by its kind."""

from __future__ import annotations

import pytest

from tests.language.meaning import code_of, means


@pytest.mark.parametrize(
    ("text", "order"),
    [
        ("Sort the letters A, B and C in a row.", "from left to right in alphabetical order"),
        ("The letters C, A, B are sorted in a row.", "from left to right in alphabetical order"),
        ("Sort the even numbers in a row, put the odd number on the patch: 2, 4, 6, 7.",
         "The blocks 2, 4 and 6 must be in a row from left to right in ascending numerical order."),
        ("Sort the letters in a row.", "from left to right in alphabetical order"),
        ("Sort the letters in a row from left to right: C, A, B.", "from left to right in the order C, A, B"),
        ("The digits are ordered in a tower: 3, 1, 2.", "from bottom to top in the order 3, 1, 2"),
        ("Sort the cubes in a row: red, green, blue.", "from left to right in the order red, green, blue"),
    ],
)  # fmt: skip
def test_sorted(text: str, order: str) -> None:
    assert order in means(text)


def test_listed_in_another_order() -> None:
    assert code_of("The letters are sorted in a row: C, A, B.") == "ambiguous"
    assert code_of("Sort A and B.") == "ambiguous"
