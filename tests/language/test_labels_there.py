"""Which symbols and kinds there are, told behind what is asked for."""

from __future__ import annotations

import pytest

from tests.language.meaning import means


@pytest.mark.parametrize(
    ("text", "there"),
    [
        ("All letters except X go on the purple patch (letters in the test: V, X, Y, Z).", "V, X, Y and Z"),
        ("All letters except X go on the purple patch (the letters are V, X, Y, Z).", "V, X, Y and Z"),
        ("All letters except X go on the purple patch, the letters being V, X, Y and Z.", "V, X, Y and Z"),
    ],
)
def test_letters_in_brackets_are_there(text: str, there: str) -> None:
    assert means(text) == means(f"There are the letters {there}. All letters except X go on the purple patch.")


def test_what_is_there_and_not_asked_for_is_a_distractor() -> None:
    told = means("Put the largest number on the mat (numbers: 3, 7, 5).")
    assert "The 7 block must be on the gray patch" in told
    assert "a 3 block and a 5 block as distractors" in told


def test_letters_behind_a_comma_are_in_no_group_of_those_before() -> None:
    told = means("Check that the vowels are kept separate from the consonants, letters are A, E, K and L.")
    assert told == means("Separate the vowels from the consonants. The letters are A, E, K and L.")


def test_numbers_that_are_known() -> None:
    told = means("We know the numbers 1, 2 and 3. Line them up in ascending order from left to right.")
    assert told == means("Line up the numbers 1, 2 and 3 in ascending order from left to right.")


@pytest.mark.parametrize(
    "text",
    [
        "Sort three letters, two digits and two plain cubes by kind.",
        "What about sorting by kind, i.e. three letters, two digits and two plain cubes in separate groups?",
    ],
)
def test_kinds_that_are_counted_are_so_many(text: str) -> None:
    told = " ".join(means(text).split())
    assert "an A block, a B block, a C block, a 1 block, a 2 block and a red block. There is also a blue block" in told
    assert "sorted by kind into three groups" in told
