"""What must hold of every goal, over random goals that are known to be satisfiable."""

from __future__ import annotations

from random import Random

from hypothesis import given, settings
from hypothesis import strategies as st

from rpg.blocks.arrange import arrange
from rpg.blocks.evaluate import evaluate
from rpg.blocks.state import BlockState, World
from rpg.blocks.symmetry import interchangeable, namings, rename_state
from rpg.ir import goal as g
from rpg.ir.walk import rename
from tests.blocks.random_goals import random_task

SEEDS = st.integers(min_value=0, max_value=2**32)
some = settings(max_examples=60, deadline=None, derandomize=True)


def holds(goal: g.Goal, state: BlockState) -> bool:
    cells = interchangeable(goal, state.world)
    return any(evaluate(goal, rename_state(state, naming)).value for naming in namings(cells))


@some
@given(SEEDS)
def test_names_do_not_matter(seed: int) -> None:
    goal, world, state = random_task(seed)
    new = {name: f"thing_{k}" for k, name in enumerate(sorted(world.assets, reverse=True))}
    renamed = World([asset.model_copy(update={"name": new[name]}) for name, asset in world.assets.items()])
    other = BlockState(
        renamed,
        {new[name]: place for name, place in state.position.items()},
        {new[name]: turn for name, turn in state.orientation.items()},
    )
    assert evaluate(rename(goal, new), other) == evaluate(goal, state)


@some
@given(SEEDS)
def test_look_alikes_may_change_places(seed: int) -> None:
    goal, world, state = random_task(seed)
    rng = Random(seed)
    names = list(world.blocks)
    for _ in range(3):
        a, b = rng.sample(names, 2)
        if world.look[a] == world.look[b]:
            assert holds(goal, rename_state(state, {a: b, b: a}))


@some
@given(SEEDS)
def test_the_order_of_blocks_does_not_matter(seed: int) -> None:
    goal, world, state = random_task(seed)
    names = list(world.blocks)
    Random(seed).shuffle(names)
    other = BlockState(world, {n: state.position[n] for n in names}, {n: state.orientation[n] for n in names})
    found, expected = evaluate(goal, other), evaluate(goal, state)
    assert found.value == expected.value
    assert abs(found.margin - expected.margin) < 1e-9


@some
@given(SEEDS)
def test_equal_generators_give_equal_states(seed: int) -> None:
    goal, world, _ = random_task(seed)
    first, second = (arrange(goal, world, rng=Random(seed), count=2) for _ in range(2))
    assert [s.position for s in first] == [s.position for s in second]
    assert [s.orientation for s in first] == [s.orientation for s in second]
