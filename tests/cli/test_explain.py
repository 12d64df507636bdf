"""What is said about a task's goal: its tree, and its stages."""

from __future__ import annotations

from rpg.blocks.state import World
from rpg.explain import Outline, outline
from rpg.ir.goal import All, Any, Clear, Count, Not, On, OnPatch, OnTable, Sequence, Stage

from .conftest import SCHEMA

WORLD = World(SCHEMA.assets)
ON = On(a="red_block", b="blue_block")


def test_connectives_are_branches_and_conditions_leaves() -> None:
    goal = All(goals=(Any(goals=(ON, OnPatch(a="red_block", patch="patch"))), Not(goal=Clear(a="blue_block"))))
    assert outline(goal, WORLD) == Outline(
        "all of",
        (
            Outline(
                "any of",
                (Outline("the red block is on the blue block"), Outline("the red block is on the green patch")),
            ),
            Outline("not", (outline(Clear(a="blue_block"), WORLD),)),
        ),
    )


def test_stages_follow_each_other() -> None:
    goal = Sequence(stages=(Stage(goal=ON, undone=True), Stage(goal=OnTable(a="red_block"))))
    assert outline(goal, WORLD).parts[0].text == "the red block is on the blue block"


def test_a_count_is_one_condition() -> None:
    goal = Count(over=("red_block", "blue_block"), at_least=1, goal=OnPatch(a="each", patch="patch"))
    assert "patch" in outline(goal, WORLD).text
    assert not outline(goal, WORLD).parts
