"""What "only" says of the other blocks: what is asked of one is denied of them, where that is clear."""

from __future__ import annotations

import pytest

from rpg.passes.schema.frontend import BuiltinFrontEnd
from tests.language.meaning import means


@pytest.mark.parametrize(
    ("place", "told"),
    [
        ("near", "near"),
        ("behind", "behind"),
        ("in front of", "in front of"),
        ("left of", "to the left of"),
        ("next to", "next to"),
        ("10 cm from", "10 cm from"),
    ],
)
def test_of_the_others_it_is_denied(place: str, told: str) -> None:
    said = means(f"There are A, B, C and D. D must be {place} only B.")
    assert f"The D block must be {told} the B block." in said
    assert f"The D block must not be {told} the A block." in said
    assert f"The D block must not be {told} the C block." in said


def test_of_those_of_a_row_too() -> None:
    said = means("Line up A, B and C from left to right with D behind only B.")
    assert "The D block must not be behind the A block. The D block must not be behind the C block." in said


def test_without_only_nothing_is_denied() -> None:
    assert "must not" not in means("There are A, B, C and D. D must be near B.")


@pytest.mark.parametrize("where", ["on the mat", "in a row", "on the table"])
def test_what_the_others_may_touch_is_asked(where: str) -> None:
    task, notes = BuiltinFrontEnd().read(f"Put A, B and C {where} with only A and B touching.")
    assert task is None
    assert notes[0].code == "ambiguous"
    said = means(f"Put A, B and C {where} with A and B touching. C must not touch A or B.")
    assert "The C block must not touch the A block. The C block must not touch the B block." in said
