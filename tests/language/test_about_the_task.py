"""What is told of the task itself is left out with a note; what could be told of blocks is not."""

from __future__ import annotations

import pytest

from rpg.passes.schema.frontend import BuiltinFrontEnd
from tests.language.meaning import assert_means

_RED_ON_BLUE = {"assets": {"red": 1, "blue": 1}, "hold": ["blue^red"], "miss": ["red^blue", "red blue"]}
OF_THE_TASK = [
    "The task has two stages.",
    "The initial poses are random.",
    "The episode ends after 30 seconds.",
    "The agent gets one try.",
    "This is stage two of the curriculum.",
    "The solution is unique.",
    "The camera sees everything.",
    "No reward is given for partial success.",
    "Any order is OK.",
    "Position is free.",
    "Does the policy generalize to spelling?",
    "Can the policy do this?",
]


@pytest.mark.parametrize("text", OF_THE_TASK)
def test_it_is_left_out_with_a_note(text: str) -> None:
    for whole in (f"{text} Put red on blue.", f"Put red on blue. {text}"):
        assert_means(whole, _RED_ON_BLUE)
    task, _ = BuiltinFrontEnd().read(f"Put red on blue. {text}")
    assert task is not None and any(note.startswith("left out") for note in task.assumptions)


@pytest.mark.parametrize(
    "text",
    [
        "Put red on blue. The outcome is reversed.",
        "Put red on blue. The solution must be stable.",
        "Put red on blue. The result is mirrored.",
        "Put red on blue. The episode ends with a tower.",
        "Put red on blue. Any order is reversed.",
        "Put red on blue. Could the agent lift the green one?",
    ],
)
def test_what_could_be_of_blocks_is_not_left_out(text: str) -> None:
    task, _ = BuiltinFrontEnd().read(text)
    assert task is None or not any(note.startswith("left out") for note in task.assumptions)
