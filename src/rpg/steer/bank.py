"""A bank of states on which two goals are compared: arranged goals of both, their near-misses, starts, random layouts.

States are held by key (see `identity`), so that each version can see them with its own names and its own blocks.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from itertools import combinations
from random import Random

from rpg.blocks.arrange import CHANGES, arrange
from rpg.blocks.constants import TABLE_Z, WORKSPACE_X, WORKSPACE_Y
from rpg.blocks.initial import sample_start
from rpg.blocks.near_miss import near_misses
from rpg.blocks.state import IDENTITY, BlockState, Quat, Vec3, World, yaw_quat
from rpg.core.diagnostics import Refusal
from rpg.ir import goal as g
from rpg.ir.assets import Block, GoalPatch
from rpg.ir.edits import key
from rpg.ir.order import Order
from rpg.ir.schema import TaskSchema
from rpg.ir.walk import atoms, rename, transform
from rpg.steer.identity import Identity

SIZE = 512
"""States in a bank."""
ARRANGED, MISSED, STARTS, SHUFFLES = 4, 1, 16, 6
"""Per version: goal states arranged, those whose near-misses are taken, starts drawn; and per goal state, re-dealings
of its places among its blocks."""

MOST_CHOICES = 64
"""Look-alikes of the other version are tried in place of a version's own up to so many combinations."""

READERS = frozenset({"equation", "facing", "group_by", "spells", "towers"})
"""Conditions on colours or symbols."""

Pose = tuple[Vec3, Quat]


@dataclass(frozen=True)
class Sample:
    """One state of the bank: where every object of either version is, how it began, and where it is from.

    `known`: what one of the versions is known to say of it by construction.
    """

    poses: dict[str, Pose]
    start: dict[str, Pose]
    source: str
    known: dict[str, bool] = field(default_factory=dict)


class Side:
    """One version as the bank sees it."""

    def __init__(self, schema: TaskSchema, label: str) -> None:
        self.schema = schema
        self.label = label
        self.world = World(schema.assets)
        self.keys = {asset.name: key(asset) for asset in schema.assets if not isinstance(asset, GoalPatch)}
        self.looks_back = any(atom.kind in CHANGES for atom in atoms(schema.goal))

    def state(self, sample: Sample, keys: Mapping[str, str] | None = None) -> BlockState:
        """`sample` as this version has it: its own blocks (those of `keys`), by its own names."""
        keys = self.keys if keys is None else keys
        start = self._only(sample.start, keys, None) if self.looks_back else None
        return self._only(sample.poses, keys, start)

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


def _seen(side: Side) -> tuple[object, ...]:
    """All that the verdicts of a version depend on, by key."""
    world, keys = side.world, side.keys
    looks: dict[str, object] = {k: world.look[name] for name, k in keys.items()}
    if not any(_reads_looks(atom) for atom in atoms(side.schema.goal)):
        groups: dict[object, set[str]] = {}
        for k, look in looks.items():
            groups.setdefault(look, set()).add(k)
        looks = {k: groups[look] for k, look in looks.items()}
    goal = rename(transform(side.schema.goal, _without_span), keys)
    return goal, looks, {k: world.edge[name] for name, k in keys.items()}, world.patches


def _reads_looks(atom: g.Atom) -> bool:
    """May a verdict of `atom` depend on more of the looks of blocks than which of them look alike?"""
    order: Order | None = getattr(atom, "order", None)
    ordered = order is not None and order.by not in ("any", "given")
    return atom.kind in READERS or ordered or any(getattr(atom, asked, None) for asked in ("pattern", "readable"))


def _without_span(node: g.Goal) -> g.Goal:
    return node if node.span is None else node.model_copy(update={"span": None})


class Bank:
    """The states on which two versions are compared. The same versions give the same bank.

    `same`: both goals are one expression over one world, but for names and for looks that it does not ask about. They
    say the same of every state then: what is arranged for one of them is arranged for both.
    """

    def __init__(self, identity: Identity, seed: int = 0) -> None:
        self.old, self.new = Side(identity.old, "old"), Side(identity.new, "new")
        self.same = not self.old.looks_back and _seen(self.old) == _seen(self.new)
        self.sizes = _sizes(identity)
        self.rng = Random(f"bank {seed}")
        self.slots = _slots(1.5 * max(self.sizes.values()))
        self.starts = {side.label: _starts(side, STARTS) for side in (self.old, self.new)}
        self.begun = {label: [self._complete(side, s) for s in self.starts[label]] for label, side in self._sides()}
        self.samples: list[Sample] = []
        self._fill()

    def _sides(self) -> tuple[tuple[str, Side], ...]:
        return ("old", self.old), ("new", self.new)

    def _arranged(self) -> tuple[tuple[str, Side], ...]:
        """The sides for which goals are arranged."""
        return self._sides()[self.same :]

    def _fill(self) -> None:
        goals = {label: self._goals(side) for label, side in self._arranged()}
        for label, side in self._arranged():
            for state in goals[label]:
                self._add(side, state, "goal", True)
            for state in goals[label][:MISSED]:
                for miss in near_misses(side.schema.goal, state, self.rng):
                    self._add(side, miss.state, "near-miss", False)
        for label, side in self._sides():
            for start in self.begun[label]:
                self.samples.append(Sample(start, start, f"{label} start"))
            for state in goals.get(label, ()):
                for dealt in self._dealt(state):
                    self._add(side, dealt, "goal re-dealt", None)
        while len(self.samples) < SIZE:
            self.samples.append(self._random(tight=len(self.samples) % 2 == 0))

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

    def _add(self, side: Side, state: BlockState, source: str, holds: bool | None) -> None:
        """Add a state of one version, with the other version's blocks somewhere on the table as well."""
        known = {} if holds is None else {side.label: holds}
        start = self.begun[side.label][0]
        self.samples.append(Sample(self._complete(side, state), start, f"{side.label} {source}", known))

    def _complete(self, side: Side, state: BlockState) -> dict[str, Pose]:
        """A state of one version, with every block that it lacks at a free place flat on the table."""
        poses = side.poses(state)
        missing = [k for k in self.sizes if k not in poses]
        if not missing:
            return poses
        taken = [(x, y) for (x, y, _), _ in poses.values()]
        reach = (1.5 * max(self.sizes.values())) ** 2
        enough = min(len(self.slots), 3 * len(missing) + 4 * len(taken))
        for x, y in self.rng.sample(self.slots, enough):
            if not missing:
                break
            if all((x - a) ** 2 + (y - b) ** 2 > reach for a, b in taken):
                k = missing.pop()
                poses[k] = ((x, y, TABLE_Z + self.sizes[k] / 2), yaw_quat(self.rng.uniform(-math.pi, math.pi)))
        for index, k in enumerate(missing):
            poses[k] = (self._aside(index, k), IDENTITY)
        return poses

    def _aside(self, index: int, k: str) -> Vec3:
        """A place beyond the others, for blocks that find no room among them."""
        return (WORKSPACE_X[1] + 0.2 * (index + 1), 0.0, TABLE_Z + self.sizes[k] / 2)

    def _random(self, tight: bool) -> Sample:
        """Blocks dealt into stacks of random heights, square to the table: close together, or at free places."""
        names = sorted(self.sizes)
        self.rng.shuffle(names)
        poses: dict[str, Pose] = {}
        for x, y in self._near(len(names)) if tight else self.rng.sample(self.slots, min(len(names), len(self.slots))):
            if not names:
                break
            height = min(len(names), self.rng.choice((1, 1, 1, 2, 2, 3, 4)))
            z = TABLE_Z
            for k in sorted((names.pop() for _ in range(height)), key=lambda k: -self.sizes[k]):
                poses[k] = ((x, y, round(z + self.sizes[k] / 2, 6)), IDENTITY)
                z += self.sizes[k]
        for index, k in enumerate(names):
            poses[k] = (self._aside(index, k), IDENTITY)
        begun = self.begun["new"]
        return Sample(poses, begun[self.rng.randrange(len(begun))], "random layout")

    def _near(self, count: int) -> Iterator[tuple[float, float]]:
        """Places in a few rows around a point, in a random order of rows, at one pitch."""
        pitch = max(self.sizes.values()) * self.rng.choice((1.02, 1.2, 1.6, 2.2))
        columns = self.rng.randint(1, max(1, min(6, count)))
        x, y = self.rng.uniform(0.45, 0.6), self.rng.uniform(-0.1, 0.15)
        rows = -(-count // columns)
        for place in range(rows * columns):
            i, j = divmod(place, columns)
            yield round(x + i * pitch, 4), round(y - j * pitch, 4)


def _slots(pitch: float) -> list[tuple[float, float]]:
    """Places on the table that are clear of each other, some of them beside the workspace."""
    return [
        (round(WORKSPACE_X[0] + i * pitch, 4), round(1.6 * WORKSPACE_Y[0] + j * pitch, 4))
        for i in range(math.floor((WORKSPACE_X[1] - WORKSPACE_X[0]) / pitch) + 1)
        for j in range(math.floor(1.6 * (WORKSPACE_Y[1] - WORKSPACE_Y[0]) / pitch) + 1)
    ]


def _starts(side: Side, count: int) -> list[BlockState]:
    return [sample_start(side.schema.init, side.world, seed) for seed in range(count)]


def _sizes(identity: Identity) -> dict[str, float]:
    """Edge of every block of either version, by key; the new one's where both have it."""
    found: dict[str, float] = {}
    for assets in (identity.before, identity.after):
        found.update({k: asset.size for k, asset in assets.items() if isinstance(asset, Block)})
    return dict(sorted(found.items()))
