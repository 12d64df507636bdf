"""What is on top: told of the tower or the mat that something is put on, or to lie on what is put there."""

from __future__ import annotations

import pytest

from rpg.blocks.english import describe
from rpg.passes.schema.frontend import BuiltinFrontEnd


@pytest.mark.parametrize(
    ("text", "code"),
    [
        ("Place a yellow block on the stack that has the blue block on top.", "support-cycle"),
        ("Put the yellow block on the stack whose top block is blue.", "support-cycle"),
        ("Put the yellow block on the stack which has a blue block on top.", "ambiguous"),
        ("Put the green block on the tower of three with the red top.", "support-cycle"),
        ("Add a green block to the tower with the red block on top.", "support-cycle"),
        ("Put the yellow block on the tower, with the blue block on top.", "support-cycle"),
        ("Put the red block on the mat with the blue block on it.", "ambiguous"),
    ],
)
def test_which_tower_or_mat_it_is_or_what_lies_on_it_is_asked(text: str, code: str) -> None:
    task, notes = BuiltinFrontEnd().read(text)
    assert task is None, describe(task)
    assert notes[0].code == code


@pytest.mark.parametrize(
    ("text", "found"),
    [
        ("There is a tower of red and green. Put the yellow block on the tower with the blue block on top.",
         "The blue block must be on the yellow"),
        ("Put the red block on the red patch with the green block on top of it.", "The green block must be on the red"),
        ("Put the red block on the mat. Put the blue block on the red block.", "The blue block must be on the red"),
        ("Build a tower with the blue block on top.", "with the blue block on top"),
    ],
)  # fmt: skip
def test_what_lies_on_what_is_put_there(text: str, found: str) -> None:
    task, notes = BuiltinFrontEnd().read(text)
    assert task is not None, notes
    assert found in describe(task)
