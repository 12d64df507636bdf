"""Lists and loops as they stand in code."""

from __future__ import annotations

import pytest

from tests.language.meaning import code_of, means


@pytest.mark.parametrize(
    ("typed", "meant"),
    [
        ("Sort [9, 5, 1, 7] ascending, left to right.", "Sort 9, 5, 1, 7 ascending, left to right."),
        ("Place [red, blue] on the gray mat.", "Place red, blue on the gray mat."),
        ('Line up ["red", "green", "blue"].', "Line up red, green, blue."),
        ("row = A, B, C", "A row: A, B, C"),
        ("tower = [red, green, blue], bottom to top", "A tower of red, green and blue, from bottom to top"),
        (
            "for each color in (red, green): put the small cube on top of the big cube of that color",
            "Put the small red cube on top of the big red cube. Put the small green cube on top of the big green cube.",
        ),
        (
            "for each color in [red, green]: put the cube of that color on the mat of that color",
            "Put the red cube on the red mat. Put the green cube on the green mat.",
        ),
        ("for each letter in (A, B): put it on the gray mat", "Put A on the gray mat. Put B on the gray mat."),
        ("Make 2 + 3 = 5.", "Build the equation 2 + 3 = 5."),
    ],
)
def test_a_list_is_read_as_in_a_sentence(typed: str, meant: str) -> None:
    """Brackets and the sign behind a name are no blocks."""
    assert means(typed) == means(meant)


def test_a_loop_in_which_nothing_changes_is_not_understood() -> None:
    """Nothing is told of the colours, one by one."""
    assert code_of("for each color in (red, green): put the cube on the table") == "misplaced-word"
