"""Goal states: natural ones for satisfiable goals, the clashing conditions for the others."""

from __future__ import annotations

import math
from itertools import pairwise
from random import Random
from typing import Any

import pytest

from rpg.blocks.arrange import Impossible, arrange
from rpg.blocks.evaluate import evaluate, settled
from rpg.blocks.geometry import footprint_gap, plane_distance
from rpg.blocks.state import BlockState, World
from rpg.core.codes import CODES
from rpg.core.diagnostics import Diagnostic
from rpg.ir.assets import ColoredCube, GoalPatch
from rpg.ir.goal import Goal
from tests.blocks.relation_states import At, goal, scene

COLORS = ["red", "blue", "green", "yellow", "purple", "orange", "pink", "cyan", "brown", "black", "gray", "white"]
TABLE = {"kind": "on_table", "a": "red"}
MAT = GoalPatch(name="mat", color="blue", position=(0.55, -0.15))


def cubes(count: int) -> World:
    return World([*(ColoredCube(name=color, color=color) for color in COLORS[:count]), MAT])


def both(*goals: dict[str, Any]) -> Goal:
    return goal("all", goals=goals)


def solved(condition: Goal, world: World, seed: int = 0, start: BlockState | None = None) -> BlockState:
    (state,) = arrange(condition, world, rng=Random(seed), start=start)
    assert evaluate(condition, state)
    assert settled(state)
    return state


def refused(condition: Goal, world: World, start: BlockState | None = None) -> Diagnostic:
    with pytest.raises(Impossible) as caught:
        arrange(condition, world, rng=Random(0), start=start)
    (diagnostic,) = caught.value.diagnostics
    assert diagnostic.code in CODES
    return diagnostic


def on(a: Any, b: Any, **fields: Any) -> dict[str, Any]:
    return {"kind": "on", "a": a, "b": b, **fields}


def left(a: Any, b: Any, **fields: Any) -> dict[str, Any]:
    return {"kind": "left_of", "a": a, "b": b, **fields}


def test_blocks_on_blocks_are_centred_and_in_contact() -> None:
    state = solved(both(on("red", "blue"), on("green", "red")), cubes(3))
    (bx, by, bz), (rx, ry, rz), (gx, gy, gz) = (state.position[n] for n in ("blue", "red", "green"))
    assert (bx, by) == (rx, ry) == (gx, gy)
    assert (bz, rz, gz) == (0.97, 1.01, 1.05)


def test_what_is_not_mentioned_stands_apart() -> None:
    state = solved(goal("on", a="red", b="blue"), cubes(8))
    others = [n for n in COLORS[:8] if n not in ("red", "blue")]
    assert all(plane_distance(state, n, m) > 0.08 for n in others for m in COLORS[:8] if n != m)
    assert all(footprint_gap(state, n, "mat") > 0.0 for n in others)


def test_directions_are_met_with_room_to_spare() -> None:
    assert (
        evaluate(goal("left_of", a="red", b="blue"), solved(goal("left_of", a="red", b="blue"), cubes(2))).margin > 0.5
    )


def test_a_long_chain_of_directions_is_laid_out_in_order() -> None:
    chain = both(*(left(a, b) for a, b in pairwise(COLORS[:9])))
    ys = [solved(chain, cubes(9)).position[name][1] for name in COLORS[:9]]
    assert ys == sorted(ys, reverse=True)


def test_structures_share_blocks() -> None:
    rows = both(
        {"kind": "row", "blocks": ["red", "blue", "green"], "axis": "y"},
        {"kind": "row", "blocks": ["yellow", "blue", "purple"], "axis": "x"},
        on("orange", "blue"),
    )
    solved(rows, cubes(6))


def test_relations_between_towers() -> None:
    towers = both(
        {"kind": "stack", "blocks": ["red", "blue"], "exact": True},
        {"kind": "stack", "blocks": ["green", "yellow", "purple"], "exact": True},
        left({"lowest": ["red", "blue"]}, {"lowest": ["green", "yellow", "purple"]}, immediate=True),
    )
    solved(towers, cubes(6))


def test_blocks_share_a_patch_well_inside_of_it() -> None:
    condition = goal("on_patch", a=COLORS[:4], patch="mat")
    assert evaluate(condition, solved(condition, cubes(6))).margin > 0.3


def test_exactly_two_of_four() -> None:
    each = {"kind": "on_patch", "a": "each", "patch": "mat"}
    condition = goal("count", over=COLORS[:4], at_least=2, at_most=2, goal=each)
    state = solved(condition, cubes(4))
    assert sum(evaluate(goal("on_patch", a=n, patch="mat"), state).value for n in COLORS[:4]) == 2


@pytest.mark.parametrize(
    "condition",
    [
        goal("not", goal=on("red", "blue")),
        goal("not", goal={"kind": "clear", "a": "red"}),
        goal("not", goal={"kind": "empty", "patch": "mat"}),
        goal("not", goal={"kind": "on_table", "a": "red"}),
        goal("not", goal={"kind": "any", "goals": [left("red", "blue"), {"kind": "near", "a": "red", "b": "green"}]}),
        goal("any", goals=[{"kind": "all", "goals": [on("red", "blue"), on("blue", "red")]}, left("red", "blue")]),
        goal("between", a="red", b="blue", c="green"),
        both({"kind": "between", "a": "red", "b": "blue", "c": "green"}, {"kind": "above", "a": "blue", "b": "green"}),
        both({"kind": "above", "a": "red", "b": "blue"}, on("green", "blue")),
        goal("touching", a="red", b="blue"),
        goal("distance", a="red", b="blue", minimum=0.19, maximum=0.21),
        goal("distance", a="red", b="blue", minimum=0.02, maximum=0.03, measure="faces"),
        both(
            {"kind": "row", "blocks": ["red", "blue", "green"]},
            {"kind": "apart", "a": "red", "b": "blue", "distance": 0.12},
        ),
        goal(
            "sequence", stages=[{"goal": {"kind": "on_table", "a": "red"}, "undone": True}, {"goal": on("red", "blue")}]
        ),
    ],
)
def test_goals_of_every_shape(condition: Goal) -> None:
    for seed in range(3):
        solved(condition, cubes(5), seed)


def test_what_stays_keeps_its_place_and_what_holds_it_up() -> None:
    start = scene(world=cubes(4), red=At(0.5, 0.1), blue=At(0.5, 0.1, 0.04), green=At(0.6, -0.1), yellow=At(0.45, -0.2))
    state = solved(both({"kind": "stayed", "a": "blue"}, on("green", "blue")), cubes(4), start=start)
    assert state.position["blue"] == pytest.approx(start.position["blue"])
    assert state.position["red"] == pytest.approx(start.position["red"])
    assert state.start is start


def test_swapped_blocks_take_each_others_places() -> None:
    start = scene(world=cubes(3), red=At(0.5, 0.1), blue=At(0.5, 0.1, 0.04), green=At(0.6, -0.1))
    state = solved(goal("swapped", a="red", b="blue"), cubes(3), start=start)
    assert state.position["red"][2] > state.position["blue"][2]
    solved(
        goal("swapped", a="red", b="green"),
        cubes(3),
        start=scene(world=cubes(3), red=At(0.5, 0.1), blue=At(0.6, 0.1), green=At(0.6, -0.1)),
    )


def test_a_start_is_imagined_where_a_condition_needs_one() -> None:
    state = solved(goal("moved", a="red"), cubes(3))
    assert state.start is not None
    assert math.dist(state.position["red"], state.start.position["red"]) >= 0.05


def test_several_states_differ() -> None:
    found = arrange(goal("near", a="red", b="blue"), cubes(3), rng=Random(0), count=5)
    assert len({tuple(state.position.values()) for state in found}) == 5


def test_opposite_directions_clash_and_nothing_else_is_named() -> None:
    goals = [left("red", "blue"), on("yellow", "green"), {"kind": "right_of", "a": "red", "b": "blue"}]
    spans = [(0, 5), (10, 15), (20, 25)]
    condition = both(*({**part, "span": span} for part, span in zip(goals, spans, strict=True)))
    found = refused(condition, cubes(5))
    assert found.code == "goal-contradiction"
    assert found.span == (0, 5)
    assert [label.span for label in found.labels] == [(20, 25)]


def test_a_ring_of_supports() -> None:
    found = refused(both(on("red", "blue"), on("blue", "green"), on("green", "red"), left("pink", "cyan")), cubes(8))
    assert found.code == "support-cycle"
    assert found.facts["cycle"] == ["red", "blue", "green", "red"]


def test_a_ring_of_directions() -> None:
    found = refused(both(left("red", "blue"), left("blue", "green"), left("green", "red")), cubes(4))
    assert found.code == "goal-contradiction"
    assert len(found.facts["conditions"]) == 3


@pytest.mark.parametrize(
    ("row", "needed"),
    [
        ({"axis": "x", "blocks": COLORS[:8]}, 0.32),
        ({"axis": "y", "blocks": COLORS[:6], "spacing": 0.12}, 0.64),
    ],
)
def test_rows_longer_than_the_workspace(row: dict[str, Any], needed: float) -> None:
    found = refused(goal("row", **row), cubes(12))
    assert found.code == "does-not-fit"
    assert found.facts["needed_m"] == pytest.approx(needed, abs=0.005)
    assert found.facts["available_m"] == pytest.approx({"x": 0.3, "y": 0.5}[row["axis"]])


def test_thirteen_side_by_side() -> None:
    world = World([ColoredCube(name=f"red_{k}", color="red") for k in range(13)])
    chain = both(*(left(f"red_{k}", f"red_{k + 1}", directly=True) for k in range(12)))
    assert refused(chain, world).code == "does-not-fit"
    assert refused(goal("row", blocks=[f"red_{k}" for k in range(13)]), world).code == "does-not-fit"


@pytest.mark.parametrize(
    "goals",
    [
        [on("red", "blue"), on("green", "blue")],
        [on("red", "blue"), {"kind": "on_table", "a": "red"}],
        [on("red", "blue"), {"kind": "clear", "a": "blue"}],
        [{"kind": "on_patch", "a": "red", "patch": "mat"}, {"kind": "empty", "patch": "mat"}],
        [
            {"kind": "in_region", "a": "red", "region": "left_half"},
            {"kind": "in_region", "a": "red", "region": "right_half"},
        ],
        [{"kind": "near", "a": "red", "b": "blue"}, {"kind": "apart", "a": "red", "b": "blue", "distance": 0.2}],
        [on("red", "blue"), {"kind": "not", "goal": on("red", "blue")}],
        [{"kind": "stack", "blocks": ["red", "blue"], "exact": True}, on("green", {"highest": ["red", "blue"]})],
    ],
)
def test_pairs_that_clash(goals: list[dict[str, Any]]) -> None:
    found = refused(both(*goals), cubes(5))
    assert len(found.facts["conditions"]) == 2


def test_what_stays_cannot_move() -> None:
    start = scene(world=cubes(2), red=At(0.5, 0.1), blue=At(0.6, 0.1))
    found = refused(both({"kind": "stayed", "a": "red"}, on("red", "blue")), cubes(2), start)
    assert len(found.facts["conditions"]) == 2
