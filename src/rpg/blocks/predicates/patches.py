"""on_patch, empty: the flat marks on the table."""

from __future__ import annotations

import math
from collections.abc import Iterator
from random import Random
from typing import Any

from rpg.blocks.constants import SUPPORT_GAP
from rpg.blocks.geometry import carried, footprint_gap, grounded, patch_outline, polygon_gap, reach
from rpg.blocks.nouns import phrase, verb
from rpg.blocks.predicate import NearMiss, Predicate
from rpg.blocks.predicates.common import PAST, shift
from rpg.blocks.state import BlockState, World
from rpg.blocks.verdict import Verdict, every, holds
from rpg.ir.assets import GoalPatch
from rpg.ir.node import members
from rpg.ir.relations import Empty, OnPatch


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
        patch = state.world.patches[node.patch]
        return every([on_patch(a, patch, state) for a in state.resolve(node.a)])

    def propose(self, node: OnPatch, block: str, state: BlockState, rng: Random) -> Iterator[tuple[float, float]]:
        if block in members(node.a):
            yield from lattice(state.world.patches[node.patch], state.world.edge[block], rng)

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

    def english(self, node: OnPatch, world: World) -> str:
        return f"{phrase(node.a, world)} {verb(node.a)} on {phrase(node.patch, world)}"


def _overlap(a: GoalPatch, b: GoalPatch) -> bool:
    return polygon_gap(patch_outline(a), patch_outline(b)) < 0.0


def lattice(patch: GoalPatch, edge: float, rng: Random) -> Iterator[tuple[float, float]]:
    """Places on a patch: its centre, then squares of 2 x 2, 3 x 3 ... that lie side by side, corners first."""
    px, py = patch.position or (math.nan, math.nan)
    yield px, py
    pitch = edge + 0.006
    columns, rows = (max(1, int((side - edge / 2) / pitch) + 1) for side in patch.size)
    places = [
        (px + (i - (columns - 1) / 2) * pitch, py + (j - (rows - 1) / 2) * pitch)
        for i in range(columns)
        for j in range(rows)
    ]
    rng.shuffle(places)
    yield from (p for p in places if outline_depth(patch, *p) > 0.003)
    for _ in range(6):
        shares = rng.uniform(-0.4, 0.4), rng.uniform(-0.4, 0.4)
        yield px + shares[0] * patch.size[0], py + shares[1] * patch.size[1]


class EmptyPredicate(Predicate[Empty]):
    """No footprint overlaps the patch."""

    def evaluate(self, node: Empty, state: BlockState) -> Verdict:
        edge = state.world.edge
        return every([holds(footprint_gap(state, name, node.patch) / edge[name]) for name in state.position])

    def near_misses(self, node: Empty, state: BlockState, rng: Random) -> Iterator[NearMiss]:
        px, py, _ = state.where(node.patch)
        patch = state.world.patches[node.patch]
        for a in list(state.position)[:2]:
            x, y, _ = state.position[a]
            load = carried(state, a)
            yield NearMiss(f"{a} on {node.patch}", shift(state, load, px - x, py - y))
            edge = patch.size[1] / 2 + reach(state, a)[1] - PAST
            yield NearMiss(f"{a} over the edge of {node.patch}", shift(state, load, px - x, py + edge - y))

    def english(self, node: Empty, world: World) -> str:
        return f"{phrase(node.patch, world)} is empty"


TABLE: dict[str, Predicate[Any]] = {"on_patch": OnPatchPredicate(), "empty": EmptyPredicate()}
