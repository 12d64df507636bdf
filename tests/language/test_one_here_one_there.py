"""Structures that are counted, and each told of a place of its own."""

from __future__ import annotations

import pytest

from rpg.blocks.english import describe
from rpg.passes.schema.frontend import BuiltinFrontEnd


@pytest.mark.parametrize("other", ["one", "the other", "the other one"])
def test_each_of_two_towers_has_its_place(other: str) -> None:
    task, notes = BuiltinFrontEnd().read(f"Two towers of three, one in the left half and {other} in the right half.")
    assert task is not None, notes
    told = describe(task)
    assert "Red block 1, red block 2 and red block 3 must be in the left half of the table." in told
    assert "Red block 4, red block 5 and red block 6 must be in the right half of the table." in told


def test_one_of_them_is_no_further_tower() -> None:
    task, notes = BuiltinFrontEnd().read("Build two towers of three, one of them on the mat.")
    assert task is None
    assert notes[0].code == "ambiguous"
