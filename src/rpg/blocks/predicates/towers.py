"""towers: blocks that form several stacks and nothing else."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import pairwise
from random import Random
from typing import Any

import numpy as np

from rpg.blocks.centres import Centres, Mask
from rpg.blocks.constants import SUPPORT_GAP, TABLE_Z
from rpg.blocks.geometry import table_gap
from rpg.blocks.predicate import Cluster, NearMiss, Predicate
from rpg.blocks.predicates.common import set_aside, shift, stand_on, strangers, swap
from rpg.blocks.predicates.patches import on_patch
from rpg.blocks.predicates.plainly import DIAGONAL, ROOM, perhaps_on
from rpg.blocks.predicates.stack import YAWS, alone, chain, column
from rpg.blocks.predicates.vertical import DIRECTLY, directly_on
from rpg.blocks.state import BlockState, World, yaw_quat
from rpg.blocks.traits import Traits
from rpg.blocks.verdict import FALSE, Verdict, every, some
from rpg.ir.structures import Towers

MAX_SPLITS = 8
"""How many ways to divide blocks into towers are offered."""


def stacks_of(state: BlockState, names: Sequence[str]) -> list[list[str]] | None:
    """The towers that `names` stand in, each bottom to top; None where one of them stands in none.

    Each block is either on the table or on the one of the others that it fits best; no two are on the same one.
    """
    above: dict[str, str] = {}
    feet = []
    for name in names:
        if abs(table_gap(state, name)) <= SUPPORT_GAP:
            feet.append(name)
            continue
        below = best_support(state, name, names)
        if below is None or below in above:
            return None
        above[below] = name
    towers = [[foot] for foot in feet]
    for tower in towers:
        while tower[-1] in above:
            tower.append(above[tower[-1]])
    return towers if sum(map(len, towers)) == len(names) else None


def best_support(state: BlockState, name: str, names: Sequence[str]) -> str | None:
    """The block of `names` that `name` is most clearly on."""
    x, y, z = state.position[name]
    best, margin = None, -1e-12
    for other in names:
        ox, oy, oz = state.position[other]
        if oz < z and abs(ox - x) < 0.1 and abs(oy - y) < 0.1:
            found = directly_on(name, other, state)
            if found.value and (found.margin > margin or (found.margin == margin and other < (best or other))):
                best, margin = other, found.margin
    return best


class TowersPredicate(Predicate[Towers]):
    """The blocks divide into stacks by what rests on what."""

    def evaluate(self, node: Towers, state: BlockState) -> Verdict:
        towers = stacks_of(state, node.blocks)
        if towers is None or not towers or min(map(len, towers)) < 2:
            return FALSE
        heights = sorted(map(len, towers))
        if node.count is not None and len(towers) != node.count:
            return FALSE
        if node.heights is not None and heights != sorted(node.heights):
            return FALSE
        if node.equal and heights[0] != heights[-1]:
            return FALSE
        if node.each is not None and not self._sorted_out(node, towers, Traits(state.world)):
            return FALSE
        parts = [chain(state, tower) for tower in towers]
        parts.append(alone(state, node.blocks))
        if node.matching is not None:
            parts += [self._matches(node.matching, tower, state) for tower in towers]
        return every(parts)

    def perhaps(self, node: Towers, many: Centres) -> Mask:
        x, y, z = many.of(node.blocks)
        edges = many.edges(node.blocks)
        each, others = ([values[:, :, None] for values in (x, y, z)], [values[:, None, :] for values in (x, y, z)])
        one, other = edges[:, None], edges
        reach = DIRECTLY.offset_edges * np.maximum(one, other) + DIRECTLY.slack
        on = perhaps_on(each, others, (one + other) / 2, reach, DIRECTLY.gap)
        low = z - TABLE_Z <= DIAGONAL * edges / 2 + SUPPORT_GAP + ROOM
        carried, carries = on.any(axis=2), on.any(axis=1)
        # a tower has two blocks or more, so that who can be nothing but a foot has somebody on it
        found = many.all()
        found &= (carried | (low & carries)).all(axis=1)
        found &= (low & ~carried).sum(axis=1) <= (node.count or len(node.heights or node.blocks))
        return found

    def _sorted_out(self, node: Towers, towers: list[list[str]], traits: Traits) -> bool:
        """Every tower agrees in the attribute, and no two share its value if they must differ."""
        assert node.each is not None
        values = [{traits.of(name, node.each) for name in tower} for tower in towers]
        if any(len(found) > 1 for found in values):
            return False
        return not node.separate or len(set.union(*values)) == len(towers)

    def _matches(self, patches: Sequence[str], tower: list[str], state: BlockState) -> Verdict:
        """The tower stands on a patch of the colour of all of its blocks."""
        world = state.world
        colors = {world.blocks[name].color for name in tower}
        fitting = [world.patches[p] for p in patches if {world.patches[p].color} == colors]
        return some([on_patch(tower[0], patch, state) for patch in fitting]) if fitting else FALSE

    def build(self, node: Towers, world: World, rng: Random) -> Iterator[list[Cluster]]:
        for k, towers in enumerate(self._divisions(node, world, rng)):
            if k == MAX_SPLITS:
                return
            turn = yaw_quat(YAWS[k % len(YAWS)])
            clusters = [column(sorted(tower, key=lambda n: -world.edge[n]), world, turn) for tower in towers]
            yield _on_patches(clusters, towers, node.matching, world) if node.matching else clusters

    def _divisions(self, node: Towers, world: World, rng: Random) -> Iterator[list[list[str]]]:
        """Ways to deal the blocks to towers: the even ones first."""
        pool = list(node.blocks)
        for attempt in range(4):
            if attempt:
                rng.shuffle(pool)
            groups = [pool] if node.each is None else list(Traits(world).by_value(tuple(pool), node.each).values())
            for sizes in _split_sizes([len(group) for group in groups], node):
                towers = []
                for group, parts in zip(groups, sizes, strict=True):
                    rest = list(group)
                    for size in parts:
                        towers.append(rest[:size])
                        rest = rest[size:]
                yield towers

    def propose(self, node: Towers, block: str, state: BlockState, rng: Random) -> Iterator[tuple[float, float]]:
        for name in node.matching or ():
            patch = state.world.patches[name]
            if block in node.blocks and patch.color == state.world.blocks[block].color and patch.position:
                yield patch.position

    def near_misses(self, node: Towers, state: BlockState, rng: Random) -> Iterator[NearMiss]:
        towers = stacks_of(state, node.blocks) or []
        if not towers:
            return
        tallest = max(towers, key=len)
        top = tallest[-1]
        yield NearMiss(f"{top} alone on the table", set_aside(state, top))
        yield NearMiss(f"{top} past the edge of what is below it", self._past_edge(top, state))
        traits = Traits(state.world)
        for one, two in pairwise(towers):
            yield from self._between(node, one, two, traits, state)
        others = strangers(state, node.blocks)
        if others:
            yield NearMiss(f"{others[0]} on top of a tower", stand_on(state, others[0], top))
        for name in node.matching or ():
            patch = state.world.patches[name]
            tower = next((t for t in towers if state.world.blocks[t[0]].color == patch.color), None)
            if tower is not None:
                reach = max(patch.size) + state.world.edge[tower[0]]
                yield NearMiss("a tower beside its patch", shift(state, tower, 0.0, reach))

    def _between(
        self, node: Towers, one: list[str], two: list[str], traits: Traits, state: BlockState
    ) -> Iterator[NearMiss]:
        """Changes that involve two towers: one put on the other, their tops exchanged, their heights changed."""
        moved = state
        below = one[-1]
        for name in two:
            moved = stand_on(moved, name, below)
            below = name
        heights = sorted(node.heights or ())
        if node.count is not None or (node.each and traits.of(one[0], node.each) != traits.of(two[0], node.each)):
            yield NearMiss("two towers put together", moved)
        if node.each and traits.of(one[-1], node.each) != traits.of(two[-1], node.each):
            yield NearMiss(f"{one[-1]} and {two[-1]} exchanged", swap(state, one[-1], two[-1]))
        uneven = node.equal or (heights and abs(len(one) - 1 - len(two)) != 0)
        if uneven and node.count == 2:
            yield NearMiss(f"{one[-1]} moved to the other tower", stand_on(state, one[-1], two[-1]))

    def _past_edge(self, name: str, state: BlockState) -> BlockState:
        return shift(state, [name], 0.0, max(state.world.edge.values()) * 0.5 + 0.006)


def _on_patches(
    clusters: list[Cluster], towers: Sequence[Sequence[str]], patches: Sequence[str], world: World
) -> list[Cluster]:
    """Towers that have a patch of their colour to themselves put in its middle; the others as they are."""
    free = [world.patches[name] for name in patches if world.patches[name].position is not None]
    found = []
    for cluster, tower in zip(clusters, towers, strict=True):
        patch = next((p for p in free if p.color == world.blocks[tower[0]].color), None)
        if patch is None or patch.position is None:
            found.append(cluster)
            continue
        free.remove(patch)
        px, py = patch.position
        poses = {name: ((x + px, y + py, z), turn) for name, ((x, y, z), turn) in cluster.poses.items()}
        found.append(Cluster(poses, fixed=True))
    return found


def _split_sizes(groups: list[int], node: Towers) -> Iterator[list[list[int]]]:
    """For each group of blocks that may share a tower, the heights of its towers."""
    if node.each is not None and node.separate:
        options: list[list[list[int]]] = [[[size]] for size in groups]
    else:
        options = [list(_partitions(size, size)) for size in groups]
    fitting = [choice for choice in _choices(options) if _fits(node, [h for part in choice for h in part])]
    yield from sorted(fitting, key=_unnatural)


def _fits(node: Towers, heights: list[int]) -> bool:
    if min(heights, default=0) < 2:
        return False
    if node.count is not None and len(heights) != node.count:
        return False
    if node.heights is not None and sorted(heights) != sorted(node.heights):
        return False
    return not node.equal or len(set(heights)) == 1


def _unnatural(choice: list[list[int]]) -> tuple[int, int]:
    """Uneven towers, then towers far from two in number, come later."""
    heights = [h for part in choice for h in part]
    return max(heights) - min(heights), abs(len(heights) - max(2, len(choice)))


def _partitions(total: int, largest: int) -> Iterator[list[int]]:
    """Ways to write `total` as a sum of numbers from 2 to `largest`, not increasing."""
    if total == 0:
        yield []
    for part in range(min(total, largest), 1, -1):
        for rest in _partitions(total - part, part):
            yield [part, *rest]


def _choices(options: list[list[list[int]]]) -> Iterator[list[list[int]]]:
    """One option for every group."""
    if not options:
        yield []
        return
    for first in options[0]:
        for rest in _choices(options[1:]):
            yield [first, *rest]


TABLE: dict[str, Predicate[Any]] = {"towers": TowersPredicate()}
