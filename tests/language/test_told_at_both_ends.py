"""Two blocks at both ends of a stack: whichever of them is on top, as those of a row may be either way round."""

from __future__ import annotations

import pytest

from tests.language.meaning import means


@pytest.mark.parametrize(
    ("text", "one", "other"),
    [
        ("Stack 1 to 4 with an even one at both ends.", "2", "4"),
        ("Stack 1 to 4 with an odd one at each end.", "1", "3"),
        ("Stack A, B, C and E with vowels at the ends.", "A", "E"),
        ("Make a tower of 1 to 4 with an even one at both ends.", "2", "4"),
        ("Stack 1 to 4 with 2 and 4 at the ends.", "2", "4"),
    ],
)
def test_either_of_the_two_may_be_on_top(text: str, one: str, other: str) -> None:
    told = means(text)
    assert f"with the {one} block at the bottom and the {other} block on top" in told
    assert f"with the {other} block at the bottom and the {one} block on top" in told


def test_two_that_look_alike_are_in_one_order() -> None:
    told = means("Stack three red and two blue blocks with a blue one at both ends.")
    assert told.count("must be stacked") == 1
    assert "a blue block, then the three red blocks, then a blue block" in told
