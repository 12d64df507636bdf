"""Laying out figures: pitch, turn, and what rests on what."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from functools import lru_cache

from rpg.blocks.figures import Cell, Ideal, ring_width, upright
from rpg.blocks.predicate import Cluster
from rpg.blocks.predicates.common import BUILD_GAP, SPANS
from rpg.blocks.state import IDENTITY, Quat, Vec3, World, yaw_quat
from rpg.ir.structures import Cells

TURNS = (0.0, math.pi / 2, 0.5)
"""Turns (radians) of figures that hold in any."""
LAYER_GAP = 0.005
"""Face gap in metres between blocks that others rest on."""


def layouts(node: Cells, ideal: Ideal, filled: Sequence[str], world: World) -> Iterator[Cluster]:
    """Ways to lay out a figure whose cells hold `filled`, the roomiest first; none where it is too large."""
    edge = max(world.edge[name] for name in filled)
    tangent = ideal.ring and not node.readable
    gap = BUILD_GAP if all(cell.level == 0 for cell in ideal.cells) else LAYER_GAP
    for turn in TURNS if ideal.limit is None and not (node.readable and upright(node)) else TURNS[:1]:
        for clearance in (gap, 0.5 * gap, 0.001, 0.0) if node.gap is None else (node.gap,):
            pitch = _pitch(ideal, edge, clearance, tangent)
            low, high = pitches(node, ideal, edge)
            pitch = max(pitch, low)
            places = _places(ideal.cells, pitch, turn)
            if pitch <= high and _fits(places):
                yield _cluster(node, ideal, filled, places, turn, tangent, world)
                break


def pitches(node: Cells, ideal: Ideal, edge: float) -> tuple[float, float]:
    """The least and the most (m) that the pitch of a figure may be."""
    low, high = node.pitch_edges
    asked = 0.0 if node.gap is None else edge + node.gap + node.tolerance
    return low * edge, max(high * edge, ideal.room or 0.0, asked)


@lru_cache(maxsize=512)
def _pitch(ideal: Ideal, edge: float, gap: float, tangent: bool) -> float:
    """The least pitch at which no two blocks of a level are nearer than `gap`."""
    count = len(ideal.cells)
    if tangent and count > 2:
        return max(ring_width(count, edge, gap) * math.sin(math.pi / count), edge + gap)
    least = edge + gap
    for i, a in enumerate(ideal.cells):
        for b in ideal.cells[:i]:
            if a.level == b.level:
                least = max(least, (edge + gap) / max(abs(a.x - b.x), abs(a.y - b.y)))
    return least


def _places(cells: Sequence[Cell], pitch: float, turn: float) -> list[tuple[float, float]]:
    c, s = pitch * math.cos(turn), pitch * math.sin(turn)
    return [(c * cell.x - s * cell.y, s * cell.x + c * cell.y) for cell in cells]


def _fits(places: Sequence[tuple[float, float]]) -> bool:
    """Are all centres inside of the workspace, for some place of the whole?"""
    xs, ys = [x for x, _ in places], [y for _, y in places]
    return max(xs) - min(xs) <= SPANS["x"] + 1e-9 and max(ys) - min(ys) <= SPANS["y"] + 1e-9


def _cluster(
    node: Cells,
    ideal: Ideal,
    filled: Sequence[str],
    places: Sequence[tuple[float, float]],
    turn: float,
    tangent: bool,
    world: World,
) -> Cluster:
    edge = max(world.edge[name] for name in filled)
    poses: dict[str, tuple[Vec3, Quat | None]] = {}
    for k, (name, cell, (x, y)) in enumerate(zip(filled, ideal.cells, places, strict=True)):
        yaw = turn - 2 * math.pi * k / len(filled) if tangent else turn
        yaw = math.remainder(yaw, math.pi / 2)
        quat = IDENTITY if node.readable or abs(yaw) < 1e-9 else yaw_quat(yaw)
        z = cell.level * edge + world.edge[name] / 2
        poses[name] = ((x, y, z), None if name in node.excused else quat)
    return Cluster(poses)


@lru_cache(maxsize=512)
def resting(ideal: Ideal) -> tuple[tuple[int, int | None], ...]:
    """Which cell of a figure rests on which (None: the table), by index."""
    cells = ideal.cells
    found: list[tuple[int, int | None]] = []
    for k, cell in enumerate(cells):
        if cell.level == 0:
            found.append((k, None))
        for j, below in enumerate(cells):
            near = max(abs(cell.x - below.x), abs(cell.y - below.y)) < 0.75
            if below.level == cell.level - 1 and near:
                found.append((k, j))
    return tuple(found)
