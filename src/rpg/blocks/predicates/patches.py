"""on_patch, empty: the flat marks on the table."""

from __future__ import annotations

import math
from collections.abc import Iterator
from functools import lru_cache
from random import Random
from typing import Any

from rpg.blocks.centres import Centres, Mask
from rpg.blocks.constants import SUPPORT_GAP
from rpg.blocks.geometry import carried, footprint_gap, grounded, patch_outline, polygon_gap, reach
from rpg.blocks.predicate import NearMiss, Predicate
from rpg.blocks.predicates.common import PAST, shift
from rpg.blocks.predicates.plainly import ROOM
from rpg.blocks.state import BlockState
from rpg.blocks.verdict import Verdict, every, holds
from rpg.ir.assets import GoalPatch
from rpg.ir.node import members
from rpg.ir.relations import Empty, OnPatch

LATTICE_GAP = 0.006
"""Least gap between blocks that are proposed side by side on a patch (m)."""


def outline_depth(patch: GoalPatch, x: float, y: float) -> float:
    """How deep a point lies inside of a patch's outline, in metres; negative outside."""
    px, py = patch.position or (math.nan, math.nan)
    if patch.shape == "circle":
        return patch.size[0] / 2 - math.hypot(x - px, y - py)
    return min(patch.size[0] / 2 - abs(x - px), patch.size[1] / 2 - abs(y - py))


def on_patch(name: str, patch: GoalPatch, state: BlockState) -> Verdict:
    """The centre is inside of the outline, and the block rests on the table or on blocks that do."""
    x, y, _ = state.position[name]
    inside = holds(outline_depth(patch, x, y) / (min(patch.size) / 2))
    return inside if not inside or grounded(state, name) else Verdict(False, -1.0)


class OnPatchPredicate(Predicate[OnPatch]):
    """Each of `a` is on the patch."""

    def evaluate(self, node: OnPatch, state: BlockState) -> Verdict:
        patch, names = state.world.patches[node.patch], state.resolve(node.a)
        return (
            on_patch(names[0], patch, state) if len(names) == 1 else every([on_patch(a, patch, state) for a in names])
        )

    def perhaps(self, node: OnPatch, many: Centres) -> Mask:
        patch = many.world.patches[node.patch]
        if not isinstance(node.a, tuple) or patch.position is None:
            return many.all()
        x, y, _ = many.of(node.a)
        (px, py), (depth, width) = patch.position, patch.size
        found = many.all()
        found &= (abs(x - px) <= depth / 2 + ROOM).all(axis=1) & (abs(y - py) <= width / 2 + ROOM).all(axis=1)
        return found

    def propose(self, node: OnPatch, block: str, state: BlockState, rng: Random) -> Iterator[tuple[float, float]]:
        if block in members(node.a):
            patch = state.world.patches[node.patch]
            edge = max(state.world.edge[n] for n in members(node.a))
            yield from lattice(patch, edge, len(members(node.a)), rng)

    def near_misses(self, node: OnPatch, state: BlockState, rng: Random) -> Iterator[NearMiss]:
        a = state.resolve(node.a)[0]
        patch = state.world.patches[node.patch]
        px, py, _ = state.where(node.patch)
        x, y, _ = state.position[a]
        load = carried(state, a)
        for k, side in ((0, "near"), (1, "right")):
            out = [px - x, py - y]
            out[k] -= patch.size[k] / 2 + PAST
            yield NearMiss(f"{a} just past the {side} edge of {node.patch}", shift(state, load, *out))
        yield NearMiss(f"{a} over {node.patch}", shift(state, load, 0.0, 0.0, SUPPORT_GAP + PAST))
        for other in (p for p in state.world.patches.values() if p.name != node.patch and not _overlap(p, patch)):
            ox, oy, _ = state.where(other.name)
            yield NearMiss(f"{a} on {other.name} instead", shift(state, load, ox - x, oy - y))


def _overlap(a: GoalPatch, b: GoalPatch) -> bool:
    return polygon_gap(patch_outline(a), patch_outline(b)) < 0.0


def lattice(patch: GoalPatch, edge: float, count: int, rng: Random) -> Iterator[tuple[float, float]]:
    """Places for so many blocks side by side on a patch: the lattice that stays deepest inside of it."""
    best = _deepest(patch, edge, count)
    yield from rng.sample(best, len(best))


@lru_cache(maxsize=32)
def _deepest(patch: GoalPatch, edge: float, count: int) -> tuple[tuple[float, float], ...]:
    """Of the lattices that have room for so many blocks, the one that stays deepest inside of a patch."""
    shapes = [(-(-count // columns), columns) for columns in range(1, count + 1)]
    grids = [_centred(rows, columns, edge, patch) for rows, columns in shapes]
    best = max(grids, key=lambda grid: (min([outline_depth(patch, *spot) for spot in grid]), -len(grid)))
    return tuple(best)


def _centred(rows: int, columns: int, edge: float, patch: GoalPatch) -> list[tuple[float, float]]:
    """A grid of places about the patch's centre, as wide as the patch has room for, up to half an edge of gaps."""
    px, py = patch.position or (math.nan, math.nan)
    room = [(size - edge) / (n - 1) if n > 1 else 0.0 for size, n in zip(patch.size, (rows, columns), strict=True)]
    dx, dy = (min(1.5 * edge, max(edge + LATTICE_GAP, pitch)) for pitch in room)
    return [
        (px + (i - (rows - 1) / 2) * dx, py + (j - (columns - 1) / 2) * dy) for i in range(rows) for j in range(columns)
    ]


class EmptyPredicate(Predicate[Empty]):
    """No footprint overlaps the patch."""

    def evaluate(self, node: Empty, state: BlockState) -> Verdict:
        patch = state.world.patches[node.patch]
        return every([holds(self._gap(name, patch, state) / state.world.edge[name]) for name in state.position])

    def _gap(self, name: str, patch: GoalPatch, state: BlockState) -> float:
        """Gap between a block and the patch, at most one edge; measured exactly where it may be less."""
        edge = state.world.edge[name]
        x, y, _ = state.position[name]
        px, py, _ = state.where(patch.name)
        rough = max(abs(x - px) - patch.size[0] / 2, abs(y - py) - patch.size[1] / 2) - 0.8661 * edge
        return edge if rough > edge else min(edge, footprint_gap(state, name, patch.name))

    def near_misses(self, node: Empty, state: BlockState, rng: Random) -> Iterator[NearMiss]:
        px, py, _ = state.where(node.patch)
        patch = state.world.patches[node.patch]
        for a in list(state.position)[:2]:
            x, y, _ = state.position[a]
            load = carried(state, a)
            yield NearMiss(f"{a} on {node.patch}", shift(state, load, px - x, py - y))
            edge = patch.size[1] / 2 + reach(state, a)[1] - PAST
            yield NearMiss(f"{a} over the edge of {node.patch}", shift(state, load, px - x, py + edge - y))


TABLE: dict[str, Predicate[Any]] = {"on_patch": OnPatchPredicate(), "empty": EmptyPredicate()}
