"""What the structure predicates share: how flat and how level blocks lie, and the changes that near-misses make."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from rpg.blocks.constants import SUPPORT_GAP, TABLE_Z, WORKSPACE_X, WORKSPACE_Y
from rpg.blocks.geometry import carried, footprint_gap, heading, square_gap
from rpg.blocks.state import IDENTITY, BlockState, Quat, Vec3, product, yaw_quat
from rpg.ir.assets import EDGE

TILT = 15.0
"""A block of a structure is not tilted more than this (degrees)."""
BUILD_GAP = 0.01
"""Face gap in metres that is left between blocks that need not touch, so that a gripper can place them."""
PAST = 0.004
"""How far past a tolerance near-misses lie, in metres."""
PAST_SHARE = 1.35
"""Where a near-miss lies at a multiple of a tolerance, this one."""
TOUCH = 0.002
"""Faces at most this far apart (m) touch."""
BORDER = 0.01
"""Goal states keep this far inside of the workspace (m)."""
SPANS = {"x": WORKSPACE_X[1] - WORKSPACE_X[0] - 2 * BORDER, "y": WORKSPACE_Y[1] - WORKSPACE_Y[0] - 2 * BORDER}
"""The longest a structure may be between its outer centres, in metres."""

Poses = dict[str, tuple[Vec3, Quat]]


class Line(NamedTuple):
    """Blocks along their best line, from left to right or from front to back.

    `sequence` by position along it, `along` those positions and `off` the distances from it (m, signed), `direction`
    the unit vector of the line.
    """

    sequence: list[str]
    along: list[float]
    off: list[float]
    direction: tuple[float, float]


def slack(value: float, limit: float) -> float:
    """Margin of "`value` is at most `limit`", over the limit (over one, where that is zero)."""
    return (limit - value) / (limit or 1.0)


def flatness(state: BlockState, names: Iterable[str]) -> float:
    """Margin of "none of these is tilted more than 15 degrees"."""
    return 1.0 - state.tilt(*names) / TILT


def levelness(state: BlockState, names: Sequence[str]) -> float:
    """Margin of "these stand at one height", within a centimetre."""
    bottoms = [state.bottom(name) for name in names]
    return 1.0 - (max(bottoms) - min(bottoms)) / SUPPORT_GAP


def largest_edge(state: BlockState, names: Iterable[str]) -> float:
    """The edge that tolerances of a whole structure are measured in."""
    edge = state.world.edge
    return max((edge[name] for name in names), default=EDGE)


def shift(state: BlockState, names: Iterable[str], dx: float, dy: float, dz: float = 0.0) -> BlockState:
    """`state` with some blocks moved by an offset in metres."""
    poses: Poses = {}
    for name in names:
        x, y, z = state.position[name]
        poses[name] = ((x + dx, y + dy, z + dz), state.orientation.get(name, IDENTITY))
    return state.moved(poses)


def place_beside(state: BlockState, a: str, b: str, dx: float, dy: float) -> BlockState:
    """`state` with `a` at an offset from `b`, and what it carries; `b` is moved where `a` cannot be, or carries it."""
    (ax, ay, _), (bx, by, _) = state.where(a), state.where(b)
    load = carried(state, a) if a in state.position else []
    if load and b not in load:
        return shift(state, load, bx + dx - ax, by + dy - ay)
    return shift(state, carried(state, b), ax - dx - bx, ay - dy - by)


def swap(state: BlockState, a: str, b: str) -> BlockState:
    """`state` with two blocks exchanged; heights are kept apart where their edges differ."""
    lift = (state.world.edge[a] - state.world.edge[b]) / 2
    (ax, ay, az), (bx, by, bz) = state.position[a], state.position[b]
    turn = state.orientation
    poses: Poses = {
        a: ((bx, by, bz + lift), turn.get(b, IDENTITY)),
        b: ((ax, ay, az - lift), turn.get(a, IDENTITY)),
    }
    return state.moved(poses)


def put(state: BlockState, name: str, position: Vec3, orientation: Quat = IDENTITY) -> BlockState:
    """`state` with one block at a pose."""
    return state.moved({name: (position, orientation)})


def spin(
    state: BlockState, names: Iterable[str], degrees: float, about: tuple[float, float] | None = None
) -> BlockState:
    """`state` with blocks turned about the vertical through `about`, or each through its own centre."""
    angle = math.radians(degrees)
    c, s = math.cos(angle), math.sin(angle)
    poses: Poses = {}
    for name in names:
        x, y, z = state.position[name]
        if about is not None:
            dx, dy = x - about[0], y - about[1]
            x, y = about[0] + c * dx - s * dy, about[1] + s * dx + c * dy
        poses[name] = ((x, y, z), product(yaw_quat(angle), state.orientation.get(name, IDENTITY)))
    return state.moved(poses)


def tilted(state: BlockState, name: str, degrees: float) -> BlockState:
    """`state` with one block tipped about its own x axis, its lowest point where it was."""
    half = math.radians(degrees) / 2
    tip: Quat = (math.cos(half), math.sin(half), 0.0, 0.0)
    x, y, z = state.position[name]
    tipped = put(state, name, (x, y, z), product(tip, state.orientation.get(name, IDENTITY)))
    return put(tipped, name, (x, y, z + state.bottom(name) - tipped.bottom(name)), tipped.orientation[name])


def centroid(state: BlockState, names: Sequence[str]) -> tuple[float, float]:
    """Mean of the centres in the plane."""
    return (
        sum(state.position[n][0] for n in names) / len(names),
        sum(state.position[n][1] for n in names) / len(names),
    )


_SPOTS = [(WORKSPACE_X[0] + 0.05 * i, WORKSPACE_Y[0] + 0.05 * j) for i in range(7) for j in range(11)]
"""Places all over the workspace."""
_SPOTS_X, _SPOTS_Y = np.array(_SPOTS).T


def set_aside(state: BlockState, name: str, clearance: float = 0.12) -> BlockState:
    """`state` with one block flat on the table, away from every other block."""
    half = state.world.edge[name] / 2
    others = [(x, y) for other, (x, y, _) in state.position.items() if other != name]

    def room(spot: tuple[float, float]) -> float:
        a, b = spot
        return min([math.hypot(x - a, y - b) for x, y in others], default=1.0)

    spot = max(_roomiest(others), key=room)
    if room(spot) < clearance:
        spot = (spot[0], WORKSPACE_Y[1] + 0.2)
    return put(state, name, (spot[0], spot[1], TABLE_Z + half))


def _roomiest(others: list[tuple[float, float]]) -> list[tuple[float, float]]:
    """The spots with the most room, but for the last digits: found at once, so that few are measured one by one."""
    if not others:
        return _SPOTS
    x, y = np.array(others).T[:, :, None]
    least = ((_SPOTS_X - x) ** 2 + (_SPOTS_Y - y) ** 2).min(axis=0)
    return [_SPOTS[k] for k in np.flatnonzero(least >= least.max() * (1 - 1e-9))]


def stand_on(state: BlockState, name: str, support: str) -> BlockState:
    """`state` with one block centred on top of another."""
    x, y, _ = state.position[support]
    z = state.top(support) + state.world.edge[name] / 2
    return put(state, name, (x, y, z), state.orientation.get(support, IDENTITY))


def strangers(state: BlockState, names: Iterable[str]) -> list[str]:
    """Blocks of the state that are none of these."""
    inside = set(names)
    return [name for name in state.position if name not in inside]


def pair_edge(state: BlockState, a: str, b: str) -> float:
    """The larger edge of two blocks."""
    edge = state.world.edge
    return max(edge[a], edge[b])


def gaps_along(state: BlockState, sequence: Sequence[str]) -> list[float]:
    """Face gaps between neighbours of a sequence, metres."""
    ways = [way for name in sequence if (way := heading(state, name)) is not None]
    if len(ways) < len(sequence):
        return [footprint_gap(state, a, b) for a, b in pairwise(sequence)]
    position, edge = state.position, state.world.edge
    squares = [(*position[name][:2], way, edge[name] / 2) for name, way in zip(sequence, ways, strict=True)]
    return [square_gap((bx - ax, by - ay), u, h, v, k) for (ax, ay, u, h), (bx, by, v, k) in pairwise(squares)]
