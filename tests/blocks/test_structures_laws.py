"""Laws of structures: what turning, mirroring, moving and renaming must not change, over random states."""

from __future__ import annotations

import itertools
import math
from random import Random

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from rpg.blocks.geometry import clear_of, footprint, footprint_gap, polygon_gap
from rpg.blocks.predicates import PREDICATES
from rpg.blocks.state import BlockState, World, yaw_quat
from rpg.blocks.verdict import Verdict
from rpg.ir.assets import ColoredCube
from rpg.ir.node import Node
from rpg.ir.order import Order, Pattern
from rpg.ir.structures import Figure, Grid, GroupBy, Pyramid, Row, Staircase, Towers
from tests.blocks.structure_states import cubes, placed, world

COLORS = ("red", "red", "red", "blue", "blue", "blue", "green", "green", "green")


def named(count: int) -> tuple[str, ...]:
    return tuple(f"b{k}" for k in range(count))


def colored(count: int) -> World:
    return World([ColoredCube(name=name, color=COLORS[k]) for k, name in enumerate(named(count))])  # type: ignore[arg-type]


UNDIRECTED: list[Node] = [
    Row(blocks=named(4)),
    Row(blocks=named(5), evenly=True, order=Order(by="mirrored")),
    Row(blocks=named(6), order=Order(by="rainbow")),
    Figure(blocks=named(8), shape="circle"),
    Figure(blocks=named(8), shape="square"),
    Figure(blocks=named(4), shape="L"),
    Figure(blocks=named(5), shape="V"),
    Figure(blocks=named(6), shape="triangle"),
    Grid(blocks=named(9), rows=3, columns=3),
    Grid(blocks=named(6), rows=1, columns=3, layers=2),
    Pyramid(blocks=named(5), base=(2, 2)),
    Staircase(blocks=named(6), steps=3),
    GroupBy(groups=(named(6)[:3], named(6)[3:]), by="color"),
    GroupBy(groups=(named(6)[:3], named(6)[3:]), by="color", outliers=1),
    Towers(blocks=named(6), count=2),
]


def judged(node: Node, state: BlockState) -> Verdict:
    return PREDICATES[node.kind].evaluate(node, state)  # type: ignore[attr-defined, no-any-return]


def somewhere(node: Node, rng: Random) -> BlockState:
    """A built state, or one near it, or nothing like it."""
    count = sum(len(g) for g in node.groups) if isinstance(node, GroupBy) else len(node.blocks)  # type: ignore[attr-defined]
    objects = colored(count)
    ways = list(PREDICATES[node.kind].build(node, objects, rng))  # type: ignore[attr-defined]
    made = placed(rng.choice(ways), objects)
    noise = rng.choice([0.0, 0.004, 0.012, 0.03, 0.1])
    position = {
        name: (x + rng.uniform(-noise, noise), y + rng.uniform(-noise, noise), z)
        for name, (x, y, z) in made.position.items()
    }
    return BlockState(objects, position, {name: yaw_quat(rng.uniform(0.0, 6.3)) for name in position})


def transformed(state: BlockState, turn: float, mirror: bool) -> BlockState:
    """The whole turned about some point, and mirrored left to right."""
    c, s = math.cos(turn), math.sin(turn)
    position, orientation = {}, {}
    for name, (x, y, z) in state.position.items():
        w, _, _, k = state.orientation[name]
        yaw = 2.0 * math.atan2(k, w)
        if mirror:
            y, yaw = -y, -yaw
        position[name] = (0.3 + c * x - s * y, 0.1 + s * x + c * y, z)
        orientation[name] = yaw_quat(yaw + turn)
    return BlockState(state.world, position, orientation)


def same(one: Verdict, two: Verdict) -> bool:
    """Equal, or so near the edge of a tolerance that rounding decides."""
    return one.value == two.value or min(abs(one.margin), abs(two.margin)) < 1e-6


@pytest.mark.parametrize("node", UNDIRECTED, ids=lambda n: f"{n.kind}-{getattr(n, 'shape', '')}")
@settings(max_examples=25, deadline=None, derandomize=True)
@given(seed=st.integers(0, 10**6), turn=st.floats(0.0, 6.28), mirror=st.booleans())
def test_undirected_structures_hold_in_any_rotation_and_mirrored(
    node: Node, seed: int, turn: float, mirror: bool
) -> None:
    state = somewhere(node, Random(seed))
    before, after = judged(node, state), judged(node, transformed(state, turn, mirror))
    assert same(before, after), (before, after)
    assert before.margin >= 0.0 if before.value else before.margin <= 0.0


@pytest.mark.parametrize("node", UNDIRECTED, ids=lambda n: f"{n.kind}-{getattr(n, 'shape', '')}")
@settings(max_examples=15, deadline=None, derandomize=True)
@given(seed=st.integers(0, 10**6))
def test_look_alikes_and_the_order_of_names_do_not_matter(node: Node, seed: int) -> None:
    rng = Random(seed)
    state = somewhere(node, rng)
    names = list(state.position)
    reds = [n for n in names if state.world.blocks[n].color == "red"]
    if not isinstance(node, GroupBy):
        first, second = reds[0], reds[-1]
        exchanged = {first: second, second: first}
        renamed = BlockState(
            state.world,
            {exchanged.get(n, n): p for n, p in state.position.items()},
            {exchanged.get(n, n): q for n, q in state.orientation.items()},
        )
        assert same(judged(node, state), judged(node, renamed))
        shuffled = list(node.blocks)  # type: ignore[attr-defined]
        rng.shuffle(shuffled)
        assert same(judged(node, state), judged(node.model_copy(update={"blocks": tuple(shuffled)}), state))
    rng.shuffle(names)
    reordered = BlockState(state.world, {n: state.position[n] for n in names}, {n: state.orientation[n] for n in names})
    assert same(judged(node, state), judged(node, reordered))


DIRECTED: list[Node] = [
    Row(blocks=named(4), axis="y"),
    Row(blocks=named(6), order=Order(by="rainbow", first="left")),
    Figure(blocks=named(4), shape="L", pointing="right"),
    Figure(blocks=named(6), shape="triangle", pointing="back"),
    Grid(blocks=named(6), rows=2, columns=3),
    Grid(blocks=named(9), rows=3, columns=3, pattern=Pattern(kind="row")),
    Staircase(blocks=named(6), steps=3, up="left"),
]


@pytest.mark.parametrize("node", DIRECTED, ids=lambda n: f"{n.kind}-{getattr(n, 'shape', '')}")
@settings(max_examples=15, deadline=None, derandomize=True)
@given(seed=st.integers(0, 10**6), slant=st.floats(-0.2, 0.2))
def test_directed_structures_hold_in_their_direction_only(node: Node, seed: int, slant: float) -> None:
    objects = colored(len(node.blocks))  # type: ignore[attr-defined]
    ways = list(PREDICATES[node.kind].build(node, objects, Random(seed)))  # type: ignore[attr-defined]
    state = placed(ways[seed % len(ways)], objects)
    assert judged(node, transformed(state, slant, False)).value
    assert not judged(node, transformed(state, math.pi / 2 + slant, False)).value


@settings(max_examples=200, deadline=None, derandomize=True)
@given(seed=st.integers(0, 10**6))
def test_gaps_between_turned_squares(seed: int) -> None:
    """The short way for level blocks agrees with the way for any two polygons."""
    rng = Random(seed)
    objects = World([ColoredCube(name="a", color="red"), ColoredCube(name="b", color="red", size=0.06)])
    spots = {n: (rng.uniform(-0.1, 0.1), rng.uniform(-0.1, 0.1), 1.0) for n in ("a", "b")}
    turns = {n: yaw_quat(rng.choice([0.0, math.pi / 2, rng.uniform(0.0, 7.0)])) for n in ("a", "b")}
    state = BlockState(objects, spots, turns)
    expected = polygon_gap(footprint(state, "a"), footprint(state, "b"))
    assert footprint_gap(state, "a", "b") == pytest.approx(expected, abs=1e-9)
    assert clear_of(footprint(state, "a"), footprint(state, "b"), 0.01) == (expected >= 0.01)


def test_margins_fall_as_a_block_leaves_its_place() -> None:
    """The margin of a row and of a grid falls as one block leaves it, through zero where truth turns."""
    for node, count in ((Row(blocks=named(3)), 3), (Grid(blocks=named(9), rows=3, columns=3), 9)):
        objects = world(cubes(count))
        built = placed(next(iter(PREDICATES[node.kind].build(node, objects, Random(0)))), objects)
        verdicts = []
        for step in range(0, 45):
            x, y, z = built.position["b1"]
            out = BlockState(objects, {**built.position, "b1": (x + 0.001 * step, y, z)}, built.orientation)
            verdicts.append(judged(node, out))
        margins = [v.margin for v in verdicts]
        assert all(a >= b - 1e-9 for a, b in itertools.pairwise(margins))
        assert verdicts[0].value and not verdicts[-1].value
        turning = next(k for k, v in enumerate(verdicts) if not v.value)
        assert margins[turning - 1] < 0.12 and margins[turning] > -0.12
