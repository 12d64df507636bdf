"""What a mirror makes of lines that lie diagonally."""

from __future__ import annotations

import pytest

from rpg.ir.node import Axis, Slope
from rpg.ir.order import Order
from rpg.ir.structures import Row
from rpg.steer.operations.mirror import mirrored


@pytest.mark.parametrize(
    ("axis", "other"), [("rising", "falling"), ("falling", "rising"), ("diagonal", "diagonal"), ("y", "y")]
)
def test_a_diagonal_becomes_the_other_one(axis: Axis | Slope, other: Axis | Slope) -> None:
    left, right = (Order(by="given", ranks=(("a",), ("b",), ("c",)), first=side) for side in ("left", "right"))
    row = Row(blocks=("a", "b", "c"), axis=axis, order=left)
    assert mirrored(row) == Row(blocks=("a", "b", "c"), axis=other, order=right)
    assert mirrored(mirrored(row)) == row
