"""Texts of which a part is told again: distractors, the start and the end, sentences beside a figure."""

from __future__ import annotations

import pytest

from rpg.language.frames import retold
from rpg.passes.schema.frontend import BuiltinFrontEnd
from tests.language.frames.told import words


def first(text: str) -> str | None:
    return next((said for _, said in retold(words(text))), None)


@pytest.mark.parametrize(
    ("text", "plain"),
    [
        (
            "Place red left of blue; also add three gray distractor cubes that play no role.",
            "Place red left of blue. There are also 3 gray blocks as distractors.",
        ),
        (
            "Red on blue, with one gray and one pink distractor on the table.",
            "Red on blue. There are also one gray and one pink block as distractors.",
        ),
        ("red on blue plus a pink decoy", "red on blue. There are also a pink block as distractors."),
        (
            "Initial config: red on blue. Target config: blue on red.",
            "At the start, red on blue. blue on red.",
        ),
        (
            "The episode starts with red on blue and ends with blue on red.",
            "At the start, red on blue. blue on red.",
        ),
    ],
)
def test_parts_are_led_to_in_plain_words(text: str, plain: str) -> None:
    assert first(text) == plain


@pytest.mark.parametrize(
    "text",
    [
        "put red on blue. The red block is a distractor.",
        "Spell CAT. Begin with the T.",
        "Layout: red on blue. Goal: green next to blue.",  # is the first of the start?
        "Build a tower of red and blue. Build another tower of red and blue.",
    ],
)
def test_what_is_bound_together_is_left_alone(text: str) -> None:
    assert first(text) is None


def test_how_it_was_understood_is_noted() -> None:
    task, _ = BuiltinFrontEnd().read("tower: bottom: red, top: blue, red below, with a pink decoy")
    assert task is None or any(note.startswith("understood as: ") for note in task.assumptions)


@pytest.mark.parametrize(
    "text",
    [
        "Build a row of a red, a green and a blue block. There is also a yellow block.",
        "Build a row of a red, a green and a blue block. There is a yellow block.",
        "Make a circle of six blue blocks. There are also two yellow blocks.",
    ],
)
def test_what_there_is_besides_is_no_part_of_the_figure(text: str) -> None:
    for _, said in retold(words(text)):
        assert said.endswith(text.rpartition("There")[2]), said


def test_a_place_is_asked_for_ahead_of_a_command() -> None:
    assert first("A tower of two red blocks on the blue patch, and behind the tower a green block.") == (
        "Build a tower from 2 red blocks. The tower must be on the blue patch. Put a green block behind the tower."
    )
