"""stack: blocks one on the other, from the table up."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from itertools import pairwise
from random import Random
from typing import Any

from rpg.blocks.centres import Centres, Mask
from rpg.blocks.constants import SUPPORT_GAP
from rpg.blocks.geometry import rests_on, table_gap
from rpg.blocks.predicate import Cluster, NearMiss, Predicate
from rpg.blocks.predicates.common import TILT, set_aside, shift, stand_on, strangers, swap
from rpg.blocks.predicates.order import fixed_edges, ordered, sequences, swaps
from rpg.blocks.predicates.patches import on_patch
from rpg.blocks.predicates.plainly import off, piled
from rpg.blocks.predicates.reading import legible, unreadable
from rpg.blocks.predicates.vertical import DIRECTLY, GROUND, directly_on
from rpg.blocks.state import BlockState, Quat, Vec3, World, yaw_quat
from rpg.blocks.traits import TO_VIEWER, UP, Traits, symbols_shown
from rpg.blocks.verdict import FALSE, TRUE, Verdict, at_most, every, holds
from rpg.ir.structures import Stack

YAWS = (0.0, 0.35, -0.6)
"""Turns about the vertical (radians) that stacks are offered in."""


def chain(state: BlockState, upward: Sequence[str], raised: bool = False) -> Verdict:
    """Each block directly on the one below it, the lowest on the table unless the stack may be `raised`."""
    foot = upward[0]
    parts = [holds(1.0 - state.tilt(foot) / TILT)]
    if not raised:
        parts.append(at_most(abs(table_gap(state, foot)), SUPPORT_GAP))
    parts += [directly_on(a, b, state) for b, a in pairwise(upward)]
    return every(parts)


def alone(state: BlockState, upward: Sequence[str], covered: Sequence[str] = ()) -> Verdict:
    """Nothing but the stack itself rests on its blocks, but for those `covered` by another condition."""
    for other in strangers(state, upward):
        if any(rests_on(state, other, name) for name in upward if name not in covered):
            return FALSE
    return TRUE


def column(upward: Sequence[str], world: World, turn: Quat, excused: Iterable[str] = ()) -> Cluster:
    """A cluster of blocks centred one on the other; those `excused` may be turned in any way."""
    poses: dict[str, tuple[Vec3, Quat | None]] = {}
    height = 0.0
    for name in upward:
        edge = world.edge[name]
        poses[name] = ((0.0, 0.0, height + edge / 2), None if name in excused else turn)
        height += edge
    return Cluster(poses)


def upwards(node: Stack, sequence: Sequence[str]) -> list[str]:
    """A sequence in the stack's order, bottom to top."""
    return list(sequence)[::-1] if node.order.first == "top" else list(sequence)


class StackPredicate(Predicate[Stack]):
    """Bottom to top by height, each directly on the one below."""

    def evaluate(self, node: Stack, state: BlockState) -> Verdict:
        upward = sorted(node.blocks, key=lambda name: state.position[name][2])
        parts = [chain(state, upward, node.raised)]
        if node.order.by != "any":
            traits = Traits(state.world, symbols_shown(state, node.blocks, TO_VIEWER))
            parts.append(ordered(node.order, upwards(node, upward), traits, self._either(node)))
        if node.exact:
            parts.append(alone(state, upward))
        if node.patch is not None:
            parts.append(on_patch(upward[0], state.world.patches[node.patch], state))
        if node.readable:
            parts.append(legible(state, upward, TO_VIEWER, UP, node.excused))
        return every(parts)

    def holds(self, node: Stack, state: BlockState) -> bool:
        position, edge = state.position, state.world.edge
        upward = sorted(node.blocks, key=lambda name: position[name][2])
        for below, above in pairwise(upward):
            reach = DIRECTLY.offset_edges * max(edge[below], edge[above]) + DIRECTLY.slack
            if off(state, above, below, reach, DIRECTLY.gap):
                return False
        return self.evaluate(node, state).value

    def perhaps(self, node: Stack, many: Centres) -> Mask:
        return piled(many, node.blocks, DIRECTLY)

    def _either(self, node: Stack) -> bool:
        return node.order.by == "rainbow" and node.order.first is None

    def build(self, node: Stack, world: World, rng: Random) -> Iterator[list[Cluster]]:
        for sequence in self._sequences(node, world, rng):
            for yaw in YAWS[:1] if node.readable else YAWS:
                yield [column(upwards(node, sequence), world, yaw_quat(yaw), node.excused)]

    def _sequences(self, node: Stack, world: World, rng: Random) -> Iterator[list[str]]:
        for sequence in sequences(node.order, self._natural(node, world), Traits(world), rng):
            yield sequence
            if self._either(node):
                yield sequence[::-1]

    def _natural(self, node: Stack, world: World) -> list[str]:
        """Larger blocks below smaller ones where the order leaves it open."""
        return sorted(node.blocks, key=lambda name: -world.edge[name])

    def propose(self, node: Stack, block: str, state: BlockState, rng: Random) -> Iterator[tuple[float, float]]:
        if node.patch is not None:
            x, y, _ = state.where(node.patch)
            yield x, y

    def supports(self, node: Stack, world: World) -> Iterable[tuple[str, str]]:
        sequence = fixed_edges(node.order, node.blocks, Traits(world))
        if sequence is not None:
            upward = upwards(node, sequence)
            if not node.raised:
                yield upward[0], GROUND
            yield from zip(upward[1:], upward, strict=False)

    def near_misses(self, node: Stack, state: BlockState, rng: Random) -> Iterator[NearMiss]:
        upward = sorted(node.blocks, key=lambda name: state.position[name][2])
        top, foot = upward[-1], upward[0]
        edge = max(state.world.edge[name] for name in upward[-2:])
        if len(upward) > 1:
            yield NearMiss(f"{top} set down on the table", set_aside(state, top))
            yield NearMiss(f"{top} past the edge of what is below it", shift(state, [top], 0.0, edge * 0.5 + 0.006))
            yield NearMiss(f"{top} floating above the stack", shift(state, [top], 0.0, 0.0, 0.02))
        sequence = upwards(node, upward)
        for a, b in swaps(node.order, sequence, Traits(state.world), self._either(node)):
            yield NearMiss(f"{a} and {b} exchanged", swap(state, a, b))
        others = strangers(state, upward)
        if node.exact and others:
            yield NearMiss(f"{others[0]} on top of the stack", stand_on(state, others[0], top))
        if node.patch is not None:
            yield NearMiss("the stack beside the patch", self._off_patch(node, foot, state))
        if node.readable:
            yield from unreadable(state, upward, TO_VIEWER, UP, node.excused)

    def _off_patch(self, node: Stack, foot: str, state: BlockState) -> BlockState:
        patch = state.world.patches[str(node.patch)]
        x, y, _ = state.where(patch.name)
        fx, fy, _ = state.position[foot]
        sign = 1.0 if y <= 0.0 else -1.0
        dy = y + sign * (patch.size[1] / 2 + state.world.edge[foot]) - fy
        return shift(state, node.blocks, x - fx, dy)


TABLE: dict[str, Predicate[Any]] = {"stack": StackPredicate()}
