"""A number right behind a line, with the lots that make it up behind a comma."""

from __future__ import annotations

import pytest

from tests.language.meaning import code_of, means


@pytest.mark.parametrize(
    "text", ["row of 4, 2 red 2 blue", "a row of 4, 2 red and 2 blue", "a line of four, two red, two blue"]
)
def test_the_number_is_that_of_all(text: str) -> None:
    assert means(text).startswith("There are two red blocks and two blue blocks.")


def test_other_numbers_are_shown() -> None:
    assert "The blocks 6, 5 and 2 must be in a row." in means("a row of 6, 5 and 2")
    assert code_of("a row of 5, 3 red") == "count-mismatch"
