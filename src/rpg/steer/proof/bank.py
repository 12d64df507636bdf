"""A bank of states on which two goals are compared: arranged goals of both, their near-misses, starts, random layouts.

States are held by key (see `identity`), so that each version can see them with its own names and its own blocks.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping
from functools import cached_property
from itertools import combinations
from random import Random
from types import MappingProxyType
from typing import NamedTuple

from rpg.blocks.arrange import CHANGES, arrange
from rpg.blocks.constants import TABLE_Z, WORKSPACE_X, WORKSPACE_Y
from rpg.blocks.initial import sample_start
from rpg.blocks.near_miss import near_misses
from rpg.blocks.state import IDENTITY, BlockState, Quat, Vec3, World, yaw_quat
from rpg.core.diagnostics import Refusal
from rpg.ir import goal as g
from rpg.ir.edits import key
from rpg.ir.order import Order
from rpg.ir.schema import TaskSchema
from rpg.ir.walk import atoms, rename, transform
from rpg.steer.proof.identity import Identity

SIZE = 512
"""States in a bank."""
ARRANGED, MISSED, STARTS, SHUFFLES = 3, 1, 8, 6
"""Per version: goal states arranged, those whose near-misses are taken, starts drawn; and per goal state, re-dealings
of its places among its blocks."""

MOST_CHOICES = 64
"""Look-alikes of the other version are tried in place of a version's own up to so many combinations."""

READERS = frozenset({"equation", "facing", "group_by", "spells", "towers"})
"""Conditions on colours or symbols."""

HEIGHTS = (1, 1, 1, 2, 2, 3, 4)
"""Heights of the stacks in random layouts."""
PITCHES = (1.02, 1.2, 1.6, 2.2)
"""Distances between the stacks of a close layout, in edges."""
RANDOM = "random layout"
"""The source of states that are no version's in particular."""
RENEWED = 16
"""After so many states another order of the places on the table is drawn."""


Spot = tuple[float, float]
"""A place on the table."""


class Layout(NamedTuple):
    """Where objects are, by key. `upright`: none is turned."""

    position: dict[str, Vec3]
    orientation: dict[str, Quat]
    upright: bool = False


class Sample(NamedTuple):
    """One state of the bank: where every object of either version is, how it began, and where it is from.

    `known`: what one of the versions is known to say of it by construction.
    """

    layout: Layout
    start: Layout
    source: str
    known: Mapping[str, bool] = MappingProxyType({})


class Side:
    """One version as the bank sees it: `goal` and `world` are by key, as the states of the bank are."""

    def __init__(self, schema: TaskSchema, label: str) -> None:
        self.schema = schema
        self.label = label
        self.names = {key(asset): asset.name for asset in schema.assets}
        keys = {name: k for k, name in self.names.items()}
        self.goal = rename(schema.goal, keys)
        self.world = World(asset.model_copy(update={"name": key(asset)}) for asset in schema.assets)
        self.keys = {k: k for k in self.world.blocks}
        self.upright = dict.fromkeys(self.keys, IDENTITY)
        self.looks_back = any(atom.kind in CHANGES for atom in atoms(schema.goal))

    def state(self, sample: Sample, keys: Mapping[str, str] | None = None) -> BlockState:
        """`sample` as this version has it: its own blocks, or those of `keys` in their place."""
        keys = self.keys if keys is None else keys
        start = self._only(sample.start, keys, None) if self.looks_back else None
        return self._only(sample.layout, keys, start)

    def _only(self, layout: Layout, keys: Mapping[str, str], start: BlockState | None) -> BlockState:
        position, orientation = layout.position, layout.orientation
        if keys is not self.keys or len(keys) < len(position):
            position = {k: position[taken] for k, taken in keys.items()}
            orientation = self.upright if layout.upright else {k: orientation[taken] for k, taken in keys.items()}
        return BlockState(self.world, position, orientation, start=start)

    def named(self, sample: Sample) -> BlockState:
        """`sample` by the names of this version."""
        state = self.state(sample)
        start = None if state.start is None else self._named(state.start, None)
        return self._named(state, start)

    def _named(self, state: BlockState, start: BlockState | None) -> BlockState:
        return BlockState(
            world=World(self.schema.assets),
            position={self.names[k]: place for k, place in state.position.items()},
            orientation={self.names[k]: turn for k, turn in state.orientation.items()},
            start=start,
        )

    def choices(self, other: Side) -> tuple[dict[str, str], ...]:
        """Every set of blocks of both versions that this version can take for its own, its own first.

        They differ where the other version has more blocks of a look.
        """
        foreign = {k: other.world.look[k] for k in other.keys if k not in self.keys}
        found = [self.keys]
        for look in sorted(set(foreign.values()) & set(self.world.look.values())):
            mine = [k for k in self.keys if self.world.look[k] == look]
            pool = [*mine, *(k for k in foreign if foreign[k] == look)]
            found = [
                {**before, **dict(zip(mine, chosen, strict=True))}
                for before in found
                for chosen in combinations(pool, len(mine))
            ]
            if len(found) > MOST_CHOICES:
                return (self.keys,)
        return (self.keys, *found[1:])


def _seen(side: Side) -> tuple[object, ...]:
    """All that the verdicts of a version depend on."""
    world = side.world
    looks: dict[str, object] = dict(world.look)
    if not any(_reads_looks(atom) for atom in atoms(side.goal)):
        groups: dict[object, set[str]] = {}
        for k, look in looks.items():
            groups.setdefault(look, set()).add(k)
        looks = {k: groups[look] for k, look in looks.items()}
    return transform(side.goal, _without_span), looks, world.edge, world.patches


def _reads_looks(atom: g.Atom) -> bool:
    """May a verdict of `atom` depend on more of the looks of blocks than which of them look alike?"""
    order: Order | None = getattr(atom, "order", None)
    ordered = order is not None and order.by not in ("any", "given")
    return atom.kind in READERS or ordered or any(getattr(atom, asked, None) for asked in ("pattern", "readable"))


def _without_span(node: g.Goal) -> g.Goal:
    return node if node.span is None else node.model_copy(update={"span": None})


class Bank:
    """The states on which two versions are compared. The same versions give the same bank.

    `starts`: of both versions, drawn from the same seeds. `same`: both goals are one expression over one world, but for
    names and for looks that it does not ask about. They say the same of every state then: what is arranged for one of
    them is arranged for both.
    """

    def __init__(self, identity: Identity, seed: int = 0) -> None:
        self.old, self.new = Side(identity.old, "old"), Side(identity.new, "new")
        self.same = not self.old.looks_back and _seen(self.old) == _seen(self.new)
        self._world = World({**self.old.world.assets, **self.new.world.assets}.values())
        self.sizes = dict(sorted(self._world.edge.items()))
        self.alike = len(set(self.sizes.values())) == 1
        self.rng = Random(f"bank {seed}")
        self.slots = _slots(1.5 * max(self.sizes.values()))
        self.starts = {"old": _starts(self.old, STARTS)}
        same_draws = _drawn_from(self.old) == _drawn_from(self.new)
        self.starts["new"] = self.starts["old"] if same_draws else _starts(self.new, STARTS)
        self.begun = {label: [self._complete(start) for start in self.starts[label]] for label in ("old", "new")}
        self.samples: list[Sample] = []
        self._fill()

    def whole(self, sample: Sample) -> BlockState:
        """`sample` with the blocks of both versions."""
        return BlockState(self._world, sample.layout.position, sample.layout.orientation)

    def _sides(self) -> tuple[Side, ...]:
        return self.old, self.new

    def _arranged(self) -> tuple[Side, ...]:
        """The sides for which goals are arranged."""
        return self._sides()[self.same :]

    def _fill(self) -> None:
        goals = {side.label: self._goals(side) for side in self._arranged()}
        for side in self._arranged():
            for state in goals[side.label]:
                self._add(side, state, "goal", True)
            for state in goals[side.label][:MISSED]:
                for miss in near_misses(side.goal, state, self.rng):
                    self._add(side, miss.state, "near-miss", False)
        for side in self._sides():
            for start in self.begun[side.label]:
                self.samples.append(Sample(start, start, f"{side.label} start"))
            for state in goals.get(side.label, ()):
                for dealt, alike in self._dealt(state):
                    # nobody can tell look-alikes that have changed places, but who knows where they came from
                    self._add(side, dealt, "goal re-dealt", True if alike and not side.looks_back else None)
        while len(self.samples) < SIZE:
            self.samples.append(self._random(len(self.samples)))

    def _goals(self, side: Side) -> list[BlockState]:
        begun = self.starts[side.label][0]
        start = BlockState(side.world, begun.position, begun.orientation)
        try:
            return arrange(side.goal, side.world, rng=self.rng, start=start, count=ARRANGED)
        except Refusal:
            return []

    def _dealt(self, state: BlockState) -> Iterator[tuple[BlockState, bool]]:
        """The same places with other blocks in them, dealt among blocks of one size; and whether look-alikes alone
        have changed places."""
        names, look = sorted(state.position), state.world.look
        for _ in range(SHUFFLES):
            other = names[:]
            self.rng.shuffle(other)
            pairs = [(a, b) for a, b in zip(names, other, strict=True) if state.world.edge[a] == state.world.edge[b]]
            if {a for a, _ in pairs} == {b for _, b in pairs}:
                dealt = state.moved({a: (state.position[b], state.orientation.get(b, IDENTITY)) for a, b in pairs})
                yield dealt, all(look[a] == look[b] for a, b in pairs)

    def _add(self, side: Side, state: BlockState, source: str, holds: bool | None) -> None:
        """Add a state of one version, with the other version's blocks somewhere on the table as well."""
        known = {} if holds is None else {side.label: holds}
        turns = {k: state.orientation.get(k, IDENTITY) for k in state.position}
        layout = self._complete(Layout(dict(state.position), turns))
        self.samples.append(Sample(layout, self.begun[side.label][0], f"{side.label} {source}", known))

    def _complete(self, layout: Layout) -> Layout:
        """A state of one version, with every block that it lacks at a free place flat on the table."""
        missing = [k for k in self.sizes if k not in layout.position]
        if not missing:
            return layout
        position, orientation = dict(layout.position), dict(layout.orientation)
        taken = [(x, y) for x, y, _ in position.values()]
        reach = (1.5 * max(self.sizes.values())) ** 2
        enough = min(len(self.slots), 3 * len(missing) + 4 * len(taken))
        for x, y in self.rng.sample(self.slots, enough):
            if not missing:
                break
            if all((x - a) ** 2 + (y - b) ** 2 > reach for a, b in taken):
                k = missing.pop()
                position[k] = (x, y, TABLE_Z + self.sizes[k] / 2)
                orientation[k] = yaw_quat(self.rng.uniform(-math.pi, math.pi))
        for index, k in enumerate(missing):
            position[k], orientation[k] = self._aside(index, k), IDENTITY
        return Layout(position, orientation)

    def _aside(self, index: int, k: str) -> Vec3:
        """A place beyond the others, for blocks that find no room among them."""
        return (WORKSPACE_X[1] + 0.2 * (index + 1), 0.0, TABLE_Z + self.sizes[k] / 2)

    def _random(self, number: int) -> Sample:
        """Blocks dealt into stacks of random heights, square to the table: by turns close together and anywhere."""
        draw, sizes, alike = self.rng.random, self.sizes, self.alike
        names = [name for _, name in sorted([(draw(), name) for name in sizes])]
        position: dict[str, Vec3] = {}
        left = len(names)
        for x, y in self._near(left) if number % 2 == 0 else self._anywhere(number):
            height = min(left, HEIGHTS[int(draw() * len(HEIGHTS))])
            stack = names[left - height : left]
            if not alike:
                stack.sort(key=lambda k: -sizes[k])
            for k, z in zip(stack, self._levels if alike else _levels([sizes[k] for k in stack]), strict=False):
                position[k] = (x, y, z)
            left -= height
            if not left:
                break
        for index, k in enumerate(names[:left]):
            position[k] = self._aside(index, k)
        begun = self.begun["new"]
        return Sample(Layout(position, self._upright, True), begun[int(draw() * len(begun))], RANDOM)

    @cached_property
    def _levels(self) -> list[float]:
        """Heights of the centres in a stack of blocks that are all of one size."""
        return _levels([max(self.sizes.values())] * max(HEIGHTS))

    @cached_property
    def _upright(self) -> dict[str, Quat]:
        return dict.fromkeys(self.sizes, IDENTITY)

    def _near(self, count: int) -> Iterator[tuple[float, float]]:
        """Places in a few rows around a point, at one pitch."""
        draw = self.rng.random
        pitch = max(self.sizes.values()) * PITCHES[int(draw() * len(PITCHES))]
        columns = 1 + int(draw() * min(6, count))
        x, y = 0.45 + 0.15 * draw(), -0.1 + 0.25 * draw()
        for place in range(count):
            yield x + place // columns * pitch, y - place % columns * pitch

    def _anywhere(self, number: int) -> Iterator[tuple[float, float]]:
        """Places on the table in a random order, which is drawn anew every so often."""
        if number % RENEWED == 1:
            _shuffle(self.slots, self.rng)
        first = int(self.rng.random() * len(self.slots))
        yield from self.slots[first:]
        yield from self.slots[:first]


def _levels(edges: Iterable[float]) -> list[float]:
    """Heights of the centres of blocks that stand one on the other, from the table up."""
    found, z = [], TABLE_Z
    for edge in edges:
        found.append(z + edge / 2)
        z += edge
    return found


def _shuffle(items: list[Spot], rng: Random) -> None:
    """As `rng.shuffle` does it, which takes three times as long for its calls: there are hundreds of places."""
    bits = rng.getrandbits
    for last in range(len(items) - 1, 0, -1):
        width = (last + 1).bit_length()
        other = bits(width)
        while other > last:
            other = bits(width)
        items[last], items[other] = items[other], items[last]


def _slots(pitch: float) -> list[Spot]:
    """Places on the table that are clear of each other, some of them beside the workspace."""
    return [
        (round(WORKSPACE_X[0] + i * pitch, 4), round(1.6 * WORKSPACE_Y[0] + j * pitch, 4))
        for i in range(math.floor((WORKSPACE_X[1] - WORKSPACE_X[0]) / pitch) + 1)
        for j in range(math.floor(1.6 * (WORKSPACE_Y[1] - WORKSPACE_Y[0]) / pitch) + 1)
    ]


def _drawn_from(side: Side) -> tuple[object, ...]:
    """All that the starts of a version are drawn from, by key: objects in their order, with their sizes and places,
    and how they start. Equal ones give equal starts for every seed."""
    keys = {name: k for k, name in side.names.items()}
    init = side.schema.init
    objects = tuple(
        (k, side.world.edge.get(k), side.world.patches.get(k) and side.world.patches[k].model_dump_json())
        for k in side.world.assets
    )
    starts = tuple(s.model_copy(update={"block": keys[s.block]}) for s in init.poses)
    heaps = tuple(tuple(keys[name] for name in heap) for heap in init.heaps)
    vacant = tuple(v.model_copy(update={"before": keys.get(v.before or "")}) for v in init.vacant)
    return objects, starts, heaps, vacant, tuple(rename(goal, keys) for goal in init.arranged)


def _starts(side: Side, count: int) -> list[Layout]:
    """Starts as the version itself draws them, by key."""
    world = World(side.schema.assets)
    found = []
    for seed in range(count):
        state = sample_start(side.schema.init, world, seed)
        position = {k: state.position[side.names[k]] for k in side.keys}
        found.append(Layout(position, {k: state.orientation.get(side.names[k], IDENTITY) for k in side.keys}))
    return found
