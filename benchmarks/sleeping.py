"""What sleeping bodies give the gate of the goal state, and whether any verdict depends on them.

`python benchmarks/sleeping.py [SCENES] [TOWERS]` lets marginal scenes (2,100 unless told) stand for as long as that
gate does, awake and with sleep allowed, and compares what it would say; finds for so many towers (20) the overhang at
which they begin to fall, with sleep and without; and times scenes at rest.
"""

from __future__ import annotations

import math
import os
import statistics
import sys
import time
from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import islice
from random import Random

os.environ.setdefault("MUJOCO_GL", "disable")

from rpg.blocks.constants import TABLE_SIZE, TABLE_X, TABLE_Z
from rpg.blocks.physics import SLEEPS_BELOW, Physics
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
TOLERANCES = (1e-3, SLEEPS_BELOW)
"""Speeds (m/s) below which bodies fall asleep: MuJoCo 4's own, and that of the gates."""
FINEST = 1e-7
"""How closely (m) the overhang at which a tower begins to fall is found."""


@dataclass(frozen=True)
class Case:
    """A scene that stands or falls by a hair: centres (m) and yaws (rad) of its cubes, and what kind it is."""

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
    return overhanging(count, broken, yaw, EDGE / 2 + rng.uniform(-NEAR, NEAR))


def overhanging(count: int, broken: int, yaw: float, beyond: float) -> Case:
    """A tower whose blocks from `broken` on stand `beyond` (m) to the side."""
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


def outcome(case: Case, below: float | None) -> tuple[Outcome, bytes]:
    """What becomes of a case with sleep allowed `below` that speed (None: never), and the bits of its last state."""
    physics = Physics(case.state.world)
    if below is not None:
        physics.let_sleep(below)
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
            kept = kept and abs(place[2] - then[2]) < EDGE / 4
        moves = bool(now.moving)
    return Outcome(topples, drifts, moves, kept), physics.data.qpos.tobytes()


def compare(what: str, listed: Sequence[Case]) -> int:
    """Print, for every tolerance, how many of the cases end otherwise than awake; their number."""
    awake = [outcome(case, None) for case in listed]
    standing = sum(found.kept for found, _ in awake)
    print(f"{len(listed)} {what}, of which {standing} keep standing awake", flush=True)
    total = 0
    for tolerance in TOLERANCES:
        asleep = [outcome(case, tolerance) for case in listed]
        triples = list(zip(listed, asleep, awake, strict=True))
        other = Counter(case.kind for case, (now, _), (then, _) in triples if now != then)
        bits = sum(now != then for _, (_, now), (_, then) in triples)
        kinds = ", ".join(f"{number} {kind}" for kind, number in sorted(other.items())) or "none"
        print(f"sleep below {tolerance:g} m/s: other verdicts {other.total()} ({kinds}); other bits {bits}", flush=True)
        total += other.total()
    return total


def brink(count: int, broken: int, yaw: float, below: float | None) -> float:
    """The overhang (m) from which on a tower falls, by bisection."""
    stands, falls = EDGE / 2 - 2 * NEAR, EDGE / 2 + NEAR
    while falls - stands > FINEST:
        middle = (stands + falls) / 2
        kept = outcome(overhanging(count, broken, yaw, middle), below)[0].kept
        stands, falls = (middle, falls) if kept else (stands, middle)
    return stands


def brinks(count: int) -> None:
    """Print by how much sleep moves the overhang at which towers begin to fall."""
    rng = Random(1)
    moved: dict[float, list[float]] = {tolerance: [] for tolerance in TOLERANCES}
    for _ in range(count):
        size = rng.randint(2, 5)
        broken, yaw = rng.randrange(1, size), rng.choice((0.0, rng.uniform(0.0, math.pi / 4)))
        awake = brink(size, broken, yaw, None)
        for tolerance, found in moved.items():
            found.append(abs(brink(size, broken, yaw, tolerance) - awake))
    for tolerance, found in moved.items():
        print(
            f"sleep below {tolerance:g} m/s moves the brink of {count} towers by {1e6 * statistics.median(found):.1f} "
            f"micrometres in the median, {1e6 * max(found):.1f} at most",
            flush=True,
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
        for below in (None, SLEEPS_BELOW):
            physics = Physics(state.world)
            if below is not None:
                physics.let_sleep(below)
            best = math.inf
            for _ in range(5):
                physics.write(state)
                begun = time.perf_counter()
                physics.step(STEPS)
                best = min(best, time.perf_counter() - begun)
            times.append(1000 * best)
        awake, asleep = times
        print(f"{count:2} blocks at rest, {STEPS} control steps: {awake:7.2f} ms awake, {asleep:6.2f} ms asleep")


def main(scenes: int, towers: int) -> int:
    """Everything; the exit status says whether any verdict depends on sleep."""
    gain()
    other = compare("marginal scenes", list(islice(cases(0), scenes)))
    brinks(towers)
    return int(other > 0)


if __name__ == "__main__":
    given = [int(argument) for argument in sys.argv[1:]]
    sys.exit(main(given[0] if given else 2100, given[1] if len(given) > 1 else 20))
