"""Starts: what a seed draws, and what stays the same when the task around it changes."""

from __future__ import annotations

from itertools import combinations, islice

import pytest

from rpg.blocks.constants import TABLE_Z, WORKSPACE_X, WORKSPACE_Y
from rpg.blocks.evaluate import evaluate, settled
from rpg.blocks.geometry import footprint_gap
from rpg.blocks.initial import foresee, foreseen, sample_start
from rpg.blocks.physics import Physics, leave, left
from rpg.blocks.state import BlockState, World
from rpg.core.diagnostics import Refusal
from rpg.ir.assets import Asset, ColoredCube, GoalPatch, SemanticCube
from rpg.ir.order import Order
from rpg.ir.relations import InRegion
from rpg.ir.schema import InitialState, Start, Vacancy
from rpg.ir.structures import Stack

FIVE: list[Asset] = [ColoredCube(name=f"{c}_block", color=c) for c in ("red", "green", "blue", "yellow", "pink")]
PATCH = GoalPatch(name="patch", color="green", position=(0.55, 0.0), size=(0.1, 0.2))
SCATTERED = InitialState()


def in_workspace(state: BlockState) -> bool:
    return all(
        WORKSPACE_X[0] <= x <= WORKSPACE_X[1] and WORKSPACE_Y[0] <= y <= WORKSPACE_Y[1]
        for x, y, _ in state.position.values()
    )


@pytest.mark.parametrize("seed", range(20))
def test_scattered_blocks_lie_flat_apart_and_off_the_patches(seed: int) -> None:
    state = sample_start(SCATTERED, World([*FIVE, PATCH]), seed)
    assert in_workspace(state)
    assert all(state.tilt(name) == pytest.approx(0, abs=1e-4) for name in state.position)
    assert all(z == pytest.approx(TABLE_Z + 0.02) for _, _, z in state.position.values())
    assert all(footprint_gap(state, a, b) > 0.004 for a, b in combinations(state.position, 2))
    assert all(footprint_gap(state, name, "patch") > 0.004 for name in state.position)


def test_the_same_seed_draws_the_same_start_and_another_one_does_not() -> None:
    world = World(FIVE)
    assert sample_start(SCATTERED, world, 7).position == sample_start(SCATTERED, world, 7).position
    assert sample_start(SCATTERED, world, 7).position != sample_start(SCATTERED, world, 8).position


def test_thirty_blocks_find_room() -> None:
    many = World([ColoredCube(name=f"b{k}", color="red") for k in range(30)])
    state = sample_start(SCATTERED, many, 0)
    assert min(footprint_gap(state, a, b) for a, b in combinations(state.position, 2)) > 0.0


def test_more_than_the_table_holds_is_refused() -> None:
    large = World([ColoredCube(name=f"b{k}", color="red", size=0.12) for k in range(30)])
    with pytest.raises(Refusal) as refusal:
        sample_start(SCATTERED, large, 0)
    assert [d.code for d in refusal.value.diagnostics] == ["start-no-room"]


def test_an_added_block_leaves_the_others_where_they_were() -> None:
    before = sample_start(SCATTERED, World(FIVE[:4]), 3)
    after = sample_start(SCATTERED, World(FIVE), 3)
    assert all(after.position[name] == before.position[name] for name in before.position)


def test_a_removed_block_whose_place_is_kept_leaves_the_others_where_they_were() -> None:
    init = InitialState(vacant=(Vacancy(origin="green_block", size=0.04, before="blue_block"),))
    for seed in range(20):
        before = sample_start(SCATTERED, World(FIVE), seed)
        after = sample_start(init, World([FIVE[0], *FIVE[2:]]), seed)
        assert all(after.position[name] == before.position[name] for name in after.position)


def test_a_renamed_block_starts_where_it_did_under_its_first_name() -> None:
    letter = SemanticCube(name="A_block", label="A", origin="red_block")
    before, after = sample_start(SCATTERED, World(FIVE), 5), sample_start(SCATTERED, World([letter, *FIVE[1:]]), 5)
    assert after.position["A_block"] == before.position["red_block"]


def test_a_pose_is_met_within_its_jitter() -> None:
    init = InitialState(poses=(Start(block="red_block", position=(0.5, 0.1), yaw=0.3, jitter=0.01),))
    places = {sample_start(init, World(FIVE), seed).position["red_block"] for seed in range(10)}
    assert len(places) == 10
    assert all(abs(x - 0.5) <= 0.01 and abs(y - 0.1) <= 0.01 for x, y, _ in places)


@pytest.mark.parametrize("seed", range(3))
def test_arranged_starts_hold_and_stand_by_themselves(seed: int) -> None:
    order = Order(by="given", ranks=("red_block", "green_block", "blue_block"))
    goals = (
        Stack(blocks=("red_block", "green_block", "blue_block"), order=order),
        InRegion(a="yellow_block", region="left_half"),
    )
    state = sample_start(InitialState(arranged=goals), World([*FIVE, PATCH]), seed)
    assert all(evaluate(goal, state) for goal in goals)
    assert settled(state)
    assert in_workspace(state)
    assert all(footprint_gap(state, name, "patch") > 0 for name in state.position)


@pytest.mark.parametrize("count", [2, 3, 12])
def test_heaps_of_any_size_are_found(count: int) -> None:
    world = World([ColoredCube(name=f"b{k}", color="red") for k in range(count)])
    for seed in range(2):
        state = sample_start(InitialState(heaps=(tuple(world.blocks),)), world, seed)
        assert settled(state) and in_workspace(state)


@pytest.mark.parametrize("seed", range(3))
def test_a_heap_has_settled_in_one_piece_with_blocks_on_blocks(seed: int) -> None:
    heap = ("red_block", "green_block", "blue_block", "yellow_block")
    state = sample_start(InitialState(heaps=(heap,)), World([*FIVE, PATCH]), seed)
    assert settled(state)
    assert in_workspace(state)
    assert any(state.bottom(name) > TABLE_Z + 0.01 for name in heap)
    assert state.bottom("pink_block") == pytest.approx(TABLE_Z, abs=1e-4)
    assert state.position == sample_start(InitialState(heaps=(heap,)), World([*FIVE, PATCH]), seed).position


TOWER = Stack(blocks=tuple(asset.name for asset in FIVE[:3]))


@pytest.mark.parametrize("init", [SCATTERED, InitialState(arranged=(TOWER.model_copy(update={"span": (3, 9)}),))])
def test_what_is_foreseen_is_what_is_drawn_and_is_taken_once(init: InitialState) -> None:
    world, same = World(FIVE), World(FIVE)
    told = InitialState(arranged=(TOWER,)) if init.arranged else init
    for attempt, start in enumerate(islice(foresee(init, world), 3)):
        drawn = sample_start(told, same, 0, attempt)
        assert (drawn.position, drawn.orientation) == (start.position, start.orientation)
    assert foreseen(told, World(FIVE[1:]), 0, 1) is None and foreseen(told, same, 1, 1) is None
    taken = foreseen(told, same, 0, 1)
    assert taken is not None and taken.world is same and taken.position == sample_start(told, same, 0, 1).position
    assert foreseen(told, same, 0, 1) is None and foreseen(told, same, 0, 3) is None


def test_data_that_is_left_has_one_taker() -> None:
    physics, other = Physics(World(FIVE)), Physics(World(FIVE[:1]))
    leave(physics)
    assert left(other.model) is None
    leave(physics)
    assert left(physics.model) is physics.data
    assert left(physics.model) is None
