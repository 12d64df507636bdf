"""Patches are made large enough for what must lie on them, and put where the goal says and leaves room."""

from __future__ import annotations

from itertools import combinations, pairwise
from random import Random
from typing import Any

import pytest

from rpg.blocks.arrange import arrange
from rpg.blocks.evaluate import evaluate
from rpg.blocks.geometry import patch_outline, polygon_gap
from rpg.blocks.patches import place_patches
from rpg.blocks.state import BlockState, World
from rpg.core.diagnostics import Refusal
from rpg.ir.assets import ColoredCube, GoalPatch
from rpg.ir.schema import TaskSchema
from tests.blocks.relation_states import goal

COLORS = ("red", "blue", "green", "yellow", "purple", "orange", "pink", "cyan", "brown")


def placed(blocks: int, condition: dict[str, Any], *patches: GoalPatch) -> TaskSchema:
    cubes = [ColoredCube(name=color, color=color) for color in COLORS[:blocks]]
    schema = TaskSchema(name="t", instruction="t", assets=(*cubes, *patches), goal=goal(**condition))
    return place_patches(schema)


def mat(name: str = "mat", **fields: Any) -> GoalPatch:
    return GoalPatch(name=name, color="green", **fields)


def lying(count: int) -> dict[str, Any]:
    return {"kind": "on_patch", "a": COLORS[:count], "patch": "mat"}


@pytest.mark.parametrize(("count", "side"), [(1, 0.1), (2, 0.1), (4, 0.1), (9, 0.15)])
def test_a_square_grows_with_what_lies_on_it(count: int, side: float) -> None:
    (patch,) = placed(count, lying(count), mat()).patches
    assert patch.size == (side, side)
    assert patch.shape == "square"
    assert patch.position is not None


def test_a_long_patch_stays_long() -> None:
    (patch,) = placed(9, lying(9), mat(shape="rectangle", size=(0.1, 0.2))).patches
    assert max(patch.size) >= 2 * min(patch.size)


def test_a_stack_takes_one_place() -> None:
    stack = {"kind": "stack", "blocks": COLORS[:5], "patch": "mat"}
    assert placed(5, stack, mat()).patches[0].size == (0.1, 0.1)


def test_a_row_takes_its_length() -> None:
    row = {"kind": "all", "goals": [{"kind": "row", "blocks": COLORS[:6], "axis": "y"}, lying(6)]}
    (patch,) = placed(6, row, mat()).patches
    assert patch.size[1] >= 0.28


@pytest.mark.parametrize("count", [2, 3, 4, 6, 9])
def test_patches_do_not_crowd_each_other(count: int) -> None:
    mats = [mat(f"mat_{k}") for k in range(count)]
    goals = [{"kind": "on_patch", "a": COLORS[k], "patch": f"mat_{k}"} for k in range(count)]
    schema = placed(count, {"kind": "all", "goals": goals}, *mats)
    for p, q in combinations(schema.patches, 2):
        assert polygon_gap(patch_outline(p), patch_outline(q)) >= 0.02 - 1e-9
    assert arrange(schema.goal, World(schema.assets), rng=Random(0))


@pytest.mark.parametrize("kind", ["left_of", "right_of", "in_front_of", "behind"])
def test_relations_between_patches_are_honoured(kind: str) -> None:
    relation = {"kind": kind, "a": "one", "b": "two"}
    goals = [relation, {"kind": "on_patch", "a": "red", "patch": "one"}]
    schema = placed(1, {"kind": "all", "goals": goals}, mat("one"), mat("two"))
    assert evaluate(goal(**relation), BlockState(World(schema.assets), {}, {}))


@pytest.mark.parametrize("kind", ["left_of", "right_of", "in_front_of", "behind", "beside"])
def test_there_is_room_beside_a_patch(kind: str) -> None:
    schema = placed(1, {"kind": kind, "a": "red", "b": "mat"}, mat(size=(0.14, 0.14)))
    assert arrange(schema.goal, World(schema.assets), rng=Random(0))


def test_what_has_a_place_keeps_it() -> None:
    schema = placed(2, lying(2), mat(position=(0.5, 0.1)), mat("other"))
    assert schema.patches[0].position == (0.5, 0.1)
    assert place_patches(schema) == schema


def test_more_patches_than_the_table_holds_are_refused() -> None:
    mats = [mat(f"mat_{k}", size=(0.15, 0.15)) for k in range(9)]
    with pytest.raises(Refusal, match="nine patches"):
        placed(1, {"kind": "on_table", "a": "red"}, *mats)


def test_any_order_of_many_patches_is_found() -> None:
    names = [f"mat_{k}" for k in range(6)]
    order = [{"kind": "left_of", "a": b, "b": a, "somewhere": True} for a, b in pairwise(names[:3])]
    schema = placed(1, {"kind": "all", "goals": order}, *(mat(name) for name in names))
    state = BlockState(World(schema.assets), {}, {})
    assert all(evaluate(goal(**part), state) for part in order)
