"""What is told of blocks with others: the same mat as another's, on each of several towers, spread out, in one word."""

from __future__ import annotations

import pytest

from tests.language.meaning import code_of, means


@pytest.mark.parametrize(
    "text",
    [
        "The red block should be on the same mat as the blue one.",
        "Put the red block on the same mat as the blue one.",
        "The red block is on the same patch as the blue block.",
        "Put the red block on the same patch where the blue one is.",
    ],
)
def test_the_same_mat_as_another_is_one_mat(text: str) -> None:
    assert "There is a gray patch. The red and blue blocks must be on the gray patch." in means(text)


def test_the_same_mat_as_several_and_one_of_a_color() -> None:
    told = means("Put the red block on the same mat as the blue block and the green one.")
    assert "The red, blue and green blocks must be on the gray patch." in told
    assert "must be on the red patch" in means("Put A on the same red mat as B.")


@pytest.mark.parametrize("have", ["should each have", "each get", "must have each"])
def test_towers_of_so_many_that_have_one_more_on_top(have: str) -> None:
    told = means(f"The two red towers of two {have} a blue block on top.")
    assert "There are four red blocks and two blue blocks." in told
    assert "must be on the tower of red block 3 and red block 4" in told


@pytest.mark.parametrize(
    "text",
    [
        "Spread the letters A, B and C out on the mat.",
        "Spread out the letters A, B and C on the mat.",
        "A, B and C should be spread out on the mat.",
        "Spread A, B and C out on the table.",
        "Spread A, B and C out over the table.",
    ],
)
def test_what_is_spread_out_somewhere_is_apart(text: str) -> None:
    assert "The A block must be apart from the C block." in means(text)


def test_what_is_spread_out_in_a_row_is_a_row() -> None:
    assert "apart" not in means("Spread the four red blocks out in a row on the table.")


@pytest.mark.parametrize(
    "text",
    [
        "Spell GO with the G on top of the O.",
        "Write OK with the O above the K.",
        "Spell ON with the N in front of the O.",
        "Spell GO. The G should be on the O.",
        "Write 1+2=3 with the 1 on top of the 2.",
    ],
)
def test_letters_of_a_word_in_a_row_are_on_one_level(text: str) -> None:
    assert code_of(text) == "contradiction"


def test_letters_of_a_word_in_a_stack_and_other_blocks_on_them() -> None:
    assert "in a tower. The O block must be on the K block." in means("Spell OK in a stack with the O on the K.")
    assert "The red block must be on the O block." in means("Spell DOG with a red block on the O.")
    assert "Then, the G block must be on the O block." in means("Spell GO, then put the G on the O.")
