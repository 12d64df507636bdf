"""Fields of a form that name a text, and tell nothing of it."""

from __future__ import annotations

import pytest

from tests.language.meaning import code_of, means

RED_ON_BLUE = "There are a red block and a blue block. The red block must be on the blue block."


@pytest.mark.parametrize(
    "text",
    (
        "Title: Hanoi light. Put the red block on the blue block.",
        "ID: 17. Level: easy. Put the red block on the blue block.",
        "Task name: stacking. Description: put the red block on the blue block.",
        '"Traffic light": put the red block on the blue block.',
        "Topic: stacking. Put red on blue.",
        "Task: stacking. Goal: red on blue.",
    ),
)
def test_fields_tell_nothing(text: str) -> None:
    assert means(text) == RED_ON_BLUE


def test_a_name_is_no_word_to_spell() -> None:
    told = means("Name: unstack. Start: A on B. Goal: B on A.")
    assert "spell" not in told and "The B block must be on the A block." in told


@pytest.mark.parametrize(
    "text",
    (
        "Title: reverse. The tower is red, green, blue from the bottom up.",
        "Name: red on blue. Goal: blue on green.",
        '"Red on blue": put green on yellow.',
    ),
)
def test_what_is_not_told_again_is_not_lost(text: str) -> None:
    code_of(text)
