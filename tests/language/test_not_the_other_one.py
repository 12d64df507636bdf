"""What "not the green one" is behind a mat or two blocks of other colours."""

from __future__ import annotations

import pytest

from rpg.blocks.english import describe
from rpg.passes.schema.frontend import BuiltinFrontEnd
from tests.language.meaning import means


@pytest.mark.parametrize(
    "text",
    [
        "Put the red block on the blue mat, not the green one.",
        "Place A on the red mat, not the blue one.",
        "Put the red block on the blue mat but not the green one.",
        "There are a blue mat and a green mat. Put the red block on the blue mat, not the green one.",
        "There are a green block, a blue mat and a green mat. Put the red block on the blue mat, not the green one.",
    ],
)
def test_a_mat_or_a_block_is_asked(text: str) -> None:
    task, notes = BuiltinFrontEnd().read(text)
    assert task is None, describe(task)
    assert notes[0].code == "ambiguous"


def test_what_is_asked_can_be_said() -> None:
    told = means("Put the red block on the blue mat, not on the green one.")
    assert "The red block must not be on the green patch" in told
    told = means("Place A on the red mat, not on the blue one.")
    assert "The A block must not be on the blue patch" in told
    told = means("Put the red block on the blue mat, not the green block.")
    assert "The green block must not be on the blue patch" in told


def test_a_block_that_was_told_of_is_meant() -> None:
    there = "There are a red and a green block and a blue mat. "
    assert "The green block must not be on the blue patch" in means(
        f"{there}Put the red block on the blue mat, not the green one."
    )
    assert "The green block must not be on the gray patch" in means("Put the red block on the mat, not the green one.")


def test_what_is_not_between_two_is_no_distractor() -> None:
    task, _ = BuiltinFrontEnd().read(
        "Put the red block between the blue block and the green block, not the yellow one."
    )
    assert task is None
