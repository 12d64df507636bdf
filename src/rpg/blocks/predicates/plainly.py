"""What a glance at the centres of blocks rules out, for judging many states: cheap, and never wrong where it says no.
For one state, and for many at once.

The lowest and the highest point of a block of edge e are at least e / 2 from its centre.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from rpg.blocks.centres import Centres, Mask, Numbers
from rpg.blocks.constants import SUPPORT_GAP
from rpg.blocks.state import BlockState
from rpg.ir.node import Axis, Slope
from rpg.ir.relations import On
from rpg.ir.structures import Row

STRETCH = 1.35
"""The extent of a cube along the vertical, over its edge, is less as long as it is tilted by 15 degrees at most."""
DIAGONAL = 1.7321
"""The extent of a cube along the vertical, over its edge, at most, whichever way it is turned."""
CORNER = 0.1
"""A step along a row is longer than the step aside by more than this, in edges: three blocks in an L are no row."""
ROOM = 1e-4
"""Room (m) for the rounding of tolerances."""


def uneven(state: BlockState, names: Sequence[str]) -> bool:
    """Do these blocks not stand at one height, each tilted little?"""
    position, edge = state.position, state.world.edge
    heights = [position[name][2] for name in names]
    spread = max(heights) - min(heights)
    if spread <= SUPPORT_GAP:
        return False
    edges = [edge[name] for name in names]
    return spread > SUPPORT_GAP + (STRETCH * max(edges) - min(edges)) / 2 + ROOM


def even(many: Centres, names: Sequence[str]) -> Mask:
    """The states in which these blocks are not uneven."""
    _, _, z = many.of(names)
    edges = many.edges(names)
    level: Mask = z.max(axis=1) - z.min(axis=1) <= SUPPORT_GAP + (STRETCH * edges.max() - edges.min()) / 2 + ROOM
    return level


def spreads(x: Numbers, y: Numbers) -> tuple[Numbers, Numbers, Numbers]:
    """Of points about their middle, a row a state: the sums of the squared distances along the line that fits them best
    and across it, and the angle of that line to the x axis."""
    xx, yy, xy = (x * x).sum(axis=1), (y * y).sum(axis=1), (x * y).sum(axis=1)
    middle, half = (xx + yy) / 2, np.hypot((xx - yy) / 2, xy)
    return middle + half, np.maximum(middle - half, 0.0), 0.5 * np.arctan2(2.0 * xy, xx - yy)


def about_middle(many: Centres, names: Sequence[str]) -> tuple[Numbers, Numbers]:
    """x and y of these blocks from the middle of them all."""
    x, y, _ = many.of(names)
    return x - x.mean(axis=1, keepdims=True), y - y.mean(axis=1, keepdims=True)


def straight(many: Centres, row: Row, names: Sequence[str], axis: Axis | Slope | None) -> Mask:
    """The states in which these blocks may stand at one height and in one line, with the tolerances of `row`, along an
    axis if there is one; a diagonal is no hindrance."""
    edge = many.edges(names).max()
    x, y = about_middle(many, names)
    long, short, angle = spreads(x, y)
    ux, uy = np.cos(angle)[:, None], np.sin(angle)[:, None]
    along, off = x * ux + y * uy, y * ux - x * uy
    rank = along.argsort(axis=1)
    steps, asides = (np.diff(np.take_along_axis(values, rank, axis=1), axis=1) for values in (along, off))
    line = many.all()
    line &= abs(off).max(axis=1) <= row.line_edges * edge + ROOM
    line &= (steps - abs(asides) >= CORNER * edge - ROOM).all(axis=1)
    if axis in ("x", "y") and len(names) > 1:
        across, forward = (ux, uy) if axis == "y" else (uy, ux)
        line &= (np.arctan2(abs(across), abs(forward)) <= math.radians(row.angle + 0.01)).all(axis=1)
    # no line is the best one by much where the blocks lie as far across it as along it
    return even(many, names) & (line | (long - short <= 1e-6 * long))


def piled(many: Centres, names: Sequence[str], link: On) -> Mask:
    """The states in which these blocks may stand one on the other, within the tolerances of `link`."""
    x, y, z = many.of(names)
    upward = z.argsort(axis=1, kind="stable")
    edges = many.edges(names)[upward]
    places = [np.take_along_axis(values, upward, axis=1) for values in (x, y, z)]
    below, above = [values[:, :-1] for values in places], [values[:, 1:] for values in places]
    one, other = edges[:, :-1], edges[:, 1:]
    reach = link.offset_edges * np.maximum(one, other) + link.slack
    found: Mask = np.logical_and.reduce(perhaps_on(above, below, (one + other) / 2, reach, link.gap), axis=1)
    return found


def off(state: BlockState, a: str, b: str, reach: float, gap: float) -> bool:
    """Is `a` not on `b`, whichever way both are turned: its centre farther than `reach` (m) from that of `b` in the
    plane, or at another height than that of a block at most `gap` (m) from the top of `b`?"""
    (ax, ay, az), (bx, by, bz) = state.position[a], state.position[b]
    apart = (state.world.edge[a] + state.world.edge[b]) / 2
    if not apart - gap - ROOM <= az - bz <= DIAGONAL * apart + gap + ROOM:
        return True
    return (ax - bx) ** 2 + (ay - by) ** 2 > (reach + ROOM) ** 2


def perhaps_on(a: Sequence[Numbers], b: Sequence[Numbers], apart: Numbers, reach: Numbers, gap: float) -> Mask:
    """Where blocks are not `off`: of x, y and z each, and half the sum of their edges, in arrays of one shape."""
    (ax, ay, az), (bx, by, bz) = a, b
    rise = az - bz
    level = (rise >= apart - gap - ROOM) & (rise <= DIAGONAL * apart + gap + ROOM)
    near: Mask = level & ((ax - bx) ** 2 + (ay - by) ** 2 <= (reach + ROOM) ** 2)
    return near


def layers(state: BlockState, names: Sequence[str]) -> list[int] | None:
    """How many blocks are at each level over the lowest, as far as their centres tell; None where they do not."""
    position, edge = state.position, state.world.edge
    size = edge[names[0]]
    if SUPPORT_GAP + (STRETCH - 1.0) * size / 2 > 0.49 * size or any(edge[name] != size for name in names):
        return None
    heights = [position[name][2] for name in names]
    lowest = min(heights)
    found: list[int] = []
    for height in heights:
        level = round((height - lowest) / size)
        found += [0] * (level + 1 - len(found))
        found[level] += 1
    return found


def layered(many: Centres, names: Sequence[str], wanted: Sequence[Sequence[int]]) -> Mask:
    """The states in which the numbers of blocks at each level, as `layers` counts them, are among those wanted."""
    edges = many.edges(names)
    size = edges[0]
    if SUPPORT_GAP + (STRETCH - 1.0) * size / 2 > 0.49 * size or (edges != size).any():
        return many.all()
    _, _, z = many.of(names)
    levels = np.rint((z - z.min(axis=1, keepdims=True)) / size)
    found = many.none()
    for counts in {tuple(counts) for counts in wanted}:
        each = [(levels == level).sum(axis=1) == count for level, count in enumerate(counts)]
        found |= np.logical_and.reduce(each)
    return found
