"""What one condition of a goal overrides in another: uprightness of turned cubes, the place of raised towers."""

from __future__ import annotations

from random import Random

import pytest

from rpg.blocks.arrange import arrange
from rpg.blocks.evaluate import evaluate
from rpg.blocks.predicates.common import shift, stand_on, swap
from rpg.ir.goal import All, Not
from rpg.ir.node import Highest, Lowest
from rpg.ir.order import Order, Pattern
from rpg.ir.reconcile import reconcile
from rpg.ir.relations import Facing, On
from rpg.ir.structures import Grid, Row, Spells, Stack
from tests.blocks.structure_states import cubes, letters, plain, state, world

WORD = Spells(blocks=("s0", "s1", "s2"), word="CAT")


def test_a_turned_letter_is_excused_and_the_others_are_not() -> None:
    goal = reconcile(All(goals=(WORD, Facing(block="s1", turn=180.0))))
    assert isinstance(goal, All) and isinstance(goal.goals[0], Spells)
    assert goal.goals[0].excused == ("s1",)
    objects = world(letters("CAT"))
    for turned in arrange(goal, objects, rng=Random(0), count=2):
        assert evaluate(goal, turned)
        assert not evaluate(WORD, turned), "without the turn the word is unreadable"


def test_a_tower_on_a_block_stands_on_it_and_not_on_the_table() -> None:
    tower = Stack(blocks=("b0", "b1"))
    plain_goal = All(goals=(tower, On(a=Lowest(lowest=("b0", "b1")), b=("x",))))
    goal = reconcile(plain_goal)
    assert isinstance(goal, All) and isinstance(goal.goals[0], Stack) and goal.goals[0].raised
    objects = world(cubes(2), plain(x="blue"))
    raised = arrange(goal, objects, rng=Random(0))[0]
    assert evaluate(goal, raised) and not evaluate(tower, raised)
    assert raised.position["x"][2] < min(raised.position["b0"][2], raised.position["b1"][2])
    assert not evaluate(goal, state(objects, {"b0": (0, 0, 0), "b1": (0, 0, 1), "x": (0, 0.1)}))
    topped = reconcile(All(goals=(tower, On(a=("x",), b=Highest(highest=("b0", "b1"))))))
    assert isinstance(topped, All) and isinstance(topped.goals[0], Stack) and not topped.goals[0].raised


def test_what_overrides_nothing_changes_nothing() -> None:
    goal = All(goals=(WORD, Stack(blocks=("s0", "s1")), Facing(block="s1", turn=0.0), On(a=("s1",), b=("s0",))))
    assert reconcile(goal) == goal
    assert reconcile(WORD) is WORD
    denied = All(goals=(WORD, Not(goal=Facing(block="s1", turn=180.0)), Not(goal=On(a=("s0",), b=("x",)))))
    assert reconcile(denied) == denied


def test_a_letter_that_something_is_put_on_may_be_covered_and_the_others_may_not() -> None:
    on = On(a=("x",), b=("s1",))
    plain_goal = All(goals=(WORD, on))
    goal = reconcile(plain_goal)
    assert isinstance(goal, All) and isinstance(goal.goals[0], Spells)
    assert goal.goals[0].covered == ("s1",)
    objects = world(letters("CAT"), plain(x="blue", y="red"))
    for capped in arrange(goal, objects, rng=Random(0), count=2):
        assert evaluate(goal, capped) and not evaluate(WORD, capped)
        assert not evaluate(goal, stand_on(capped, "y", "s2")), "nothing else may lie on the word"
        assert not evaluate(goal, shift(capped, ["s1", "x"], 0.0, 0.0, 0.04)), "the word is still in a row"


@pytest.mark.parametrize(
    "read",
    [
        Row(blocks=("s0", "s1", "s2"), axis="y", readable=True, order=Order(by="label")),
        Grid(
            blocks=("s0", "s1", "s2"),
            rows=1,
            columns=3,
            readable=True,
            pattern=Pattern(kind="reading", order=Order(by="label")),
        ),
    ],
)
def test_orders_and_grids_of_letters_may_be_covered_as_words_may(read: Row | Grid) -> None:
    goal = reconcile(All(goals=(read, On(a=("x",), b=("s2",)))))
    objects = world(letters("ABC"), plain(x="blue"))
    capped = arrange(goal, objects, rng=Random(0))[0]
    assert evaluate(goal, capped) and not evaluate(read, capped)
    assert not evaluate(goal, swap(capped, "s0", "s1"))
