"""Whether MuJoCo's sleeping bodies would help the gates: are verdicts the same, and what is gained.

`python benchmarks/sleeping.py [STACKS]` lets marginal stacks (2,100 unless told) stand for as long as the gate of the
goal state does, awake and with sleep allowed, and compares what that gate would say; then it times scenes that rest.
"""

from __future__ import annotations

import math
import os
import sys
import time
from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass
from itertools import islice
from random import Random

os.environ.setdefault("MUJOCO_GL", "disable")

import mujoco

from rpg.blocks.constants import TABLE_SIZE, TABLE_X, TABLE_Z
from rpg.blocks.physics import Physics
from rpg.blocks.scene import build_spec
from rpg.blocks.state import BlockState, Quat, Vec3, World
from rpg.ir.assets import ColoredCube
from rpg.passes.validate import Measures
from rpg.passes.validate.gates.goal_state import NUDGE

EDGE = 0.04
NEAR = 0.003
"""How far (m) from the support's edge a marginal centre of mass is at most."""
CENTER = (0.5, 0.0)
SIZES = (2, 5, 14, 27)
MEASURES = Measures()
STEPS = MEASURES.settle_steps + MEASURES.hold_steps
TOLERANCES = (None, 1e-4, 1e-6)
"""Speeds below which bodies fall asleep; the middle one is MuJoCo's default, None keeps everything awake."""


@dataclass(frozen=True)
class Case:
    """A scene that stands or falls by a hair: the lower corner's poses of every cube, and what kind it is."""

    kind: str
    positions: tuple[Vec3, ...]
    yaws: tuple[float, ...]

    @property
    def state(self) -> BlockState:
        world = world_of(len(self.positions))
        names = list(world.blocks)
        turns = [turn(yaw) for yaw in self.yaws]
        return BlockState(world, dict(zip(names, self.positions, strict=True)), dict(zip(names, turns, strict=True)))


@dataclass(frozen=True)
class Outcome:
    """What the gate of the goal state would find: did it topple, drift, move at the end; did blocks stay on blocks?"""

    topples: bool
    drifts: bool
    moves: bool
    kept: bool


def world_of(count: int) -> World:
    return World(tuple(ColoredCube(name=f"block_{i}", color="red", size=EDGE) for i in range(count)))


def turn(yaw: float) -> Quat:
    return (math.cos(yaw / 2), 0.0, 0.0, math.sin(yaw / 2))


def level(index: int) -> float:
    return TABLE_Z + EDGE * (index + 0.5)


def cases(seed: int) -> Iterator[Case]:
    """Towers that break at some level, bridges that hang on one support, blocks at the table's edge, without end."""
    rng = Random(seed)
    kinds = (tower, tower, corner, bridge, table_edge)
    while True:
        for kind in kinds:
            yield kind(rng)


def tower(rng: Random) -> Case:
    """The part above one level has its centre of mass within NEAR of that level's edge."""
    count = rng.randint(2, 6)
    broken = rng.randrange(1, count)
    yaw = rng.choice((0.0, rng.uniform(0.0, math.pi / 4)))
    beyond = EDGE / 2 + rng.uniform(-NEAR, NEAR)
    x, y = CENTER
    positions = [
        (x + beyond * math.cos(yaw) * (i >= broken), y + beyond * math.sin(yaw) * (i >= broken), level(i))
        for i in range(count)
    ]
    return Case("tower", tuple(positions), (yaw,) * count)


def corner(rng: Random) -> Case:
    """The upper block's centre is within NEAR of the lower one's corner, and it is turned as it likes."""
    beyond = [EDGE / 2 + rng.uniform(-NEAR, NEAR) for _ in range(2)]
    x, y = CENTER
    positions = ((x, y, level(0)), (x + beyond[0], y + beyond[1], level(1)))
    return Case("corner", positions, (0.0, rng.uniform(0.0, math.pi / 2)))


def bridge(rng: Random) -> Case:
    """A block on two, its centre within NEAR of the edge of one, which the other hardly reaches, with one above."""
    x, y = CENTER
    near = x - EDGE / 2 + rng.uniform(-NEAR, NEAR)
    far = x + EDGE + rng.uniform(-NEAR, NEAR)
    positions = [(near, y, level(0)), (far, y, level(0)), (x, y, level(1))]
    if rng.random() < 0.5:
        positions.append((x + rng.uniform(-NEAR, NEAR), y, level(2)))
    return Case("bridge", tuple(positions), (0.0,) * len(positions))


def table_edge(rng: Random) -> Case:
    """A tower whose blocks have their centres within NEAR of the table's edge."""
    beyond = TABLE_X + TABLE_SIZE[0] / 2 + rng.uniform(-NEAR, NEAR)
    count = rng.randint(1, 3)
    positions = tuple((beyond, 0.0, level(i)) for i in range(count))
    return Case("table edge", positions, (rng.uniform(0.0, math.pi / 2),) * count)


def model_of(world: World, tolerance: float | None) -> mujoco.MjModel:
    spec = build_spec(world.assets.values())
    if tolerance is not None:
        spec.option.enableflags |= int(mujoco.mjtEnableBit.mjENBL_SLEEP)
        spec.option.sleep_tolerance = tolerance
    return spec.compile()


def outcome(case: Case, model: mujoco.MjModel) -> tuple[Outcome, bytes]:
    """What becomes of a case, and the bits of its last state."""
    physics = Physics(case.state.world, model)
    physics.write(case.state)
    for index in range(physics.count):
        physics.data.qvel[6 * index + 3 : 6 * index + 5] = (NUDGE, NUDGE if index % 2 else -NUDGE)
    topples = drifts = moves = False
    kept = True
    for step in range(1, STEPS + 1):
        physics.step()
        if step < MEASURES.settle_steps:
            continue
        now = physics.read()
        for place, then in zip(now.position.values(), case.positions, strict=True):
            drifts = drifts or math.dist(place, then) > MEASURES.drift_m
            topples = topples or abs(place[2] - then[2]) > MEASURES.topple_m
        kept = kept and all(
            abs(place[2] - then[2]) < EDGE / 4
            for place, then in zip(now.position.values(), case.positions, strict=True)
        )
        moves = bool(now.moving)
    return Outcome(topples, drifts, moves, kept), physics.data.qpos.tobytes()


def compare(count: int) -> None:
    """Print, for every tolerance, how many of the cases end otherwise than awake."""
    listed = list(islice(cases(0), count))
    models = {(n, t): model_of(world_of(n), t) for n in range(1, 7) for t in TOLERANCES}
    found = [{t: outcome(case, models[len(case.positions), t]) for t in TOLERANCES} for case in listed]
    standing = sum(each[None][0].kept for each in found)
    print(f"{count} marginal scenes, of which {standing} keep standing awake")
    for tolerance in TOLERANCES[1:]:
        other = Counter(
            case.kind for case, each in zip(listed, found, strict=True) if each[tolerance][0] != each[None][0]
        )
        bits = sum(each[tolerance][1] != each[None][1] for each in found)
        kinds = ", ".join(f"{number} {kind}" for kind, number in sorted(other.items())) or "none"
        print(
            f"sleep below {tolerance:g}: other verdicts {sum(other.values())} ({kinds}); other bits {bits}", flush=True
        )


def resting(count: int) -> BlockState:
    """Columns of up to three blocks, side by side."""
    world = world_of(count)
    places = [(0.4 + 0.06 * (i // 9), -0.06 + 0.06 * (i // 3 % 3), level(i % 3)) for i in range(count)]
    names = list(world.blocks)
    return BlockState(world, dict(zip(names, places, strict=True)), dict.fromkeys(names, turn(0.0)))


def gain() -> None:
    """Print the time that scenes at rest take for the steps of the gate."""
    for count in SIZES:
        state, times = resting(count), []
        for tolerance in TOLERANCES[:2]:
            physics = Physics(state.world, model_of(state.world, tolerance))
            best = math.inf
            for _ in range(5):
                physics.write(state)
                begun = time.perf_counter()
                physics.step(STEPS)
                best = min(best, time.perf_counter() - begun)
            times.append(1000 * best)
        awake, asleep = times
        print(f"{count:2} blocks at rest, {STEPS} control steps: {awake:7.2f} ms awake, {asleep:6.2f} ms asleep")


if __name__ == "__main__":
    gain()
    compare(int(sys.argv[1]) if len(sys.argv) > 1 else 2100)
