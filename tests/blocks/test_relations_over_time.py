"""Conditions relative to the start, and which face of a block points where."""

from __future__ import annotations

from typing import Any

import pytest

from rpg.blocks.evaluate import evaluate
from rpg.blocks.state import Quat
from tests.blocks.relation_states import At, goal, scene

X = 0.55
START = scene(red=At(X, 0.0), blue=At(X, 0.1), green=At(X, -0.1))
HALF = 0.5**0.5


def judge(kind: str, fields: dict[str, Any], **blocks: At) -> bool:
    places = {"red": At(X, 0.0), "blue": At(X, 0.1), "green": At(X, -0.1), **blocks}
    return evaluate(goal(kind, **fields), scene(START, **places)).value


@pytest.mark.parametrize(("dy", "stayed", "moved"), [(0.0, 1, 0), (0.02, 1, 0), (0.0201, 0, 0), (0.05, 0, 1)])
def test_stayed_and_moved(dy: float, stayed: int, moved: int) -> None:
    assert judge("stayed", {"a": "red"}, red=At(X, dy)) is bool(stayed)
    assert judge("moved", {"a": "red"}, red=At(X, dy)) is bool(moved)


def test_lifting_is_moving() -> None:
    assert not judge("stayed", {"a": "red"}, red=At(X, 0.0, 0.04))
    assert judge("moved", {"a": "red"}, red=At(X, 0.0, 0.05))


SHIFTED: list[tuple[dict[str, Any], tuple[float, float], bool]] = [
    ({"toward": "left"}, (0.0, 0.05), True),
    ({"toward": "left"}, (0.0, 0.0499), False),
    ({"toward": "left"}, (0.0, -0.05), False),
    ({"toward": "left"}, (0.05, 0.0501), True),
    ({"toward": "left"}, (0.0502, 0.0501), False),
    ({"toward": "right"}, (0.0, -0.2), True),
    ({"toward": "front"}, (-0.06, 0.02), True),
    ({"toward": "back"}, (0.06, -0.02), True),
    ({"toward": "back"}, (-0.06, 0.0), False),
    ({"toward": "left", "at_least": 0.09, "at_most": 0.11, "across": 0.02}, (0.0199, 0.1099), True),
    ({"toward": "left", "at_least": 0.09, "at_most": 0.11, "across": 0.02}, (0.0, 0.1101), False),
    ({"toward": "left", "at_least": 0.09, "at_most": 0.11, "across": 0.02}, (-0.0201, 0.1), False),
]


@pytest.mark.parametrize(("fields", "by", "holds"), SHIFTED)
def test_shifted(fields: dict[str, Any], by: tuple[float, float], holds: bool) -> None:
    assert judge("shifted", {"a": "red", **fields}, red=At(X + by[0], by[1])) is holds


def test_each_block_is_shifted() -> None:
    both = {"a": ["red", "blue"], "toward": "back"}
    assert judge("shifted", both, red=At(X + 0.06, 0.0), blue=At(X + 0.06, 0.1))
    assert not judge("shifted", both, red=At(X + 0.06, 0.0))


@pytest.mark.parametrize(
    ("dy", "closer", "farther"), [(0.0, 0, 0), (0.02, 1, 0), (0.0199, 0, 0), (-0.0201, 0, 1), (0.05, 1, 0)]
)
def test_approached_and_receded(dy: float, closer: int, farther: int) -> None:
    both = {"a": "red", "b": "blue"}
    assert judge("approached", both, red=At(X, dy)) is bool(closer)
    assert judge("receded", both, red=At(X, dy)) is bool(farther)


def test_blocks_come_closer_together_two_by_two() -> None:
    three = {"a": ["red", "blue", "green"], "b": ["red", "blue", "green"]}
    assert judge("approached", three, blue=At(X, 0.07), green=At(X, -0.07))
    assert not judge("approached", three, blue=At(X, 0.07))
    assert not judge("receded", three, blue=At(X, 0.07), green=At(X, -0.07))
    assert judge("receded", three, blue=At(X, 0.13), green=At(X, -0.13))


def test_a_distance_that_changed_by_so_much() -> None:
    some = {"a": "red", "b": "blue", "at_least": 0.04, "at_most": 0.06}
    assert judge("approached", some, red=At(X, 0.05))
    assert not judge("approached", some, red=At(X, 0.0601))
    assert judge("receded", some, red=At(X, -0.05))


def test_swapped() -> None:
    both = {"a": "red", "b": "blue"}
    assert judge("swapped", both, red=At(X, 0.1), blue=At(X, 0.0))
    assert judge("swapped", both, red=At(X, 0.1299), blue=At(X + 0.0299, 0.0))
    assert not judge("swapped", both, red=At(X, 0.1301), blue=At(X, 0.0))
    assert not judge("swapped", both, red=At(X, 0.1), blue=At(X, 0.2))
    assert not judge("swapped", both)


def test_took_place() -> None:
    where = {"a": "red", "b": "blue"}
    assert judge("took_place", where, red=At(X, 0.1), blue=At(X, 0.2))
    assert judge("took_place", where, red=At(X, 0.1299), blue=At(X, 0.0))
    assert not judge("took_place", where, red=At(X, 0.1301), blue=At(X, 0.0))
    assert not judge("took_place", where, red=At(X, 0.0), blue=At(X, 0.2))
    assert not judge("took_place", where, red=At(X, 0.2), blue=At(X, 0.0))
    assert not judge("took_place", where)


def test_groups_swap_in_any_pairing() -> None:
    fields = {"a": ["red", "blue"], "b": ["green", "yellow"]}
    start = scene(red=At(X, 0.0), blue=At(X, 0.1), green=At(X, -0.1), yellow=At(X, 0.2))
    crossed = scene(start, red=At(X, 0.2), blue=At(X, -0.1), green=At(X, 0.0), yellow=At(X, 0.1))
    straight = scene(start, red=At(X, -0.1), blue=At(X, 0.2), green=At(X, 0.1), yellow=At(X, 0.0))
    half = scene(start, red=At(X, -0.1), blue=At(X, 0.1), green=At(X, 0.0), yellow=At(X, 0.2))
    assert evaluate(goal("swapped", **fields), crossed)
    assert evaluate(goal("swapped", **fields), straight)
    assert not evaluate(goal("swapped", **fields), half)


@pytest.mark.parametrize(
    ("yaw", "degrees", "either", "holds"),
    [
        (90.0, 90.0, False, True),
        (104.9, 90.0, False, True),
        (105.1, 90.0, False, False),
        (-90.0, 90.0, False, False),
        (-90.0, 90.0, True, True),
        (180.0, 180.0, False, True),
        (-179.0, 180.0, False, True),
        (0.0, 90.0, True, False),
    ],
)
def test_turned(yaw: float, degrees: float, either: bool, holds: bool) -> None:
    fields = {"block": "red", "degrees": degrees, "either_way": either}
    assert judge("turned", fields, red=At(X, 0.0, yaw=yaw)) is holds


def test_turned_is_about_the_vertical() -> None:
    assert not judge("turned", {"block": "red", "degrees": 90.0}, red=At(X, 0.0, yaw=90.0, tilt=20.0))


FACING: list[tuple[dict[str, Any], Quat | float, bool]] = [
    ({"face": "top", "toward": "up"}, 0.0, True),
    ({"face": "top", "toward": "up"}, 77.0, True),
    ({"face": "top", "toward": "up", "turn": 0.0}, 19.0, True),
    ({"face": "top", "toward": "up", "turn": 0.0}, 21.0, False),
    ({"face": "top", "toward": "up", "turn": 180.0}, 0.0, False),
    ({"face": "top", "toward": "up", "turn": 180.0}, 180.0, True),
    ({"face": "top", "toward": "up", "turn": 90.0}, 90.0, True),
    ({"face": "top", "toward": "up", "turn": 90.0}, -90.0, False),
    ({"label": "A", "toward": "viewer"}, 0.0, True),
    ({"label": "C", "toward": "viewer"}, 0.0, True),
    ({"label": "B", "toward": "viewer"}, 0.0, False),
    ({"label": "B", "toward": "front"}, 180.0, True),
    ({"label": "D", "toward": "left"}, 13.0, True),
    ({"label": "D", "toward": "left"}, 15.0, False),
    ({"label": "F", "toward": "up"}, (0.0, 1.0, 0.0, 0.0), True),
    ({"label": "B", "toward": "up"}, (HALF, 0.0, -HALF, 0.0), True),
    ({"label": "Z", "toward": "up"}, 0.0, False),
]


@pytest.mark.parametrize(("fields", "turn", "holds"), FACING)
def test_facing(fields: dict[str, Any], turn: Quat | float, holds: bool) -> None:
    place = At(X, 0.0, quat=turn) if isinstance(turn, tuple) else At(X, 0.0, yaw=turn)
    assert evaluate(goal("facing", block="cube", **fields), scene(cube=place)).value is holds


def test_a_covered_face_is_not_shown() -> None:
    covered = scene(cube=At(X, 0.0), red=At(X, 0.0, 0.04))
    assert not evaluate(goal("facing", block="cube", face="top", toward="up"), covered)
    assert evaluate(goal("facing", block="cube", face="back", toward="front"), covered)
