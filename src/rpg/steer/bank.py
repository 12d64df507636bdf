"""A bank of states on which two goals are compared: arranged goals of both, their near-misses, starts, random layouts.

States are held by key (see `identity`), so that each version can see them with its own names and its own blocks.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from itertools import combinations
from random import Random

from rpg.blocks.arrange import arrange
from rpg.blocks.constants import TABLE_Z, WORKSPACE_X, WORKSPACE_Y
from rpg.blocks.initial import sample_start
from rpg.blocks.near_miss import near_misses
from rpg.blocks.state import IDENTITY, BlockState, Quat, Vec3, World, yaw_quat
from rpg.core.diagnostics import Refusal
from rpg.ir.assets import Block, GoalPatch
from rpg.ir.edits import key
from rpg.ir.schema import TaskSchema
from rpg.steer.identity import Identity

SIZE = 512
"""States in a bank."""
ARRANGED, MISSED, STARTS, SHUFFLES = 5, 2, 32, 6
"""Per version: goal states arranged, those whose near-misses are taken, starts drawn; and per goal state, re-dealings
of its places among its blocks."""

MOST_CHOICES = 64
"""Look-alikes of the other version are tried in place of a version's own up to so many combinations."""

Pose = tuple[Vec3, Quat]


@dataclass(frozen=True)
class Sample:
    """One state of the bank: where every object of either version is, how it began, and where it is from."""

    poses: dict[str, Pose]
    start: dict[str, Pose]
    source: str


class Side:
    """One version as the bank sees it."""

    def __init__(self, schema: TaskSchema, label: str) -> None:
        self.schema = schema
        self.label = label
        self.world = World(schema.assets)
        self.keys = {asset.name: key(asset) for asset in schema.assets if not isinstance(asset, GoalPatch)}

    def state(self, sample: Sample, keys: Mapping[str, str] | None = None) -> BlockState:
        """`sample` as this version has it: its own blocks (those of `keys`), by its own names."""
        keys = self.keys if keys is None else keys
        return self._only(sample.poses, keys, self._only(sample.start, keys, None))

    def _only(self, poses: dict[str, Pose], keys: Mapping[str, str], start: BlockState | None) -> BlockState:
        return BlockState(
            world=self.world,
            position={name: poses[k][0] for name, k in keys.items()},
            orientation={name: poses[k][1] for name, k in keys.items()},
            start=start,
        )

    def choices(self, other: Side) -> tuple[dict[str, str], ...]:
        """Every set of blocks of both versions that this version can take for its own: name -> key, its own first.

        They differ where the other version has more blocks of a look.
        """
        foreign = {k: other.world.look[name] for name, k in other.keys.items() if k not in self.keys.values()}
        found = [dict(self.keys)]
        for look in sorted(set(foreign.values()) & set(self.world.look.values())):
            mine = [name for name in self.keys if self.world.look[name] == look]
            pool = [*(self.keys[name] for name in mine), *(k for k in foreign if foreign[k] == look)]
            found = [
                {**before, **dict(zip(mine, chosen, strict=True))}
                for before in found
                for chosen in combinations(pool, len(mine))
            ]
            if len(found) > MOST_CHOICES:
                return (dict(self.keys),)
        return tuple(found)

    def poses(self, state: BlockState) -> dict[str, Pose]:
        """A state of this version, by key."""
        return {
            k: (state.position[n], state.orientation.get(n, IDENTITY))
            for n, k in self.keys.items()
            if n in state.position
        }


class Bank:
    """The states on which two versions are compared. The same versions give the same bank."""

    def __init__(self, identity: Identity, seed: int = 0) -> None:
        self.old, self.new = Side(identity.old, "old"), Side(identity.new, "new")
        self.sizes = _sizes(identity)
        self.rng = Random(f"bank {seed}")
        self.starts = {side.label: _starts(side, STARTS) for side in (self.old, self.new)}
        self.samples: list[Sample] = []
        self._fill()

    def _fill(self) -> None:
        goals = {side.label: self._goals(side) for side in (self.old, self.new)}
        for side in (self.old, self.new):
            for state in goals[side.label]:
                self._add(side, state, "goal")
            for state in goals[side.label][:MISSED]:
                for miss in near_misses(side.schema.goal, state, self.rng):
                    self._add(side, miss.state, "near-miss")
        for side in (self.old, self.new):
            for state in self.starts[side.label]:
                self._add(side, state, "start")
            for state in goals[side.label]:
                for dealt in self._dealt(state):
                    self._add(side, dealt, "goal re-dealt")
        while len(self.samples) < SIZE:
            self.samples.append(self._random())

    def _goals(self, side: Side) -> list[BlockState]:
        start = self.starts[side.label][0]
        try:
            return arrange(side.schema.goal, side.world, rng=self.rng, start=start, count=ARRANGED)
        except Refusal:
            return []

    def _dealt(self, state: BlockState) -> Iterator[BlockState]:
        """The same places with other blocks in them, dealt among blocks of one size."""
        names = sorted(state.position)
        for _ in range(SHUFFLES):
            other = names[:]
            self.rng.shuffle(other)
            pairs = [(a, b) for a, b in zip(names, other, strict=True) if state.world.edge[a] == state.world.edge[b]]
            if {a for a, _ in pairs} == {b for _, b in pairs}:
                yield state.moved({a: (state.position[b], state.orientation.get(b, IDENTITY)) for a, b in pairs})

    def _add(self, side: Side, state: BlockState, source: str) -> None:
        """Add a state of one version, with the other version's blocks somewhere on the table as well."""
        poses = side.poses(state)
        begun = side.poses(state.start) if state.start is not None else poses
        start = {**self._elsewhere(begun), **begun}
        self.samples.append(Sample({**self._elsewhere(poses), **poses}, start, f"{side.label} {source}"))

    def _elsewhere(self, poses: dict[str, Pose]) -> dict[str, Pose]:
        """Free places flat on the table for every block that `poses` lacks."""
        taken = [(position, self.sizes[k]) for k, (position, _) in poses.items()]
        found: dict[str, Pose] = {}
        for k in self.sizes:
            if k not in poses:
                position = self._free(taken, self.sizes[k])
                taken.append((position, self.sizes[k]))
                found[k] = (position, yaw_quat(self.rng.uniform(-math.pi, math.pi)))
        return found

    def _free(self, taken: list[tuple[Vec3, float]], size: float) -> Vec3:
        spot = (0.0, 0.0)
        for _ in range(60):
            spot = (round(self.rng.uniform(*WORKSPACE_X), 4), round(self.rng.uniform(*WORKSPACE_Y), 4))
            if all(math.dist(spot, other[:2]) > 0.75 * (size + edge) for other, edge in taken):
                break
        return (*spot, TABLE_Z + size / 2)

    def _random(self) -> Sample:
        """Blocks dealt into stacks of random heights at free places, square to the table."""
        names = sorted(self.sizes)
        self.rng.shuffle(names)
        poses: dict[str, Pose] = {}
        taken: list[tuple[Vec3, float]] = []
        while names:
            height = min(len(names), self.rng.choice((1, 1, 1, 2, 2, 3, 4)))
            pile = sorted((names.pop() for _ in range(height)), key=lambda k: -self.sizes[k])
            x, y, z = self._free(taken, self.sizes[pile[0]])
            taken.append(((x, y, z), self.sizes[pile[0]]))
            z = TABLE_Z
            for k in pile:
                poses[k] = ((x, y, round(z + self.sizes[k] / 2, 6)), IDENTITY)
                z += self.sizes[k]
        starts = self.starts["new"]
        begun = self.new.poses(starts[self.rng.randrange(len(starts))])
        return Sample(poses, {**self._elsewhere(begun), **begun}, "random layout")


def _starts(side: Side, count: int) -> list[BlockState]:
    return [sample_start(side.schema.init, side.world, seed) for seed in range(count)]


def _sizes(identity: Identity) -> dict[str, float]:
    """Edge of every block of either version, by key; the new one's where both have it."""
    found: dict[str, float] = {}
    for assets in (identity.before, identity.after):
        found.update({k: asset.size for k, asset in assets.items() if isinstance(asset, Block)})
    return dict(sorted(found.items()))
