"""Blocks that lie about and are not meant, and leave to move a block, which asks for nothing."""

from __future__ import annotations

import pytest

from tests.language.meaning import code_of, means

WHITE_ON_BLACK = "The white block must be on the black block."
BROWN = f"There are a white block and a black block. There are also two brown blocks as distractors.\n{WHITE_ON_BLACK}"


@pytest.mark.parametrize(
    "text",
    (
        "hey can you put the white block on the black one pls? there are two brown ones lying around too, just ignore "
        "them",
        "There are also two brown blocks lying around, ignore them. Put the white block on the black one.",
        "Put the white block on the black one. There are two brown blocks on the table. They don't matter.",
        "Put the white block on the black one. You will also see two brown blocks, but don't use them.",
        "Put white on black. Ignore everything else on the table: two brown blocks.",
        "Put white on black. Extra objects: two brown blocks.",
    ),
)
def test_what_lies_about_is_not_meant(text: str) -> None:
    assert means(text).replace("\n", " ") == BROWN.replace("\n", " ")


def test_one_of_several_lots_is_not_all_of_them() -> None:
    assert code_of("Put green on blue. There are two red blocks and a brown one, ignore it.") == "contradiction"
    stay = means("There are two brown blocks. Don't touch them. Put red on blue.")
    assert "The two brown blocks must stay where they are." in stay


@pytest.mark.parametrize(
    "text",
    (
        "You may move the blue block but not the red one. At the end blue must be left of red.",
        "The robot is allowed to move blue but not red. Blue must be left of red.",
        "Blue must be left of red. Blue may be moved, but red must stay where it is.",
    ),
)
def test_leave_to_move_asks_for_nothing(text: str) -> None:
    told = means(text)
    assert "The red block must stay where it is." in told
    assert "The blue block must be to the left of the red block." in told
    assert "moved" not in told


def test_leave_alone_is_not_asked_for() -> None:
    code_of("You may move the blue block. Put the red block on the yellow block.")
    told = means("You can move the blue block to the left of the red one.")
    assert "The blue block must be to the left of the red block." in told
    only = "There are a red and a blue block. You may only move the red block. Red must be left of blue at the end."
    assert "The blue block must stay where it is." in means(only)


def test_the_cubes_are_those_that_are_listed() -> None:
    told = means(
        "Stack the cubes only after the black cube has been moved to the far left corner. The cubes are red and blue."
    )
    assert "Then, the red and blue blocks must be stacked." in told
    told = means("Put the black cube on the mat. The other cubes are red and blue. Stack them.")
    assert "The red and blue blocks must be stacked." in told


def test_its_place_is_not_exchanged() -> None:
    told = means("There are a red and a green block. Each block must change its position.")
    assert "must be moved" in told and "swap" not in told
    assert "swap" in means("The red and the green block should change their places.")


def test_what_a_mat_is_cleared_of_is_there_at_first() -> None:
    told = means("First clear the patch: a gray block is lying on it. Then put the white block there.")
    assert "At the start, the gray block is on the gray patch." in told
    assert "First, the gray patch must be empty. Then, the white block must be on the gray patch." in told
    assert "must be on the blue block" in means("Get this done: red is on blue and green is on yellow.")
