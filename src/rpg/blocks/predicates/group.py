"""group_by: bunches of blocks that lie apart, with or without strangers in them."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence
from itertools import combinations
from random import Random
from typing import Any, NamedTuple

import numpy as np

from rpg.blocks.centres import Centres, Mask
from rpg.blocks.geometry import footprint_gap
from rpg.blocks.predicate import Cluster, NearMiss, Predicate
from rpg.blocks.predicates.common import BUILD_GAP, SPANS, largest_edge, put, set_aside, shift, slack, swap
from rpg.blocks.predicates.plainly import ROOM
from rpg.blocks.predicates.stack import column
from rpg.blocks.state import IDENTITY, BlockState, Quat, Vec3, World
from rpg.blocks.traits import UP, Trait, Traits, symbols_shown
from rpg.blocks.verdict import FALSE, TRUE, Verdict, at_least, every, holds
from rpg.ir.structures import GroupBy

SHUFFLES = 4
"""How many further ways round the groups are offered."""
DEEP = 6
"""At most so many blocks of a group lie one behind the other."""

Groups = Sequence[Sequence[str]]


class Link(NamedTuple):
    """Two blocks and the face gap between them (m)."""

    gap: float
    a: str
    b: str


def links(state: BlockState, names: Sequence[str]) -> list[Link]:
    """The links that chain `names` with the least gaps (a minimum spanning tree), in order of their making."""
    if not names:
        return []
    nearest = {name: _link(state, names[0], name) for name in names[1:]}
    tree = []
    while nearest:
        new = min(nearest, key=lambda name: nearest[name].gap)
        tree.append(nearest.pop(new))
        for name, link in nearest.items():
            if _bound(state, new, name) < link.gap:
                nearest[name] = min(link, _link(state, new, name))
    return tree


def _link(state: BlockState, a: str, b: str) -> Link:
    return Link(max(0.0, footprint_gap(state, a, b)), a, b)


def _bound(state: BlockState, a: str, b: str) -> float:
    """A gap that the two are never nearer than."""
    (ax, ay, _), (bx, by, _) = state.position[a], state.position[b]
    return math.hypot(ax - bx, ay - by) - (state.world.edge[a] + state.world.edge[b]) * 0.8661


def _most(state: BlockState, a: str, b: str) -> float:
    """A gap that the two are never farther apart than."""
    (ax, ay, _), (bx, by, _) = state.position[a], state.position[b]
    return math.hypot(ax - bx, ay - by) - (state.world.edge[a] + state.world.edge[b]) / 2


def separation(state: BlockState, groups: Groups) -> Link | None:
    """The nearest two blocks of different groups."""
    pairs = sorted((_bound(state, a, b), a, b) for one, two in combinations(groups, 2) for a in one for b in two)
    best: Link | None = None
    for bound, a, b in pairs:
        if best is not None and bound >= best.gap:
            break
        link = _link(state, a, b)
        if best is None or link < best:
            best = link
    return best


def divide(state: BlockState, names: Sequence[str], count: int) -> list[list[str]]:
    """`names` in so many groups, cut where the gaps are largest."""
    tree = sorted(links(state, names), reverse=True)
    kept = tree[count - 1 :]
    home = {name: [name] for name in names}
    for link in kept:
        one, two = home[link.a], home[link.b]
        if one is not two:
            one.extend(two)
            for name in two:
                home[name] = one
    found: list[list[str]] = []
    for name in names:
        if home[name] not in found:
            found.append(home[name])
    return found


def strangers_fit(groups: Groups, node: GroupBy, traits: Traits) -> bool:
    """Does every group have one value of its own, and exactly so many members that differ from it?"""
    assert node.by is not None
    options: list[list[Trait]] = []
    for group in groups:
        values = [traits.of(name, node.by) for name in group]
        usual = len(values) - node.outliers
        options.append([v for v in dict.fromkeys(values) if usual > 0 and values.count(v) == usual])
    return _distinct(options, frozenset())


def _distinct(options: list[list[Trait]], used: frozenset[Trait]) -> bool:
    """Can one of each list be chosen, all different?"""
    return not options or any(_distinct(options[1:], used | {v}) for v in options[0] if v not in used)


def _alone(state: BlockState, name: str, group: Sequence[str], reach: float) -> bool:
    """Is a block farther from every other member of its group than a chain reaches?"""
    return all(other == name or _bound(state, name, other) > reach for other in group)


class GroupByPredicate(Predicate[GroupBy]):
    """Members chained by small gaps; groups apart."""

    def evaluate(self, node: GroupBy, state: BlockState) -> Verdict:
        groups: Groups = node.groups
        parts: list[Verdict] = []
        if node.outliers and node.by is not None:
            names = [name for group in groups for name in group]
            groups = divide(state, names, len(groups))
            traits = Traits(state.world, symbols_shown(state, tuple(names), UP))
            parts.append(TRUE if strangers_fit(groups, node, traits) else FALSE)
        edge = largest_edge(state, [name for group in groups for name in group])
        inside = [max((link.gap for link in links(state, group)), default=0.0) for group in groups]
        parts.append(holds(slack(max(inside), node.inner_edges * edge)))
        nearest = separation(state, groups)
        if nearest is not None:
            parts.append(at_least(nearest.gap, node.outer_edges * edge))
            farther = (nearest.gap - max(inside)) / edge
            parts.append(holds(farther) if farther != 0.0 else FALSE)
        return every(parts)

    def holds(self, node: GroupBy, state: BlockState) -> bool:
        if not node.outliers:
            edge = largest_edge(state, [name for group in node.groups for name in group])
            apart = node.outer_edges * edge - 1e-6
            pairs = ((a, b) for one, two in combinations(node.groups, 2) for a in one for b in two)
            if any(_most(state, a, b) < apart for a, b in pairs):
                return False
            reach = node.inner_edges * edge + 1e-6
            for group in node.groups:
                if len(group) > 1 and any(_alone(state, name, group, reach) for name in group):
                    return False
        return self.evaluate(node, state).value

    def perhaps(self, node: GroupBy, many: Centres) -> Mask:
        found = many.all()
        if node.outliers:
            return found
        names = [name for group in node.groups for name in group]
        home = np.repeat(np.arange(len(node.groups)), [len(group) for group in node.groups])
        x, y, _ = many.of(names)
        edges = many.edges(names)
        squares = (x[:, :, None] - x[:, None, :]) ** 2 + (y[:, :, None] - y[:, None, :]) ** 2
        sums = edges[:, None] + edges
        fellows = home[:, None] == home
        least = np.maximum(node.outer_edges * edges.max() + sums / 2 - ROOM, 0.0)
        reach = node.inner_edges * edges.max() + sums * 0.8661 + ROOM
        apart = (squares >= least**2) | fellows
        chained = (squares <= reach**2) & fellows
        # nobody is a neighbour of its own, but for who is alone in its group
        np.einsum("skk->sk", chained)[:] = fellows.sum(axis=1) == 1
        found &= apart.all(axis=(1, 2)) & chained.any(axis=2).all(axis=1)
        return found

    def build(self, node: GroupBy, world: World, rng: Random) -> Iterator[list[Cluster]]:
        found = False
        edge = max(world.edge[name] for group in node.groups for name in group)
        gap = BUILD_GAP if node.inner_edges * edge > BUILD_GAP else 0.0
        for attempt in range(SHUFFLES + 1):
            groups = self._divisions(node, world, rng, attempt)
            if groups is None:
                return
            for apart in (2.0, 1.6):
                whole = side_by_side(groups, world, max(apart * node.outer_edges / 1.5, 0.1), gap)
                if whole is not None:
                    yield [whole]
                    found = True
                    break
        groups = self._divisions(node, world, rng, 0) or []
        for within in dict.fromkeys((gap, 0.0)):
            yield [blob(group, world, 1 + (len(group) - 1) // 3, within) for group in groups]
        if not found:
            yield [column(sorted(group, key=lambda n: -world.edge[n]), world, IDENTITY) for group in groups]

    def _divisions(self, node: GroupBy, world: World, rng: Random, attempt: int) -> list[list[str]] | None:
        """The groups in some order, after so many members of each have gone to the next group."""
        groups = [list(group) for group in node.groups]
        if attempt:
            rng.shuffle(groups)
            for group in groups:
                rng.shuffle(group)
        if not node.outliers or node.by is None:
            return groups
        if len(groups) < 2 or min(map(len, groups)) <= node.outliers:
            return None
        k = node.outliers
        mixed = [group[k:] + groups[n - 1][:k] for n, group in enumerate(groups)]
        return mixed if strangers_fit(mixed, node, Traits(world)) else None

    def propose(self, node: GroupBy, block: str, state: BlockState, rng: Random) -> Iterator[tuple[float, float]]:
        """Beside the members of the block's group that are placed already."""
        mine = next((group for group in node.groups if block in group), ())
        for other in (name for name in mine if name != block and name in state.position):
            x, y, _ = state.position[other]
            step = (state.world.edge[block] + state.world.edge[other]) / 2 + BUILD_GAP
            yield from ((x + step * dx, y + step * dy) for dx, dy in ((1, 0), (-1, 0), (0, 1), (0, -1)))

    def near_misses(self, node: GroupBy, state: BlockState, rng: Random) -> Iterator[NearMiss]:
        groups: Groups = node.groups
        names = [name for group in groups for name in group]
        if node.outliers and node.by is not None:
            groups = divide(state, names, len(groups))
        edge = largest_edge(state, names)
        several = next((group for group in groups if len(group) > 1), None)
        if several is not None:
            yield NearMiss(f"{several[0]} away from its group", set_aside(state, several[0], clearance=0.2))
        pairs = [pair for pair in combinations(groups, 2) if len(pair[0]) + len(pair[1]) > 2]
        if pairs:
            yield from self._between(node, groups, *pairs[0], state)
        nearest = separation(state, groups)
        if nearest is not None:
            yield self._closer(node, groups, nearest, edge, state)

    def _between(
        self, node: GroupBy, groups: Groups, one: Sequence[str], two: Sequence[str], state: BlockState
    ) -> Iterator[NearMiss]:
        """A block moved over to another group; two unlike blocks of different groups exchanged."""
        world, traits = state.world, Traits(state.world)
        if not node.outliers:
            a, b = (one[0], two[-1]) if len(one) > 1 else (two[0], one[-1])
            x, y, _ = state.position[b]
            step = (world.edge[a] + world.edge[b]) / 2 + BUILD_GAP
            moved = put(state, a, (x - step, y, state.position[a][2]))
            yield NearMiss(f"{a} with {b}'s group", moved)
        for a in one:
            for b in two:
                if world.look[a] == world.look[b]:
                    continue
                changed = [[b if n == a else a if n == b else n for n in group] for group in groups]
                if not node.outliers or not strangers_fit(changed, node, traits):
                    yield NearMiss(f"{a} and {b} exchanged", swap(state, a, b))
                    return

    def _closer(self, node: GroupBy, groups: Groups, nearest: Link, edge: float, state: BlockState) -> NearMiss:
        """One of the two nearest groups moved towards the other until they are too near."""
        group = next(group for group in groups if nearest.a in group)
        (ax, ay, _), (bx, by, _) = state.position[nearest.a], state.position[nearest.b]
        length = math.hypot(bx - ax, by - ay)
        step = nearest.gap - 0.85 * node.outer_edges * edge
        return NearMiss(
            "two groups too near", shift(state, group, step * (bx - ax) / length, step * (by - ay) / length)
        )


def blob(group: Sequence[str], world: World, columns: int, gap: float) -> Cluster:
    """A group in a grid of so many columns, `gap` (m) apart."""
    pitch = max(world.edge[name] for name in group) + gap
    rows = -(-len(group) // columns)
    poses: dict[str, tuple[Vec3, Quat | None]] = {}
    for k, name in enumerate(group):
        x, y = pitch * (k // columns - (rows - 1) / 2), pitch * ((columns - 1) / 2 - k % columns)
        poses[name] = ((x, y, world.edge[name] / 2), IDENTITY)
    return Cluster(poses)


def side_by_side(groups: Groups, world: World, apart_edges: float, gap: float) -> Cluster | None:
    """All groups in one cluster, on shelves from left to right; None where they need more than the workspace."""
    edge = max(world.edge[name] for group in groups for name in group)
    for deep in range(2, DEEP + 1):
        columns = [-(-len(group) // deep) for group in groups]
        blobs = [blob(group, world, count, gap) for group, count in zip(groups, columns, strict=True)]
        placed = _shelves(blobs, edge * (1.0 + apart_edges))
        if placed is not None:
            return placed
    return None


def _shelves(blobs: Iterable[Cluster], apart: float) -> Cluster | None:
    """Blobs from left to right with `apart` between the centres of facing blocks; full shelves go on behind."""
    poses: dict[str, tuple[Vec3, Quat | None]] = {}
    x = y = depth = 0.0
    for cluster in blobs:
        xs = [p[0] for p, _ in cluster.poses.values()]
        ys = [p[1] for p, _ in cluster.poses.values()]
        width = max(ys) - min(ys)
        if y and y + width > SPANS["y"] + 1e-9:
            x, y, depth = x + depth + apart, 0.0, 0.0
        for name, ((px, py, pz), quat) in cluster.poses.items():
            poses[name] = ((x + px - min(xs), -(y + max(ys) - py), pz), quat)
        y += width + apart
        depth = max(depth, max(xs) - min(xs))
        if y - apart > SPANS["y"] + 1e-9 or x + depth > SPANS["x"] + 1e-9:
            return None
    return Cluster(poses)


TABLE: dict[str, Predicate[Any]] = {"group_by": GroupByPredicate()}
