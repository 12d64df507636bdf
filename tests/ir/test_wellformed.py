"""Goals that cannot be meant are turned down where they are written; everything else is left to the gates."""

from __future__ import annotations

from typing import Any

import pytest
from pydantic import ValidationError

from rpg.ir.assets import ColoredCube, GoalPatch
from rpg.ir.goal import GOAL
from rpg.ir.schema import TaskSchema
from rpg.ir.wellformed import problems

ASSETS = (
    ColoredCube(name="red", color="red"),
    ColoredCube(name="blue", color="blue"),
    ColoredCube(name="green", color="green"),
    GoalPatch(name="here", color="red"),
    GoalPatch(name="there", color="blue"),
)
ON: dict[str, Any] = {"kind": "on", "a": "red", "b": "blue"}

WRONG: tuple[tuple[dict[str, Any], str], ...] = (
    ({"kind": "on", "a": "red", "b": "here"}, "'here', which is a patch"),
    ({"kind": "on", "a": "red", "b": "red"}, "both 'red'"),
    ({"kind": "on", "a": [], "b": "red"}, "a names nothing"),
    ({"kind": "stack", "blocks": ["red", "here"]}, "which is a patch"),
    ({"kind": "stack", "blocks": ["red", "red"]}, "twice"),
    ({"kind": "stack", "blocks": ["red", "blue"], "patch": "green"}, "which is a block, not a patch"),
    ({"kind": "on_patch", "a": "red", "patch": "blue"}, "which is a block, not a patch"),
    ({"kind": "on_patch", "a": "there", "patch": "here"}, "which is a patch"),
    ({"kind": "empty", "patch": "red"}, "which is a block"),
    ({"kind": "facing", "block": "here"}, "which is a patch"),
    ({"kind": "touching", "a": "red", "b": "here"}, "which is a patch"),
    ({"kind": "beside", "a": "here", "b": "there"}, "both sides name patches"),
    ({"kind": "between", "a": "red", "b": "blue", "c": "red"}, "named twice"),
    ({"kind": "closer", "a": "red", "b": "blue", "c": "red"}, "named twice"),
    ({"kind": "equidistant", "a": "red", "b": "blue", "c": ["green", "blue"]}, "named twice"),
    ({"kind": "swapped", "a": ["red", "green"], "b": "blue"}, "one for one"),
    ({"kind": "group_by", "groups": ["red", "here"]}, "which is a patch"),
    ({"kind": "group_by", "groups": [["red", "blue"], ["blue", "green"]]}, "twice"),
    ({"kind": "group_by", "groups": [["red", "blue"], ["green"]], "outliers": 1}, "needs by"),
    ({"kind": "left_of", "a": {"lowest": ["red", "here"]}, "b": "blue"}, "which is a patch"),
    ({"kind": "count", "over": ["red", "blue"], "goal": {"kind": "on", "a": "each", "b": "here"}}, "a patch"),
    ({"kind": "count", "over": [], "goal": {"kind": "on_table", "a": "each"}}, "over names nothing"),
    ({"kind": "not", "goal": {"kind": "clear", "a": "here"}}, "a patch"),
    ({"kind": "sequence", "stages": []}, "no stages"),
    ({"kind": "sequence", "stages": [{"goal": {"kind": "all", "goals": []}}]}, "asks for nothing"),
)

RIGHT: tuple[dict[str, Any], ...] = (
    ON,
    {"kind": "left_of", "a": "red", "b": "here"},
    {"kind": "left_of", "a": "here", "b": "there"},
    {"kind": "between", "a": "red", "b": "here", "c": "there"},
    {"kind": "closer", "a": "here", "b": "red", "c": ["blue"]},
    {"kind": "equidistant", "a": "red", "b": "here", "c": "there"},
    {"kind": "beside", "a": "red", "b": "here"},
    {"kind": "apart", "a": ["red", "blue"], "b": ["red", "blue"]},
    {"kind": "on_patch", "a": ["red", "blue"], "patch": "here"},
    {"kind": "towers", "blocks": ["red", "blue"], "matching": ["here", "there"]},
    {"kind": "count", "over": ["red", "blue"], "goal": {"kind": "on_patch", "a": "each", "patch": "here"}},
    {"kind": "all", "goals": []},
    {"kind": "any", "goals": [ON, {"kind": "not", "goal": ON}]},
)


@pytest.mark.parametrize(("data", "reason"), WRONG)
def test_what_cannot_be_meant_is_said(data: dict[str, Any], reason: str) -> None:
    goal = GOAL.validate_python(data)
    found = list(problems(goal, ["here", "there"]))
    assert any(reason in problem for problem in found), found
    with pytest.raises(ValidationError, match="1 validation error"):
        TaskSchema(name="task", instruction="", assets=ASSETS, goal=goal)


@pytest.mark.parametrize("data", RIGHT)
def test_what_can_be_meant_is_let_through(data: dict[str, Any]) -> None:
    goal = GOAL.validate_python(data)
    assert list(problems(goal, ["here", "there"])) == []
    assert TaskSchema(name="task", instruction="", assets=ASSETS, goal=goal).goal == goal
