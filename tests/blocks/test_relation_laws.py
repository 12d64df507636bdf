"""Laws of the relations: turning, shifting and mirroring a scene changes directions as it should, and nothing else."""

from __future__ import annotations

import math
from random import Random
from typing import Any

from hypothesis import given, settings
from hypothesis import strategies as st

from rpg.blocks.evaluate import evaluate, settled
from rpg.blocks.state import BlockState, World, product, yaw_quat
from rpg.ir import goal as g
from rpg.ir.goal import GOAL
from tests.blocks.random_goals import random_atom, random_state, random_world

CENTRE = (0.55, 0.0)
MIRRORED = {"left_of": "right_of", "right_of": "left_of"}
TURNED = {"left_of": "in_front_of", "in_front_of": "right_of", "right_of": "behind", "behind": "left_of"}
"""A quarter turn counter-clockwise from above takes what is on the left (+y) to the front (-x)."""
INVARIANT = ("on", "above", "touching", "beside", "adjacent", "near", "apart", "on_table", "clear", "between", "stack",
             "closer", "equidistant")  # fmt: skip
some = settings(max_examples=80, deadline=None, derandomize=True)
SEEDS = st.integers(min_value=0, max_value=2**32)


def scene(seed: int) -> tuple[World, BlockState, list[g.Goal]]:
    """A world without patches, a state of it, and atoms that may or may not hold."""
    rng = Random(seed)
    drawn = random_world(rng)
    world = World(drawn.blocks.values())
    return world, random_state(world, rng), [random_atom(world, rng) for _ in range(12)]


def turned(state: BlockState, degrees: float, dx: float = 0.0, dy: float = 0.0) -> BlockState:
    """The whole scene turned about the middle of the table, then shifted."""
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    position = {}
    for name, (x, y, z) in state.position.items():
        u, v = x - CENTRE[0], y - CENTRE[1]
        position[name] = (CENTRE[0] + c * u - s * v + dx, CENTRE[1] + s * u + c * v + dy, z)
    turn = yaw_quat(math.radians(degrees))
    return BlockState(state.world, position, {n: product(turn, q) for n, q in state.orientation.items()})


def mirrored(state: BlockState) -> BlockState:
    """Left and right exchanged; the blocks of these scenes are not turned."""
    return BlockState(state.world, {n: (x, -y, z) for n, (x, y, z) in state.position.items()}, state.orientation)


def renamed(atom: g.Goal, kinds: dict[str, str]) -> g.Goal:
    data: dict[str, Any] = atom.model_dump()
    return GOAL.validate_python({**data, "kind": kinds.get(data["kind"], data["kind"])})


def same(a: g.Goal, before: BlockState, b: g.Goal, after: BlockState) -> None:
    one, two = evaluate(a, before), evaluate(b, after)
    if abs(one.margin) > 1e-6:
        assert one.value == two.value, a
        assert abs(one.margin - two.margin) < 1e-6, a


@some
@given(SEEDS, st.floats(-180, 180), st.floats(-0.3, 0.3), st.floats(-0.3, 0.3))
def test_most_relations_do_not_see_where_a_scene_lies_or_how_it_is_turned(
    seed: int, degrees: float, dx: float, dy: float
) -> None:
    _, state, atoms = scene(seed)
    for atom in atoms:
        if atom.kind in INVARIANT:
            same(atom, state, atom, turned(state, degrees, dx, dy))
    assert settled(state).value == settled(turned(state, degrees, dx, dy)).value


@some
@given(SEEDS)
def test_a_quarter_turn_takes_each_direction_to_the_next(seed: int) -> None:
    _, state, atoms = scene(seed)
    for atom in atoms:
        if atom.kind in TURNED:
            same(atom, state, renamed(atom, TURNED), turned(state, 90.0))


@some
@given(SEEDS)
def test_a_mirror_exchanges_left_and_right_alone(seed: int) -> None:
    _, state, atoms = scene(seed)
    for atom in atoms:
        if atom.kind in INVARIANT or atom.kind in TURNED:
            same(atom, state, renamed(atom, MIRRORED), mirrored(state))


@some
@given(SEEDS)
def test_what_is_left_of_another_has_that_on_its_right(seed: int) -> None:
    world, state, _ = scene(seed)
    rng = Random(seed)
    opposite = {"left_of": "right_of", "in_front_of": "behind"}
    for kind, other in opposite.items():
        a, b = rng.sample(list(world.blocks), 2)
        one, two = (GOAL.validate_python({"kind": k, "a": p, "b": q}) for k, p, q in ((kind, a, b), (other, b, a)))
        same(one, state, two, state)
        assert not (evaluate(one, state) and evaluate(renamed(one, {kind: other}), state))


@some
@given(SEEDS)
def test_connectives_follow_their_truth_tables(seed: int) -> None:
    _, state, atoms = scene(seed)
    values = [evaluate(atom, state).value for atom in atoms]
    assert evaluate(g.All(goals=tuple(atoms)), state).value == all(values)
    assert evaluate(g.Any(goals=tuple(atoms)), state).value == any(values)
    for atom, value in zip(atoms, values, strict=True):
        assert evaluate(g.Not(goal=atom), state).value != value
        assert evaluate(g.Not(goal=g.Not(goal=atom)), state) == evaluate(atom, state)


@some
@given(SEEDS, st.integers(0, 4), st.integers(0, 4))
def test_counts_count(seed: int, low: int, high: int) -> None:
    world, state, _ = scene(seed)
    names = tuple(world.blocks)
    each = GOAL.validate_python({"kind": "on_table", "a": "each"})
    number = sum(evaluate(GOAL.validate_python({"kind": "on_table", "a": name}), state).value for name in names)
    count = g.Count(over=names, at_least=low, at_most=high, goal=each)
    assert evaluate(count, state).value == (low <= number <= high)
