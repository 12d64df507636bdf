"""What blocks are made of is left out where it tells no two of them apart; else it is asked about."""

from __future__ import annotations

import pytest

from rpg.passes.schema.ambiguity import same
from rpg.passes.schema.frontend import BuiltinFrontEnd

LEFT_OUT = [
    ("build a tower of three wooden red blocks", "build a tower of three red blocks"),
    ("Put the red wooden cube on the blue wooden cube.", "put the red block on the blue block"),
    ("put the red lego brick on the blue one", "put the red block on the blue block"),
    ("The red wooden block must not touch the wooden blue ones, there are two.",
     "The red block must not touch the blue ones, there are two."),
    ("stack three toy cubes", "stack three cubes"),
    ("Arrange the wooden blocks A, B and C in a row.", "Arrange the blocks A, B and C in a row."),
    ("Put the wooden block on the red mat.", "Put the block on the red mat."),
    ("put the red block on the blue felt mat", "put the red block on the blue mat"),
]  # fmt: skip
TELLS_APART = [
    "put the wooden block on the plastic block",
    "Put the wooden block on the red block.",
    "put the wooden block on the red one",
    "put the red wooden block on the red plastic block",
    "Stack the wooden cubes, not the red ones.",
    "the blocks should not be wooden",
]


@pytest.mark.parametrize(("said", "plainly"), LEFT_OUT)
def test_left_out(said: str, plainly: str) -> None:
    task, _ = BuiltinFrontEnd().read(said)
    expected, _ = BuiltinFrontEnd().read(plainly)
    assert task is not None and expected is not None and same(task, expected)
    assert any(note.startswith("what things are made of or serve for") for note in task.assumptions)


@pytest.mark.parametrize("said", TELLS_APART)
def test_tells_apart(said: str) -> None:
    assert BuiltinFrontEnd().read(said)[0] is None
