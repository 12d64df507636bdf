"""Edits on the schema: each does what it says, and a list of them gives the same schema again."""

from __future__ import annotations

import itertools

import pytest

from rpg.core.digest import digest_of
from rpg.ir import edits as e
from rpg.ir.assets import ColoredCube, GoalPatch, SemanticCube
from rpg.ir.goal import All, On, OnPatch
from rpg.ir.order import Order
from rpg.ir.schema import InitialState, TaskSchema
from rpg.ir.shrink import TooSmall
from rpg.ir.structures import Grid, Row, Stack


def cube(color: str, name: str | None = None) -> ColoredCube:
    return ColoredCube(name=name or f"{color}_block", color=color)


def tower(*colors: str) -> TaskSchema:
    goals = tuple(On(a=(f"{a}_block",), b=(f"{b}_block",)) for b, a in itertools.pairwise(colors))
    return TaskSchema(name="tower", instruction="tower", assets=tuple(map(cube, colors)), goal=All(goals=goals))


def test_a_removed_block_closes_its_tower_and_leaves_a_vacancy() -> None:
    base = tower("red", "green", "blue")
    result = e.apply(base, [e.RemoveAsset(name="green_block")])
    assert [a.name for a in result.assets] == ["red_block", "blue_block"]
    assert result.goal == On(a=("blue_block",), b=("red_block",))
    assert [(v.origin, v.before) for v in result.init.vacant] == [("green_block", "blue_block")]


def test_vacancies_keep_the_order_in_which_starts_are_drawn() -> None:
    base = tower("red", "green", "blue", "yellow")
    result = e.apply(base, [e.RemoveAsset(name="blue_block"), e.RemoveAsset(name="green_block")])
    assert [(v.origin, v.before) for v in result.init.vacant] == [
        ("green_block", "yellow_block"),
        ("blue_block", "yellow_block"),
    ]


def test_a_recoloured_block_is_renamed_and_keeps_its_origin() -> None:
    purple = e.ReplaceAssets(exchanges=(e.Exchange(name="red_block", asset=cube("purple")),))
    result = e.apply(tower("red", "blue"), [purple])
    assert result.goal == All(goals=(On(a=("blue_block",), b=("purple_block",)),))
    assert [e.key(a) for a in result.assets] == ["red_block", "blue_block"]
    back = e.apply(result, [e.ReplaceAssets(exchanges=(e.Exchange(name="purple_block", asset=cube("red")),))])
    assert back == tower("red", "blue")


def test_two_blocks_swap_colours_at_once() -> None:
    swap = e.ReplaceAssets(
        exchanges=(
            e.Exchange(name="red_block", asset=cube("blue")),
            e.Exchange(name="blue_block", asset=cube("red")),
        )
    )
    result = e.apply(tower("red", "blue"), [swap])
    assert [(a.name, e.key(a)) for a in result.assets] == [("blue_block", "red_block"), ("red_block", "blue_block")]
    assert result.goal == All(goals=(On(a=("red_block",), b=("blue_block",)),))


def test_an_added_block_never_takes_the_origin_of_another() -> None:
    purple = e.ReplaceAssets(exchanges=(e.Exchange(name="red_block", asset=cube("purple")),))
    result = e.apply(tower("red", "blue"), [purple, e.AddAsset(asset=cube("red"))])
    assert len({e.key(asset) for asset in result.assets}) == 3


def test_permute_reverses_a_tower() -> None:
    parts = {"red_block": "blue_block", "blue_block": "red_block"}
    result = e.apply(tower("red", "green", "blue"), [e.Permute(parts=parts)])
    assert result.goal == All(
        goals=(On(a=("green_block",), b=("blue_block",)), On(a=("red_block",), b=("green_block",)))
    )


def test_conditions_are_added_changed_and_dropped_by_place() -> None:
    base = tower("red", "blue")
    patch = e.AddAsset(asset=GoalPatch(name="patch", color="green"))
    more = e.AddCondition(goal=OnPatch(a=("red_block",), patch="patch"))
    extended = e.apply(base, [patch, more])
    assert extended.goal == All(goals=(*base.goal.goals, more.goal))
    tight = e.apply(extended, [e.SetField(at=(0,), field="gap", value=0.005)])
    assert tight.goal.goals[0].gap == 0.005
    assert e.apply(extended, [e.DropCondition(at=(1,))]).goal == base.goal.goals[0]
    with pytest.raises(e.EditError):
        e.apply(base, [e.DropCondition(at=(0,))])
    with pytest.raises(e.EditError):
        e.apply(base, [e.SetField(at=(0,), field="colour", value="red")])


def test_lines_shrink_and_grids_do_not() -> None:
    names = tuple(f"{c}_block" for c in ("red", "green", "blue", "yellow"))
    assets = tuple(map(cube, ("red", "green", "blue", "yellow")))
    row = TaskSchema(
        name="row",
        instruction="row",
        assets=assets,
        goal=Row(blocks=names, order=Order(by="given", ranks=tuple((n,) for n in names))),
    )
    shorter = e.apply(row, [e.RemoveAsset(name="green_block")])
    assert shorter.goal.blocks == ("red_block", "blue_block", "yellow_block")
    assert shorter.goal.order.ranks == (("red_block",), ("blue_block",), ("yellow_block",))
    square = row.model_copy(update={"goal": Grid(blocks=names, rows=2, columns=2)})
    with pytest.raises(TooSmall):
        e.apply(square, [e.RemoveAsset(name="green_block")])


def test_heaps_and_starts_follow_their_blocks() -> None:
    base = tower("red", "green", "blue").model_copy(
        update={"init": InitialState(heaps=(("red_block", "green_block"),), arranged=(Stack(blocks=("blue_block",)),))}
    )
    renamed = e.apply(
        base,
        [e.ReplaceAssets(exchanges=(e.Exchange(name="red_block", asset=SemanticCube(name="A_block", label="A")),))],
    )
    assert renamed.init.heaps == (("A_block", "green_block"),)
    assert e.apply(renamed, [e.RemoveAsset(name="green_block")]).init.heaps == (("A_block",),)


def test_edits_survive_json_and_give_the_same_bytes() -> None:
    base = tower("red", "green", "blue")
    edits = [
        e.ReplaceAssets(exchanges=(e.Exchange(name="red_block", asset=cube("purple")),)),
        e.AddAsset(asset=cube("red")),
        e.AddCondition(goal=On(a=("red_block",), b=("blue_block",))),
        e.SetText(instruction="a taller tower"),
    ]
    again = [e.EDIT.validate_python(edit.model_dump(mode="json")) for edit in edits]
    first, second = (e.apply(base, some).model_dump(mode="json") for some in (edits, again))
    assert digest_of(first) == digest_of(second)
    assert first["instruction"] == "a taller tower"
