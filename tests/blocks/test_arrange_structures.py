"""Structures under further conditions: who sits where, what is part of what, and how closely things can be packed."""

from __future__ import annotations

from random import Random
from typing import Any

import pytest

from rpg.blocks.arrange import Impossible, arrange
from rpg.blocks.arrange.alternatives import alternatives, lies_flat
from rpg.blocks.evaluate import evaluate, settled
from rpg.blocks.state import World
from rpg.ir.assets import ColoredCube, GoalPatch
from tests.blocks.relation_states import goal

COLORS = ["red", "blue", "green", "yellow", "purple", "orange", "pink", "cyan", "brown", "black", "gray", "white"]
WORLD = World([*(ColoredCube(name=color, color=color) for color in COLORS[:9])])


def near(a: str, b: str) -> dict[str, Any]:
    return {"kind": "near", "a": a, "b": b}


def no(inner: dict[str, Any]) -> dict[str, Any]:
    return {"kind": "not", "goal": inner}


def structure(kind: str, first: int, **fields: Any) -> dict[str, Any]:
    return {"kind": kind, "blocks": COLORS[:first], **fields}


@pytest.mark.parametrize(
    "goals",
    [
        [structure("row", 5), no({"kind": "beside", "a": "red", "b": "blue"})],
        [structure("row", 6, axis="y"), {"kind": "left_of", "a": COLORS[3:6], "b": COLORS[:3]}],
        [structure("row", 6, axis="y"), {"kind": "row", "blocks": ["orange", "red", "yellow"]}],
        [structure("grid", 9, rows=3, columns=3), {"kind": "left_of", "a": "red", "b": "blue"}],
        [structure("grid", 9, rows=3, columns=3), {"kind": "between", "a": "red", "b": "blue", "c": "green"}],
        [structure("pyramid", 6, base=[3, 1]), {"kind": "clear", "a": "green"}],
        [structure("figure", 8, shape="circle"), no(near("red", "blue"))],
        [structure("towers", 4, count=2), {"kind": "on", "a": "red", "b": "yellow"}],
        [structure("towers", 4, count=2), {"kind": "left_of", "a": "red", "b": "yellow"}],
        [{"kind": "group_by", "groups": [COLORS[:9]]}, structure("grid", 9, rows=3, columns=3)],
        [{"kind": "group_by", "groups": [COLORS[:4], COLORS[4:8]]}, structure("row", 4)],
        [{"kind": "group_by", "groups": [COLORS[:4], COLORS[4:8]]}, structure("stack", 2)],
        [structure("figure", 8, shape="circle"), {"kind": "between", "a": "brown", "b": "red", "c": "purple"}],
        [near("red", "blue"), *({"kind": "touching", "a": a, "b": "green"} for a in ("red", "blue"))],
        [{"kind": "touching", "a": "red", "b": "blue"}, no({"kind": "beside", "a": "red", "b": "blue"})],
    ],
)
def test_structures_meet_further_conditions(goals: list[dict[str, Any]]) -> None:
    condition = goal("all", goals=goals)
    for seed in range(2):
        (state,) = arrange(condition, WORLD, rng=Random(seed))
        assert evaluate(condition, state)
        assert settled(state)


def look_alikes(count: int) -> tuple[World, list[str]]:
    names = [f"red_{k}" for k in range(count)]
    return World([ColoredCube(name=name, color="red") for name in names]), names


def test_thirty_blocks_find_room() -> None:
    world, names = look_alikes(30)
    (state,) = arrange(goal("on", a=names[0], b=names[1]), world, rng=Random(0))
    assert settled(state)


def test_many_blocks_keep_their_distance() -> None:
    world, names = look_alikes(24)
    apart = goal("apart", a=names, b=names, distance=0.06)
    assert evaluate(apart, arrange(apart, world, rng=Random(0))[0])


def test_a_corner_is_filled() -> None:
    world, names = look_alikes(6)
    corner = goal("in_region", a=names, region="far_right_corner")
    assert evaluate(corner, arrange(corner, world, rng=Random(0))[0])


def test_big_blocks_are_not_stood_on_small_ones_off_centre() -> None:
    sizes = {"big": 0.08, "small": 0.03, "other": 0.03}
    world = World([ColoredCube(name=name, color="red", size=size) for name, size in sizes.items()])
    (state,) = arrange(
        goal("stack", blocks=["big", "small"], order={"by": "given", "ranks": ["small", "big"]}), world, rng=Random(0)
    )
    assert state.position["big"][:2] == state.position["small"][:2]


@pytest.mark.parametrize(("blocks", "axis", "fits"), [(13, "y", "twelve"), (9, "x", "seven")])
def test_the_hint_says_how_many_would_fit(blocks: int, axis: str, fits: str) -> None:
    world, names = look_alikes(blocks)
    with pytest.raises(Impossible) as caught:
        arrange(goal("row", blocks=names, axis=axis), world, rng=Random(0))
    (found,) = caught.value.diagnostics
    assert found.hint is not None and fits in found.hint
    count = {"twelve": 12, "seven": 7}[fits]
    assert arrange(goal("row", blocks=names[:count], axis=axis), world, rng=Random(0))


def test_a_hopeless_goal_is_given_up_in_good_time() -> None:
    mat = GoalPatch(name="mat", color="blue", size=(0.05, 0.05), position=(0.55, 0.0))
    world = World([*(ColoredCube(name=color, color=color) for color in COLORS), mat])
    each = {"kind": "on_patch", "a": "each", "patch": "mat"}
    with pytest.raises(Impossible):
        arrange(goal("count", over=COLORS, at_least=6, goal=each), world, rng=Random(0))


def test_no_way_to_build_a_line_has_its_blocks_on_each_other() -> None:
    """A block between two others may stand in a tower, but not where all three are of one line."""
    between = {"kind": "between", "a": "red", "b": "blue", "c": "green"}
    beside_it = {"kind": "row", "blocks": ["blue", "green"]}
    for parts, ways in (([between], 3), ([structure("row", 3), between], 1), ([beside_it, between], 3)):
        found = [lies_flat(literals) for literals in alternatives(goal("all", goals=parts), WORLD)]
        assert (len(found), sum(found)) == (3, ways)
