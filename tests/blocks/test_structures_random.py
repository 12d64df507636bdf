"""Random structures: arranged states satisfy them and stand by themselves, and no near-miss satisfies them."""

from __future__ import annotations

import math
from random import Random

import pytest

from rpg.blocks.arrange import Impossible, arrange
from rpg.blocks.evaluate import evaluate, settled
from rpg.blocks.near_miss import near_misses
from rpg.blocks.physics import Physics
from rpg.blocks.state import World
from rpg.blocks.symmetry import interchangeable, namings, rename_state
from tests.blocks.random_structures import random_structure

DRIFT = 0.001
FEWEST_MISSES = 5


@pytest.mark.parametrize("seed", range(150))
def test_arranged_structures_hold_and_their_near_misses_do_not(seed: int) -> None:
    goal, assets = random_structure(seed)
    world = World(assets)
    try:
        made = arrange(goal, world, rng=Random(seed))[0]  # type: ignore[arg-type]
    except Impossible:
        pytest.skip("these blocks cannot form it")
    assert evaluate(goal, made).margin > 0.01 and settled(made)  # type: ignore[arg-type]
    physics = Physics(world)
    physics.write(made)
    physics.step(20)
    later = physics.read()
    assert evaluate(goal, later) and settled(later)  # type: ignore[arg-type]
    assert max(math.dist(later.position[n], made.position[n]) for n in made.position) < DRIFT
    names = namings(interchangeable(goal, world))[:100]  # type: ignore[arg-type]
    misses = list(near_misses(goal, made, Random(seed)))  # type: ignore[arg-type]
    assert len(misses) >= FEWEST_MISSES
    for miss in misses:
        holds = any(evaluate(goal, rename_state(miss.state, naming)) for naming in names)  # type: ignore[arg-type]
        assert not (holds and settled(miss.state)), miss.what
