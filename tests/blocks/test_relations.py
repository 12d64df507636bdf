"""Every relation on states at the edges of its tolerances: just inside holds, just outside does not."""

from __future__ import annotations

from typing import Any

import pytest

from rpg.blocks.evaluate import evaluate, settled
from tests.blocks.relation_states import At, E, goal, scene

X, Y = 0.55, 0.0
RED = At(X, Y)


def judge(kind: str, fields: dict[str, Any], blocks: dict[str, Any]) -> bool:
    verdict = evaluate(goal(kind, **fields), scene(**blocks))
    assert verdict.value == (verdict.margin >= 0.0) or verdict.margin == 0.0
    return verdict.value


ON = {"a": "blue", "b": "red"}


@pytest.mark.parametrize(
    ("blue", "holds"),
    [
        (At(X, Y, E), True),
        (At(X, Y, E + 0.0099), True),
        (At(X, Y, E + 0.0101), False),
        (At(X, Y, E - 0.0099), True),
        (At(X, Y, E - 0.0101), False),
        (At(X + 0.0219, Y, E), True),
        (At(X + 0.022, Y, E), True),
        (At(X + 0.0221, Y, E), False),
        (At(X + 0.016, Y + 0.016, E), False),
        (At(X + 0.015, Y + 0.015, E), True),
        (At(X, Y, E, tilt=14.0), True),
        (At(X, Y, E + 0.003, tilt=16.0), False),
        (At(X, Y, E, yaw=45.0), True),
        (At(X, Y + E, 0.0), False),
        (At(X, Y, 2 * E), False),
    ],
)
def test_on(blue: At, holds: bool) -> None:
    assert judge("on", ON, {"red": RED, "blue": blue}) is holds


def test_on_needs_the_right_way_round_and_directly() -> None:
    tower = {"red": RED, "blue": At(X, Y, E), "green": At(X, Y, 2 * E)}
    assert judge("on", {"a": "green", "b": "blue"}, tower)
    assert not judge("on", {"a": "green", "b": "red"}, tower)
    assert not judge("on", {"a": "red", "b": "blue"}, tower)
    assert judge("on", {"a": "green", "b": {"highest": ["red", "blue"]}}, tower)


def test_on_a_larger_block_measures_by_the_larger_edge() -> None:
    assert judge("on", {"a": "red", "b": "big"}, {"big": At(X, Y), "red": At(X, Y + 0.042, 0.08)})
    assert not judge("on", {"a": "red", "b": "big"}, {"big": At(X, Y), "red": At(X, Y + 0.0421, 0.08)})


def test_above_follows_the_stack() -> None:
    tower = {"red": RED, "blue": At(X, Y, E), "green": At(X, Y + 0.02, 2 * E)}
    assert judge("above", {"a": "green", "b": "red"}, tower)
    assert not judge("above", {"a": "red", "b": "green"}, tower)
    assert not judge("above", {"a": "green", "b": "red"}, {"red": RED, "green": At(X, Y, 2 * E)})
    beside = {"red": RED, "blue": At(X, Y + 0.1), "green": At(X, Y + 0.1, E)}
    assert not judge("above", {"a": "green", "b": "red"}, beside)


@pytest.mark.parametrize(("up", "holds"), [(0.0, True), (0.0099, True), (0.0101, False), (E, False)])
def test_on_table(up: float, holds: bool) -> None:
    assert judge("on_table", {"a": "red"}, {"red": At(X, Y, up)}) is holds


@pytest.mark.parametrize(
    ("blue", "clear"),
    [(At(X, Y, E), False), (At(X, Y + 0.035, E), False), (At(X, Y + E, E), True), (At(X, Y + 0.05), True)],
)
def test_clear(blue: At, clear: bool) -> None:
    assert judge("clear", {"a": "red"}, {"red": RED, "blue": blue}) is clear


@pytest.mark.parametrize(
    ("place", "holds"),
    [
        (At(X, -0.15), True),
        (At(X + 0.0499, -0.15), True),
        (At(X + 0.0501, -0.15), False),
        (At(X + 0.0499, -0.1001), True),
        (At(X, -0.15, 0.02), False),
    ],
)
def test_on_patch(place: At, holds: bool) -> None:
    assert judge("on_patch", {"a": "red", "patch": "mat"}, {"red": place}) is holds


def test_on_patch_counts_blocks_that_rest_on_others() -> None:
    both = {"red": At(X, -0.15), "blue": At(X, -0.15, E)}
    assert judge("on_patch", {"a": ["red", "blue"], "patch": "mat"}, both)
    assert not judge("on_patch", {"a": ["red", "blue"], "patch": "mat"}, {**both, "blue": At(X, 0.0)})


@pytest.mark.parametrize(("y", "holds"), [(0.15, True), (0.2099, True), (0.2101, False)])
def test_on_round_patch(y: float, holds: bool) -> None:
    assert judge("on_patch", {"a": "red", "patch": "spot"}, {"red": At(X, y)}) is holds
    assert not judge("on_patch", {"a": "red", "patch": "spot"}, {"red": At(X + 0.045, 0.195)})


@pytest.mark.parametrize(("y", "holds"), [(-0.0799, True), (-0.0801, False), (-0.15, False), (0.1, True)])
def test_empty(y: float, holds: bool) -> None:
    assert judge("empty", {"patch": "mat"}, {"red": At(X, y)}) is holds


WAYS = {"left_of": (0, 1), "right_of": (0, -1), "in_front_of": (-1, 0), "behind": (1, 0)}


@pytest.mark.parametrize("kind", WAYS)
@pytest.mark.parametrize(
    ("along", "across", "fields", "holds"),
    [
        (0.04, 0.0, {}, True),
        (0.0399, 0.0, {}, False),
        (0.3, 0.29, {}, True),
        (0.06, 0.0601, {}, False),
        (0.06, 0.06, {}, True),
        (0.06, 0.2, {"somewhere": True}, True),
        (0.0399, 0.0, {"somewhere": True}, False),
        (0.1, 0.02, {"directly": True}, True),
        (0.1, 0.0201, {"directly": True}, False),
        (0.06, 0.0, {"immediate": True}, True),
        (0.0601, 0.0, {"immediate": True}, False),
        (-0.06, 0.0, {}, False),
    ],
)
def test_directions(kind: str, along: float, across: float, fields: dict[str, bool], holds: bool) -> None:
    ux, uy = WAYS[kind]
    for side in (1, -1):
        blue = At(X + along * ux + side * across * uy, Y + along * uy + side * across * ux)
        assert judge(kind, {"a": "blue", "b": "red", **fields}, {"red": RED, "blue": blue}) is holds


def test_directions_of_groups_look_along_the_axis_alone() -> None:
    blocks = {"red": At(0.45, 0.05), "blue": At(0.65, 0.1), "green": At(0.55, -0.0), "yellow": At(0.42, -0.2)}
    fields = {"a": ["red", "blue"], "b": ["green", "yellow"]}
    assert judge("left_of", fields, blocks)
    assert not judge("left_of", fields, {**blocks, "green": At(0.55, 0.02)})


def test_directly_behind_a_group_is_not_past_its_ends() -> None:
    near = {"red": At(0.5, 0.03), "blue": At(0.5, -0.03)}
    pair = {"a": ["green", "yellow"], "b": ["red", "blue"], "directly": True}
    assert judge("behind", pair, {**near, "green": At(0.6, 0.03), "yellow": At(0.6, -0.03)})
    assert judge("behind", pair, {**near, "green": At(0.6, 0.0499), "yellow": At(0.6, -0.0499)})
    assert not judge("behind", pair, {**near, "green": At(0.6, 0.0501), "yellow": At(0.6, -0.03)})
    assert not judge("behind", pair, {**near, "green": At(0.6, 0.03), "yellow": At(0.53, -0.03)})
    one = {"a": "green", "b": ["red", "blue"], "directly": True}
    assert judge("behind", one, {**near, "green": At(0.6, 0.0)})
    assert not judge("behind", one, {**near, "green": At(0.6, -0.0501)})
    each = {"a": ["red", "blue"], "b": "green", "directly": True}
    assert judge("in_front_of", each, {"red": At(0.5, 0.0), "blue": At(0.45, 0.01), "green": At(0.6, 0.0)})
    assert not judge("in_front_of", each, {**near, "green": At(0.6, 0.0)})


def test_direction_of_a_tower_is_that_of_its_foot() -> None:
    blocks = {"red": At(X, 0.1), "blue": At(X, 0.1 - 0.02, E), "green": At(X, 0.05)}
    assert judge("left_of", {"a": {"lowest": ["blue", "red"]}, "b": "green"}, blocks)
    assert not judge("left_of", {"a": "blue", "b": "green"}, blocks)


def test_beside_a_patch_in_a_direction_is_off_the_patch() -> None:
    assert judge("left_of", {"a": "red", "b": "mat"}, {"red": At(X, -0.1)})
    assert not judge("left_of", {"a": "red", "b": "mat"}, {"red": At(X, -0.1001)})


@pytest.mark.parametrize(
    ("kind", "blue", "holds"),
    [
        ("beside", At(X, 0.08), True),
        ("beside", At(X, 0.0801), False),
        ("beside", At(X + 0.06, 0.06), True),
        ("beside", At(X + 0.0687, 0.0687), False),
        ("beside", At(X, 0.05, 0.0099), True),
        ("beside", At(X, 0.05, 0.0101), False),
        ("beside", At(X, 0.05, tilt=16.0), False),
        ("beside", At(X, 0.0, E), False),
        ("adjacent", At(X, 0.06), True),
        ("adjacent", At(X, 0.0601), False),
        ("touching", At(X, 0.042), True),
        ("touching", At(X, 0.0421), False),
        ("touching", At(X, 0.04), True),
        ("touching", At(X, 0.03, E), True),
        ("touching", At(X, 0.03, E + 0.0019), True),
        ("touching", At(X, 0.03, E + 0.0021), False),
        ("touching", At(X, 0.0482, yaw=45.0), True),
        ("touching", At(X, 0.0504, yaw=45.0), False),
        ("near", At(X + 0.06, 0.08), True),
        ("near", At(X + 0.0601, 0.08), False),
        ("near", At(X, 0.0999, 0.3), True),
        ("apart", At(X + 0.06, 0.08), True),
        ("apart", At(X + 0.0599, 0.08), False),
    ],
)
def test_closeness(kind: str, blue: At, holds: bool) -> None:
    for a, b in (("red", "blue"), ("blue", "red")):
        assert judge(kind, {"a": a, "b": b}, {"red": RED, "blue": blue}) is holds


def test_closeness_of_groups_is_that_of_the_nearest() -> None:
    blocks = {"red": RED, "blue": At(X, 0.06), "green": At(X, 0.24)}
    assert judge("beside", {"a": ["red"], "b": ["blue", "green"]}, blocks)
    assert judge("near", {"a": ["red", "green"], "b": "blue"}, blocks)
    assert not judge("apart", {"a": "red", "b": ["blue", "green"]}, blocks)


@pytest.mark.parametrize(
    ("measure", "y", "holds"),
    [("centres", 0.14, False), ("centres", 0.15, True), ("centres", 0.1601, False), ("faces", 0.19, True)],
)
def test_distance(measure: str, y: float, holds: bool) -> None:
    fields = {"a": "red", "b": "blue", "minimum": 0.145, "maximum": 0.16, "measure": measure}
    assert judge("distance", fields, {"red": RED, "blue": At(X, y)}) is holds


@pytest.mark.parametrize(
    ("blue", "holds"),
    [
        (At(X, 0.0), True),
        (At(X + 0.04, 0.0), True),
        (At(X + 0.0401, 0.0), False),
        (At(X, 0.0999), True),
        (At(X, 0.1), False),
        (At(X, -0.14), False),
    ],
)
def test_between(blue: At, holds: bool) -> None:
    ends = {"red": At(X, 0.1), "green": At(X, -0.1)}
    for b, c in (("red", "green"), ("green", "red")):
        assert judge("between", {"a": "blue", "b": b, "c": c}, {**ends, "blue": blue}) is holds


def test_between_in_a_tower_is_vertical() -> None:
    tower = {"red": RED, "blue": At(X, Y, E), "green": At(X, Y, 2 * E)}
    assert judge("between", {"a": "blue", "b": "red", "c": "green"}, tower)
    assert not judge("between", {"a": "red", "b": "blue", "c": "green"}, tower)


@pytest.mark.parametrize(
    ("blue", "holds"),
    [
        (At(X, 0.05), True),
        (At(X, 0.005), True),
        (At(X, 0.0049), False),
        (At(X, 0.0), False),
        (At(X, -0.05), False),
        (At(X, 0.2), True),
        (At(X + 0.3, 0.01), False),
        (At(X, 0.1, E), True),
    ],
)
def test_closer(blue: At, holds: bool) -> None:
    ends = {"red": At(X, 0.1), "green": At(X, -0.1), "blue": blue}
    assert judge("closer", {"a": "blue", "b": "red", "c": "green"}, ends) is holds


def test_closer_is_each_of_some_to_each_and_any_of_others() -> None:
    blocks = {"red": At(X, 0.1), "green": At(X, -0.1), "blue": At(X, 0.04), "yellow": At(X, 0.18)}
    assert judge("closer", {"a": ["blue", "yellow"], "b": "red", "c": "green"}, blocks)
    assert judge("closer", {"a": "blue", "b": ["red"], "c": ["green", "yellow"]}, blocks)
    assert not judge("closer", {"a": "blue", "b": ["red", "green"], "c": "yellow"}, blocks)
    assert not judge("closer", {"a": "blue", "b": "red", "c": "green", "by": 0.1}, blocks)
    assert judge("closer", {"a": "spot", "b": "red", "c": "green"}, blocks)
    assert judge("closer", {"a": "green", "b": "mat", "c": "spot"}, blocks)


@pytest.mark.parametrize(
    ("blue", "holds"),
    [
        (At(X, 0.0), True),
        (At(X, 0.0049), True),
        (At(X, 0.0051), False),
        (At(X + 0.1, 0.0), True),
        (At(X + 0.1, 0.02), False),
        (At(X, 0.2), False),
    ],
)
def test_equidistant(blue: At, holds: bool) -> None:
    ends = {"red": At(X, 0.1), "green": At(X, -0.1), "blue": blue}
    for b, c in (("red", "green"), ("green", "red"), ("spot", "mat")):
        near = ends if b != "spot" else {"blue": At(blue.x - X + 0.55, blue.y)}
        assert judge("equidistant", {"a": "blue", "b": b, "c": c}, near) is holds


def test_equidistant_from_three_is_from_all_of_them() -> None:
    ends = {"red": At(X, 0.1), "green": At(X, -0.1), "blue": At(X, 0.0)}
    node = {"a": "blue", "b": "red", "c": ["green", "yellow"]}
    assert judge("equidistant", node, {**ends, "yellow": At(X + 0.1, 0.0)})
    assert not judge("equidistant", node, {**ends, "yellow": At(X + 0.12, 0.0)})
    foot = {"lowest": ["yellow", "green"]}
    tower = {**ends, "yellow": At(X, -0.08, E)}
    assert judge("equidistant", {"a": "blue", "b": "red", "c": foot}, tower)


@pytest.mark.parametrize(
    ("region", "inside", "outside"),
    [
        ("left_half", At(X, 0.02), At(X, 0.0199)),
        ("right_half", At(X, -0.02), At(X, 0.0)),
        ("far_half", At(0.57, 0.2), At(0.5699, 0.2)),
        ("near_half", At(0.53, 0.0), At(0.5301, 0.0)),
        ("middle", At(0.55, 0.0799), At(0.6, 0.07)),
        ("far_left_corner", At(0.601, 0.131), At(0.599, 0.24)),
        ("near_right_corner", At(0.42, -0.2), At(0.42, -0.1299)),
        ("corner", At(0.61, -0.14), At(0.55, -0.24)),
        ("edge", At(0.55, 0.23), At(0.55, 0.0)),
        ("left_edge", At(0.55, 0.2001), At(0.55, 0.1999)),
        ("near_edge", At(0.44, 0.0), At(0.46, 0.0)),
    ],
)
def test_regions(region: str, inside: At, outside: At) -> None:
    assert judge("in_region", {"a": "red", "region": region}, {"red": inside})
    assert not judge("in_region", {"a": "red", "region": region}, {"red": outside})


def test_settled_needs_support_rest_and_release() -> None:
    tower = scene(red=RED, blue=At(X, 0.03, E))
    assert settled(tower)
    assert not settled(scene(red=RED, blue=At(X, 0.06, E)))
    assert not settled(scene(red=At(X, Y, 0.0101)))
    assert settled(scene(red=At(X, Y, 0.0099)))
    moving = type(tower)(tower.world, tower.position, tower.orientation, moving=frozenset({"blue"}))
    held = type(tower)(tower.world, tower.position, tower.orientation, held=frozenset({"blue"}))
    assert not settled(moving)
    assert not settled(held)
