"""Small tasks, written as schemas, for tests of the passes."""

from __future__ import annotations

from random import Random
from typing import Any

from rpg.ir.artifact import GateReport, Placement, Program, Scene
from rpg.ir.assets import ColoredCube, GoalPatch, SemanticCube
from rpg.ir.goal import All, Always, Count, Goal, Not, Sequence, Stage
from rpg.ir.goal import Any as Either
from rpg.ir.node import Lowest
from rpg.ir.order import Order
from rpg.ir.relations import Clear, InRegion, LeftOf, On, OnPatch, OnTable, Stayed
from rpg.ir.schema import TaskSchema
from rpg.ir.structures import Row, Spells, Stack
from rpg.passes.codegen import lower, lower_goal
from rpg.pipeline import goal_path, prepared


def cube(color: str, name: str | None = None, **extra: Any) -> ColoredCube:
    return ColoredCube(name=name or f"{color}_block", color=color, **extra)  # type: ignore[arg-type]


def letters(word: str) -> tuple[SemanticCube, ...]:
    seen: dict[str, int] = {}
    found = []
    for letter in word:
        seen[letter] = seen.get(letter, 0) + 1
        many = word.count(letter) > 1
        found.append(SemanticCube(name=f"{letter}_block_{seen[letter]}" if many else f"{letter}_block", label=letter))
    return tuple(found)


def task(name: str, assets: tuple[Any, ...], goal: Goal, instruction: str = "", **extra: Any) -> TaskSchema:
    return TaskSchema(name=name, instruction=instruction or name.replace("-", " "), assets=assets, goal=goal, **extra)


def program(schema: TaskSchema, seed: int = 0) -> Program:
    """The program of a schema as the pipeline makes it, before validation."""
    ready = prepared(schema)
    path = goal_path(ready, Random(seed))
    return Program(task=ready, path=path, code=lower(ready), goal_code=lower_goal(ready, path))


def measured(report: GateReport) -> dict[str, Any]:
    """What a gate measured, but for other goal states: our own lowering is run on one of them."""
    return {name: value for name, value in report.figures.items() if name != "other_goals"}


def placed(source: Program, **moves: tuple[float, float, float]) -> Program:
    """`source` with blocks of its goal scene elsewhere, lowered again."""
    scene: Scene = tuple(
        Placement(block=p.block, position=moves.get(p.block, p.position), orientation=p.orientation)
        for p in source.path[-1]
    )
    path = (*source.path[:-1], scene)
    return source.model_copy(update={"path": path, "goal_code": lower_goal(source.task, path)})


RED_ON_YELLOW = task(
    "red-on-yellow",
    (cube("red"), cube("yellow")),
    On(a=("red_block",), b=("yellow_block",), span=(14, 44)),
    "I want you to put the red block onto the yellow one",
)
WORD = task(
    "spell-noon",
    letters("NOON"),
    Spells(blocks=("N_block_1", "O_block_1", "O_block_2", "N_block_2"), word="NOON"),
)
TOWER = task(
    "tower",
    (cube("red"), cube("green"), cube("blue")),
    Stack(
        blocks=("red_block", "green_block", "blue_block"),
        order=Order(by="given", ranks=(("red_block",), ("green_block",), ("blue_block",))),
    ),
)
ROW = task(
    "row",
    (cube("red"), cube("green"), cube("blue")),
    Row(
        blocks=("red_block", "green_block", "blue_block"),
        axis="y",
        order=Order(by="given", ranks=(("red_block",), ("green_block",), ("blue_block",)), first="left"),
    ),
)
PATCH = task(
    "two-on-patch",
    (*(cube("red", f"red_block_{k}") for k in (1, 2, 3)), GoalPatch(name="blue_patch", color="blue")),
    Count(
        over=("red_block_1", "red_block_2", "red_block_3"),
        at_least=2,
        at_most=2,
        goal=OnPatch(a=("each",), patch="blue_patch"),
    ),
)
STAGES = task(
    "first-then",
    (cube("red"), cube("blue"), cube("green"), GoalPatch(name="red_patch", color="red"),
     GoalPatch(name="blue_patch", color="blue")),
    All(goals=(
        Sequence(stages=(
            Stage(goal=OnPatch(a=("blue_block",), patch="blue_patch")),
            Stage(goal=OnPatch(a=("red_block",), patch="red_patch")),
        )),
        Always(goal=OnTable(a=("green_block",))),
    )),
)  # fmt: skip
STAY = task(
    "leave-green",
    (cube("red"), cube("blue"), cube("green")),
    All(goals=(On(a=("red_block",), b=("blue_block",)), Stayed(a=("green_block",)))),
)
ALIKE = task(
    "alike",
    (cube("red", "red_block_1"), cube("red", "red_block_2"), cube("blue")),
    All(goals=(On(a=("red_block_1",), b=("blue_block",)), LeftOf(a=("red_block_2",), b=("blue_block",)))),
)
MIXED = task(
    "mixed",
    (cube("red"), cube("green"), cube("blue"), cube("yellow")),
    All(goals=(
        Either(goals=(On(a=("red_block",), b=("green_block",)), On(a=("red_block",), b=("blue_block",)))),
        Not(goal=InRegion(a=("yellow_block",), region="left_half")),
        LeftOf(a=Lowest(lowest=("red_block", "green_block")), b=("yellow_block",), somewhere=True),
        Clear(a=("red_block",)),
    )),
)  # fmt: skip
ALL = (RED_ON_YELLOW, WORD, TOWER, ROW, PATCH, STAGES, STAY, ALIKE, MIXED)
