"""How the work is done and what sort of task it is are left out with a note; what could be meant of blocks is not."""

from __future__ import annotations

import pytest

from rpg.ir.schema import TaskSchema
from rpg.passes.schema.ambiguity import same
from rpg.passes.schema.frontend import BuiltinFrontEnd

TASK = "Build a tower of two red blocks and one blue block."
LEFT_OUT = [
    "Work slowly.", "Use the left arm.", "Use one hand only.", "Be gentle with it.", "Don't drop anything.",
    "You have two minutes.", "You have 2 minutes.", "There is no time limit.", "It must not fall over.",
    "The tower should be stable at the end.", "The gripper must be open at the end.", "The blocks are fragile.",
    "Precision matters here.", "The order in which you do it does not matter.", "How you do it is up to you.",
    "This is a simple pick and place test.", "It is a stacking task.", "This task tests precision.",
    "Today we practise stacking.", "It doesn't need to be perfect.", "Our lab meeting starts in ten minutes.",
    "There is nothing else on the table.",
]  # fmt: skip
NOT_LEFT_OUT = [
    "They must stand on their own.", "It should stay there.", "It must remain where it is.", "The tower must fall.",
    "Do not use the blue block.", "Do not drop it on the mat.", "It does not need to be straight.",
    "The blocks are all the same colour.", "The blocks are round.", "The blocks are tiny.",
    "The order in which you stack them does not matter much.", "The result is palindromic.", "The base is narrower.",
    "The pieces zigzag.", "Our formation is V-shaped.", "The gripper must be on the mat at the end.",
    "Work from left to right.", "Make it tall.", "You have three patches.", "This is a mirrored task.",
    "There are no other blocks on the patch.", "Otherwise stack them.",
]  # fmt: skip


def read(text: str) -> TaskSchema | None:
    return BuiltinFrontEnd().read(text)[0]


@pytest.mark.parametrize("said", LEFT_OUT)
def test_left_out(said: str) -> None:
    task = read(TASK)
    assert task is not None
    for text in (f"{TASK} {said}", f"{said} {TASK}"):
        found = read(text)
        assert found is not None and same(found, task), text


@pytest.mark.parametrize("said", NOT_LEFT_OUT)
def test_not_left_out(said: str) -> None:
    task = read(TASK)
    found = read(f"{TASK} {said}")
    assert task is not None
    assert found is None or not same(found, task)


def test_the_note_says_what_was_left_out() -> None:
    task = read(f"{TASK} Use the left arm.")
    assert task is not None
    assert "left out, for it is how the work is done: 'Use the left arm'" in task.assumptions
