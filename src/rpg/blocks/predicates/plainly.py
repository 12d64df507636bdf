"""What a glance at the centres of blocks rules out, for judging many states: cheap, and never wrong where it says no.

The lowest and the highest point of a block of edge e are at least e / 2 from its centre.
"""

from __future__ import annotations

from collections.abc import Sequence

from rpg.blocks.constants import SUPPORT_GAP
from rpg.blocks.state import BlockState

STRETCH = 1.35
"""The extent of a cube along the vertical, over its edge, is less as long as it is tilted by 15 degrees at most."""
DIAGONAL = 1.7321
"""The extent of a cube along the vertical, over its edge, at most, whichever way it is turned."""
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


def off(state: BlockState, a: str, b: str, reach: float, gap: float) -> bool:
    """Is `a` not on `b`, whichever way both are turned: its centre farther than `reach` (m) from that of `b` in the
    plane, or at another height than that of a block at most `gap` (m) from the top of `b`?"""
    (ax, ay, az), (bx, by, bz) = state.position[a], state.position[b]
    apart = (state.world.edge[a] + state.world.edge[b]) / 2
    if not apart - gap - ROOM <= az - bz <= DIAGONAL * apart + gap + ROOM:
        return True
    return (ax - bx) ** 2 + (ay - by) ** 2 > (reach + ROOM) ** 2


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
