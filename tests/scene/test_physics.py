"""The fixed physics: what must stand stands, what must fall falls, within the steps that the gates wait."""

from __future__ import annotations

import math
from random import Random

import pytest

from rpg.blocks.physics import Physics
from rpg.blocks.state import BlockState, Vec3
from tests.scene.builders import HALF, about, at, plain, tower

EDGE = 2 * HALF
DIAGONAL = HALF * math.sqrt(2)


def after(state: BlockState, control_steps: int = 50) -> tuple[BlockState, float]:
    """The state some control steps later, and how far the farthest block has moved (m)."""
    physics = Physics(state.world)
    physics.write(state)
    physics.step(control_steps)
    assert physics.sane()
    end = physics.read()
    return end, max(math.dist(end.position[name], state.position[name]) for name in state.position)


def pyramid(base: int) -> list[Vec3]:
    return [
        (0.55, (column - (base - 1 - layer) / 2) * EDGE, HALF + EDGE * layer)
        for layer in range(base)
        for column in range(base - layer)
    ]


def cube_of(side: int) -> list[Vec3]:
    cells = range(side)
    return [(0.5 + EDGE * i, EDGE * j, HALF + EDGE * k) for k in cells for i in cells for j in cells]


def square_pyramid() -> list[Vec3]:
    return [
        (0.55 + (i - (n - 1) / 2) * EDGE, (j - (n - 1) / 2) * EDGE, HALF + EDGE * (3 - n))
        for n in (3, 2, 1)
        for i in range(n)
        for j in range(n)
    ]


@pytest.mark.parametrize(
    "places",
    [tower(1), tower(5), tower(10), pyramid(6), square_pyramid(), cube_of(3)],
    ids=["one", "tower of 5", "tower of 10", "pyramid of 21", "square pyramid", "27 in a cube"],
)
def test_structures_placed_exactly_stay_where_they_are(places: list[Vec3]) -> None:
    end, drift = after(at(plain(len(places)), *places), 100)
    assert drift < 0.001
    assert not end.moving


@pytest.mark.parametrize(("count", "offset"), [(2, 0.008), (5, 0.004), (10, 0.002), (15, 0.0005)])
@pytest.mark.parametrize("seed", range(3))
def test_towers_of_turned_and_shifted_blocks_stand_still(count: int, offset: float, seed: int) -> None:
    rng = Random(seed)
    places, turns = [], {}
    for level in range(count):
        places.append((0.55 + rng.uniform(-offset, offset), rng.uniform(-offset, offset), HALF + EDGE * level))
        turns[f"b{level}"] = about("z", rng.uniform(-180, 180))
    state = at(plain(count), *places, turns=turns)
    physics = Physics(state.world)
    physics.write(state)
    fastest = 0.0
    for _ in range(40):
        physics.step()
        fastest = max(fastest, physics.fastest())
    assert fastest < 0.05
    assert physics.fastest() < 0.005


@pytest.mark.parametrize("axis", ["x", "y"])
def test_a_cube_balanced_on_its_edge_falls(axis: str) -> None:
    w, x, y, z = (round(part, 6) for part in about(axis, 45))
    end, drift = after(at(plain(1), (0.55, 0.0, round(DIAGONAL, 6)), turns={"b0": (w, x, y, z)}))
    assert drift > 0.01
    assert end.tilt("b0") < 1.0


def test_a_centre_just_past_the_edge_of_its_support_falls() -> None:
    end, _ = after(at(plain(2), (0.55, 0.0, HALF), (0.55 + HALF + 0.001, 0.0, 3 * HALF)))
    assert end.position["b1"][2] < end.position["b0"][2] + HALF


def test_a_centre_just_inside_the_edge_of_its_support_stays() -> None:
    _, drift = after(at(plain(2), (0.55, 0.0, HALF), (0.55 + HALF - 0.001, 0.0, 3 * HALF)))
    assert drift < 0.001


def test_a_lifted_block_is_moving_while_it_falls_and_lands() -> None:
    state = at(plain(1), (0.55, 0.0, 0.2))
    falling, _ = after(state, 2)
    landed, _ = after(state, 50)
    assert falling.moving == {"b0"}
    assert not landed.moving
    assert landed.bottom("b0") == pytest.approx(0.95, abs=1e-3)


def test_overlapping_blocks_are_driven_apart() -> None:
    _, drift = after(at(plain(2), (0.55, 0.0, HALF), (0.55, 0.03, HALF)))
    assert drift > 0.003
