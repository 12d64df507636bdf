"""What is ruled out at a glance is what a full evaluation rules out, on every state."""

from __future__ import annotations

from random import Random

import pytest

from rpg.blocks.arrange import arrange
from rpg.blocks.centres import Centres, places_of
from rpg.blocks.constants import TABLE_Z
from rpg.blocks.near_miss import near_misses
from rpg.blocks.predicates import PREDICATES
from rpg.blocks.predicates.plainly import layers, off, uneven
from rpg.blocks.state import BlockState, Quat, Vec3, World
from rpg.ir import goal as g
from rpg.ir.assets import ColoredCube, GoalPatch, SemanticCube

NAMES = tuple(f"block_{k}" for k in range(6))
GOALS: tuple[g.Atom, ...] = (
    g.On(a=NAMES[:1], b=NAMES[1:2]),
    g.On(a=NAMES[:2], b=NAMES[2:5]),
    g.On(a=NAMES[:1], b=NAMES[1:2], gap=0.05, offset_edges=1.5, tilt=90.0),
    g.Stack(blocks=NAMES[:3]),
    g.Stack(blocks=NAMES[:2], exact=True),
    g.Row(blocks=NAMES[:4]),
    g.Row(blocks=NAMES[:2], axis="y"),
    g.Grid(blocks=NAMES, rows=2, columns=3),
    g.Grid(blocks=NAMES, rows=1, columns=3, layers=2),
    g.Pyramid(blocks=NAMES, base=(3, 1)),
    g.Pyramid(blocks=NAMES[:5], base=(2, 2)),
    g.Staircase(blocks=NAMES, steps=3),
    g.Figure(blocks=NAMES, shape="triangle"),
    g.Towers(blocks=NAMES),
    g.Towers(blocks=NAMES, count=2, equal=True),
    g.Towers(blocks=NAMES, heights=(4, 2)),
    g.GroupBy(groups=(NAMES[:3], NAMES[3:5], NAMES[5:])),
    g.LeftOf(a=NAMES[:1], b=NAMES[1:2]),
    g.Behind(a=NAMES[:2], b=NAMES[2:4], somewhere=True),
    g.InFrontOf(a=NAMES[:1], b=NAMES[1:2], directly=True),
    g.OnPatch(a=NAMES[:2], patch="square"),
    g.OnPatch(a=NAMES[:1], patch="circle"),
)
PATCHES = (
    GoalPatch(name="square", color="blue", size=(0.2, 0.1), position=(0.5, 0.1)),
    GoalPatch(name="circle", color="red", shape="circle", size=(0.12, 0.12), position=(0.6, -0.1)),
)
SIZES = {"one": (0.04,) * 6, "small": (0.02,) * 6, "mixed": (0.04, 0.04, 0.05, 0.03, 0.04, 0.06)}


def world(sizes: tuple[float, ...]) -> World:
    blocks = (ColoredCube(name=n, color="red", size=size) for n, size in zip(NAMES, sizes, strict=True))
    return World((*blocks, *PATCHES))


def anywhere(there: World, rng: Random) -> BlockState:
    """Blocks in stacks that are not quite straight, some of them tilted a little or much."""
    position: dict[str, Vec3] = {}
    orientation: dict[str, Quat] = {}
    names = list(NAMES)
    rng.shuffle(names)
    while names:
        x, y, z = rng.uniform(0.45, 0.65), rng.uniform(-0.2, 0.2), TABLE_Z
        for name in [names.pop() for _ in range(min(len(names), rng.choice((1, 2, 3, 6))))]:
            tip = rng.choice((0.0, 0.0, 0.1, 0.13, 0.3, 0.8)) * rng.uniform(0.9, 1.1)
            edge = there.edge[name]
            orientation[name] = (1.0 - tip**2 / 2, tip, 0.0, 0.0) if tip else (1.0, 0.0, 0.0, 0.0)
            length = sum(part**2 for part in orientation[name]) ** 0.5
            orientation[name] = tuple(part / length for part in orientation[name])  # type: ignore[assignment]
            position[name] = (x, y, z + edge / 2 + rng.choice((0.0, 0.0, 0.004, 0.0099, 0.02)))
            x, y, z = x + rng.gauss(0.0, 0.01), y + rng.gauss(0.0, 0.01), z + edge
    return BlockState(there, position, orientation)


@pytest.mark.parametrize("sizes", SIZES)
@pytest.mark.parametrize("goal", GOALS, ids=lambda goal: goal.kind)
def test_a_glance_is_never_wrong(goal: g.Atom, sizes: str) -> None:
    there, rng, predicate = world(SIZES[sizes]), Random(7), PREDICATES[goal.kind]
    states = [anywhere(there, rng) for _ in range(400)]
    if sizes == "one":
        for state in arrange(goal, there, rng=rng, count=3):
            states += [state, *(miss.state for miss in near_misses(goal, state, rng))]
    assert sum(predicate.holds(goal, state) for state in states) >= (sizes == "one")
    places = places_of(NAMES, [state.position for state in states])
    perhaps = predicate.perhaps(goal, Centres(there, places, {name: k for k, name in enumerate(NAMES)}))
    for state, maybe in zip(states, perhaps, strict=True):
        assert predicate.holds(goal, state) == predicate.evaluate(goal, state).value
        assert maybe or not predicate.holds(goal, state)
    assert sum(perhaps) < 0.8 * len(states)


@pytest.mark.parametrize(
    "goal",
    [g.Spells(word="ABC", blocks=("a", "b", "c")), g.Spells(word="CAB", blocks=("a", "b", "c"), along="stack")],
    ids=lambda goal: goal.along,
)
def test_texts_are_found_among_many_states(goal: g.Spells) -> None:
    there = World(SemanticCube(name=name, color="ivory", label=name.upper()) for name in "abc")
    rng = Random(9)
    states = arrange(goal, there, rng=rng, count=4)
    states += [miss.state for state in states for miss in near_misses(goal, state, rng)]
    places = places_of("abc", [state.position for state in states])
    perhaps = PREDICATES["spells"].perhaps(goal, Centres(there, places, {name: k for k, name in enumerate("abc")}))
    held = [PREDICATES["spells"].holds(goal, state) for state in states]
    assert 4 <= sum(held) <= sum(perhaps) < len(states)
    assert all(maybe or not value for maybe, value in zip(perhaps, held, strict=True))


def test_most_states_are_ruled_out() -> None:
    there, rng = world(SIZES["one"]), Random(8)
    states = [anywhere(there, rng) for _ in range(300)]
    assert sum(uneven(state, NAMES) for state in states) > 250
    assert sum(off(state, NAMES[0], NAMES[1], 0.022, 0.01) for state in states) > 200
    assert sum(layers(state, NAMES) not in ([3, 3], None) for state in states) > 250


@pytest.mark.parametrize("sizes", SIZES)
@pytest.mark.parametrize(
    "goal",
    [
        g.Touching(a=NAMES[:1], b=NAMES[1:2]),
        g.Touching(a=NAMES[:2], b=NAMES[2:4], gap=0.02),
        g.On(a=NAMES[:1], b=NAMES[1:2]),
        g.On(a=NAMES[:2], b=NAMES[2:5], gap=0.05, offset_edges=1.5, tilt=90.0),
    ],
    ids=lambda goal: goal.kind,
)
def test_what_plainly_fails_does_so_by_all_of_its_tolerance(goal: g.Atom, sizes: str) -> None:
    there, rng, predicate = world(SIZES[sizes]), Random(6), PREDICATES[goal.kind]
    states = [anywhere(there, rng) for _ in range(300)]
    plain = [predicate.evaluate(goal, state) for state in states if predicate.plainly_not(goal, state)]
    assert len(plain) > 20
    assert all(not verdict and verdict.margin <= -1.0 for verdict in plain)
