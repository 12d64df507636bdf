"""Clauses, references to look-alikes, negation, and which kinds of atoms can be said."""

from __future__ import annotations

import pytest

from rpg.blocks.english import clause, describe
from rpg.blocks.english.goals import CLAUSES
from rpg.blocks.predicates import PREDICATES
from rpg.blocks.state import World
from rpg.ir import goal as g
from rpg.ir.assets import Asset, ColoredCube, GoalPatch, SemanticCube
from rpg.ir.node import Lowest
from rpg.ir.order import Order
from rpg.ir.schema import InitialState, TaskSchema

RED = ("red_block_1", "red_block_2", "red_block_3")
ASSETS: tuple[Asset, ...] = (
    *(ColoredCube(name=name, color="red") for name in RED),
    ColoredCube(name="blue_block", color="blue"),
    ColoredCube(name="green_block", color="green", size=0.05),
    SemanticCube(name="A_block", label="A"),
    GoalPatch(name="green_patch", color="green", position=(0.5, 0.1)),
)
WORLD = World(ASSETS)


def test_every_predicate_has_a_clause() -> None:
    assert set(CLAUSES) == set(PREDICATES)


@pytest.mark.parametrize(
    ("goal", "text"),
    [
        (g.On(a="blue_block", b="A_block"), "the blue block is on the A block"),
        (g.Not(goal=g.On(a="blue_block", b="A_block")), "the blue block is not on the A block"),
        (g.Not(goal=g.Touching(a=RED, b="A_block")), "the three red blocks do not touch the A block"),
        (g.OnPatch(a=RED[:2], patch="green_patch"), "two red blocks are on the green patch"),
        (
            g.Distance(a="blue_block", b="A_block", minimum=0.11, maximum=0.13),
            "the blue block is 12 cm from the A block",
        ),
        (
            g.Distance(a="blue_block", b="A_block", minimum=0.075, maximum=0.125),
            "the blue block is about 10 cm from the A block",
        ),
        (
            g.LeftOf(a="blue_block", b=Lowest(lowest=("green_block", "A_block"))),
            "the blue block is to the left of the tower of the 5 cm green block and the A block",
        ),
        (
            g.Count(over=RED, at_least=2, at_most=2, goal=g.OnPatch(a="each", patch="green_patch")),
            "exactly two of the three red blocks are on the green patch",
        ),
        (
            g.Not(goal=g.Any(goals=(g.On(a="blue_block", b="A_block"), g.OnTable(a="blue_block")))),
            "the blue block is not on the A block and the blue block is not on the table",
        ),
    ],
)
def test_clauses(goal: g.Goal, text: str) -> None:
    assert clause(goal, WORLD) == text


def test_look_alikes_are_told_apart_as_they_are_mentioned() -> None:
    goal = g.All(goals=(g.On(a=RED[0], b="blue_block"), g.On(a=RED[1], b="A_block"), g.OnTable(a=RED[2])))
    said = "a red block is on the blue block, another red block is on the A block"
    assert clause(goal, WORLD) == f"{said} and the other red block is on the table"


def test_look_alikes_mentioned_twice_are_numbered() -> None:
    goal = g.All(goals=(g.On(a=RED[0], b="blue_block"), g.Beside(a=RED[0], b="A_block")))
    assert clause(goal, WORLD) == "red block 1 is on the blue block and red block 1 is next to the A block"


def test_a_task_is_described_from_its_data_alone() -> None:
    schema = TaskSchema(
        name="x",
        instruction="whatever was said",
        assets=ASSETS,
        init=InitialState(arranged=(g.On(a="blue_block", b="A_block"),), heaps=(RED,)),
        goal=g.Stack(blocks=("A_block", "blue_block"), order=Order(by="given", ranks=(("A_block",), ("blue_block",)))),
    )
    assert describe(schema) == (
        "There are three red blocks, a blue block and an A block. There is a green patch. "
        "There is also a 5 cm green block as a distractor. "
        "At the start, the blue block is on the A block. At the start, the three red blocks lie in a heap. "
        "The A block and the blue block must be stacked from bottom to top in the order the A block, the blue block."
    )
