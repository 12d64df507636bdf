"""Two goals on one bank: a goal judged once for both versions says what both would have said."""

from __future__ import annotations

from typing import Literal

import pytest

from rpg.blocks.centres import places_of
from rpg.ir.assets import Color, ColoredCube
from rpg.ir.goal import Row
from rpg.ir.order import Order
from rpg.ir.schema import TaskSchema
from rpg.steer.proof.bank import SIZE, Bank
from rpg.steer.proof.compare import Judge, compare
from rpg.steer.proof.identity import Identity

ORIGINS = ("first_block", "second_block", "third_block")
Kind = Literal["any", "rainbow"]
Axis = Literal["x", "y"]


def row(third: Color, by: Kind = "any", axis: Axis = "y", name: str = "third_block") -> TaskSchema:
    """Three blocks in a row; the third came into the task under one name, whatever it is called and looks like now."""
    colors: tuple[Color, ...] = ("red", "green", third)
    names = ("first_block", "second_block", name)
    assets = tuple(
        ColoredCube(name=n, color=color, origin=origin) for n, color, origin in zip(names, colors, ORIGINS, strict=True)
    )
    goal = Row(blocks=names, axis=axis, order=Order(by=by))
    return TaskSchema(name="three", instruction="three", assets=assets, goal=goal)


def test_a_recoloured_row_is_judged_once_and_for_both() -> None:
    identity = Identity(row("blue"), row("white", name="white_block"))
    bank = Bank(identity)
    old, new = Judge(bank.old, bank.new), Judge(bank.new, bank.old)
    assert bank.same
    places = places_of(bank.sizes, [sample.layout.position for sample in bank.samples])
    assert old.own(bank, places) == new.own(bank, places)
    found = compare(identity, bank)
    assert (found.relation, found.only_old, found.only_new) == ("equal", 0, 0)
    assert found.both >= 4
    assert found.states >= SIZE >= 500


@pytest.mark.parametrize(
    "before, after",
    [
        (row("blue", "rainbow"), row("orange", "rainbow")),
        (row("blue"), row("red")),
        (row("blue"), row("blue", axis="x")),
    ],
    ids=["an order of colours", "a block now like another", "another direction"],
)
def test_goals_that_may_differ_are_both_judged(before: TaskSchema, after: TaskSchema) -> None:
    assert not Bank(Identity(before, after)).same
