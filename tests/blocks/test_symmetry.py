"""Blocks that look alike change places freely; blocks that do not, never."""

from __future__ import annotations

from itertools import pairwise

import pytest

from rpg.blocks.evaluate import evaluate
from rpg.blocks.state import World
from rpg.blocks.symmetry import Canonical, interchangeable, link, namings, rename_state
from rpg.core.diagnostics import Refusal
from rpg.ir.assets import ColoredCube
from rpg.ir.goal import Goal
from tests.blocks.relation_states import At, goal, scene

RED = ("red_1", "red_2", "red_3")
WORLD = World([*(ColoredCube(name=name, color="red") for name in RED), ColoredCube(name="blue", color="blue")])


def holds(condition: Goal, **blocks: At) -> bool:
    state = scene(world=WORLD, **blocks)
    found = namings(interchangeable(condition, WORLD))
    return any(evaluate(condition, rename_state(state, naming)).value for naming in found)


def test_one_of_three() -> None:
    condition = goal("on", a="red_1", b="blue")
    assert interchangeable(condition, WORLD) == ((("red_1",), ("red_2", "red_3")),)
    assert len(namings(interchangeable(condition, WORLD))) == 3
    flat = {"red_1": At(0.5, 0.1), "red_2": At(0.5, -0.1), "blue": At(0.6, 0.0)}
    assert holds(condition, **flat, red_3=At(0.6, 0.0, 0.04))
    assert not holds(condition, **flat, red_3=At(0.45, 0.0))


@pytest.mark.parametrize(
    "condition",
    [
        goal("stack", blocks=RED),
        goal("on_table", a=RED),
        goal("left_of", a=RED, b="blue"),
        goal("count", over=RED, at_least=2, goal={"kind": "on", "a": "each", "b": "blue"}),
        goal("row", blocks=(*RED, "blue"), order={"by": "given", "ranks": ["red_1", "blue", ["red_2", "red_3"]]}),
        goal("all", goals=[{"kind": "on_table", "a": name} for name in RED]),
        goal("any", goals=[{"kind": "clear", "a": name} for name in RED]),
    ],
)
def test_symmetric_goals_need_no_renaming(condition: Goal) -> None:
    assert interchangeable(condition, WORLD) == ()
    assert namings(()) == ({},)


def test_beside_may_be_turned_round() -> None:
    condition = goal("beside", a="red_1", b="red_2")
    assert interchangeable(condition, WORLD) == ((("red_1", "red_2"), ("red_3",)),)


def test_an_order_is_by_name_only_where_another_condition_tells_its_blocks_apart() -> None:
    row = {
        "kind": "row",
        "blocks": [*RED, "blue"],
        "order": {"by": "given", "ranks": ["red_1", "blue", "red_2", "red_3"]},
    }
    alone = link(goal("all", goals=[row, {"kind": "on_table", "a": RED}]), WORLD)
    told = link(goal("all", goals=[row, {"kind": "facing", "block": "red_1"}]), WORLD)
    assert alone.goals[0].order.match == "look"  # type: ignore[union-attr]
    assert told.goals[0].order.match == "name"  # type: ignore[union-attr]
    assert interchangeable(alone, WORLD) == ()
    assert interchangeable(told, WORLD) != ()


def test_identity_comes_first_and_all_are_distinct() -> None:
    condition = goal(
        "stack",
        blocks=("red_1", "red_2", "blue"),
        order={"by": "given", "ranks": ["red_1", "red_2", "blue"], "match": "name"},
    )
    found = namings(interchangeable(condition, WORLD))
    assert found[0] == {}
    assert len({tuple(sorted(naming.items())) for naming in found}) == len(found) == 6


def test_too_many_duties_are_refused() -> None:
    world = World([ColoredCube(name=f"red_{k}", color="red") for k in range(9)])
    chain = goal("all", goals=[{"kind": "left_of", "a": f"red_{k}", "b": f"red_{k + 1}"} for k in range(8)])
    with pytest.raises(Refusal, match="look alike"):
        namings(interchangeable(chain, world))


COLORS = ("red", "blue", "green")
RED_ROW = ("red_0", "red_1", "red_2")
PAIRED = World(
    [
        *(ColoredCube(name=f"red_{k}", color="red") for k in range(3)),
        *(ColoredCube(name=f"blue_{k}", color="blue") for k in range(3)),
        *(ColoredCube(name=f"green_{k}", color="green") for k in range(3)),
    ]
)


def pairs(*colors: str, count: int = 3) -> list[dict[str, object]]:
    return [
        {"kind": "on", "a": f"{upper}_{k}", "b": f"{lower}_{k}"}
        for upper, lower in pairwise(colors)
        for k in range(count)
    ]


@pytest.mark.parametrize(
    "condition, ways",
    [
        (goal("all", goals=pairs("blue", "red")), 6),
        (goal("all", goals=[{"kind": "row", "blocks": RED_ROW}, *pairs("blue", "red")]), 6),
        (goal("all", goals=pairs("green", "blue", "red")), 36),
        (goal("all", goals=pairs("blue", "red", count=2)), 18),
        (goal("all", goals=[*pairs("blue", "red"), {"kind": "left_of", "a": "red_0", "b": "red_1"}]), 36),
        (goal("all", goals=[*pairs("blue", "red"), *pairs("green", "red", count=1)]), 54),
        (goal("all", goals=[{"kind": "stack", "blocks": [f"{c}_{k}" for c in COLORS]} for k in range(3)]), 36),
    ],
)
def test_look_alikes_that_go_together_change_places_together(condition: Goal, ways: int) -> None:
    canonical = Canonical(PAIRED)
    every, few = (namings(interchangeable(condition, PAIRED, jointly=jointly)) for jointly in (False, True))
    assert {repr(canonical(condition, naming)) for naming in every} == {
        repr(canonical(condition, naming)) for naming in few
    }
    assert len(few) == ways <= len(every)
