"""Blocks that may sleep come to the same end as blocks that stay awake. `make bench-sleep` shows it at length."""

from __future__ import annotations

import pytest

from rpg.blocks.constants import TABLE_Z
from rpg.blocks.physics import Physics
from rpg.blocks.state import BlockState, World
from rpg.ir.assets import ColoredCube

EDGE = 0.04
STEPS = 100
UPRIGHT = (1.0, 0.0, 0.0, 0.0)


def tower(overhangs: tuple[float, ...]) -> BlockState:
    """Blocks on each other, each moved to the side by so much (m)."""
    world = World(tuple(ColoredCube(name=f"block_{i}", color="red", size=EDGE) for i in range(len(overhangs))))
    places = {
        name: (0.5 + x, 0.0, TABLE_Z + EDGE * (i + 0.5))
        for i, (name, x) in enumerate(zip(world.blocks, overhangs, strict=True))
    }
    return BlockState(world, places, dict.fromkeys(places, UPRIGHT))


def ended(state: BlockState, *, sleep: bool) -> BlockState:
    physics = Physics(state.world)
    if sleep:
        physics.let_sleep()
    physics.write(state)
    physics.data.qvel[3::6] = 0.02
    physics.step(STEPS)
    return physics.read()


def stands(before: BlockState, after: BlockState) -> bool:
    return all(abs(place[2] - before.position[name][2]) < 0.01 for name, place in after.position.items())


@pytest.mark.parametrize("over", [-0.003, -0.0015, -0.001, 0.0, 0.0005, 0.001, 0.003])
@pytest.mark.parametrize("count", [2, 4])
def test_what_stands_or_falls_does_so_asleep(over: float, count: int) -> None:
    state = tower((0.0, *[EDGE / 2 + over] * (count - 1)))
    awake, asleep = ended(state, sleep=False), ended(state, sleep=True)
    assert stands(state, awake) is stands(state, asleep)
    assert awake.moving == asleep.moving


def test_both_ends_are_among_the_cases() -> None:
    steady, falling = (tower((0.0, EDGE / 2 + over)) for over in (-0.003, 0.003))
    assert stands(steady, ended(steady, sleep=True)) and not stands(falling, ended(falling, sleep=True))


def test_sleepers_lie_still_and_wake_when_they_are_hit() -> None:
    state = tower((0.0, 0.0))
    physics = Physics(state.world)
    physics.let_sleep()
    physics.write(state)
    physics.step(STEPS)
    assert not physics.data.qvel.any()
    physics.data.qvel[6:9] = (1.0, 0.0, 0.0)
    physics.step(20)
    assert physics.read().position["block_1"][0] > 0.52


def test_a_shared_model_stays_awake() -> None:
    state = tower((0.0, 0.0))
    sleepy, other = Physics(state.world), Physics(state.world)
    assert sleepy.model is other.model
    awake = other.model.opt.enableflags, other.model.opt.sleep_tolerance
    sleepy.let_sleep()
    for physics in (sleepy, other):
        physics.write(state)
        physics.step(STEPS)
    assert sleepy.asleep() and not other.asleep()
    assert (other.model.opt.enableflags, other.model.opt.sleep_tolerance) == awake
