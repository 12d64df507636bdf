"""Does a block keep its place by itself? Its centre must lie over what really carries it."""

from __future__ import annotations

from rpg.blocks.constants import TABLE_Z
from rpg.blocks.geometry import Point, Polygon, footprint, hull, supporters
from rpg.blocks.state import BlockState

CONTACT = 5e-4
"""A block is carried by what is within this of its lowest face (m)."""
INSET = 1e-3
"""A centre nearer than this to the edge of its support (m) is not safe."""


def stands(state: BlockState, name: str) -> bool:
    """Is the block carried by the table, or by blocks on more than one side of its centre?"""
    bottom = state.bottom(name)
    if abs(bottom - TABLE_Z) <= CONTACT:
        return True
    own = footprint(state, name)
    carried_by = [b for b in supporters(state, name) if abs(state.top(b) - bottom) <= CONTACT]
    points = [point for other in carried_by for point in overlap(own, footprint(state, other))]
    if len(points) < 3:
        return False
    x, y, _ = state.position[name]
    return inside(hull(points), (x, y)) >= INSET


def overlap(p: Polygon, q: Polygon) -> Polygon:
    """The part of `p` that lies in `q`; both convex and counter-clockwise."""
    points = list(p)
    ax, ay = q[-1]
    for bx, by in q:
        ex, ey = bx - ax, by - ay
        depths = [ex * (y - ay) - ey * (x - ax) for x, y in points]
        clipped: list[Point] = []
        for k, (x, y) in enumerate(points):
            (u, v), before = points[k - 1], depths[k - 1]
            if (before >= 0.0) != (depths[k] >= 0.0):
                share = before / (before - depths[k])
                clipped.append((u + share * (x - u), v + share * (y - v)))
            if depths[k] >= 0.0:
                clipped.append((x, y))
        points = clipped
        ax, ay = bx, by
    return tuple(points)


def inside(polygon: Polygon, point: Point) -> float:
    """Depth of a point in a convex counter-clockwise polygon; negative outside."""
    depth = float("inf")
    ax, ay = polygon[-1]
    for bx, by in polygon:
        ex, ey = bx - ax, by - ay
        length = (ex * ex + ey * ey) ** 0.5
        if length > 1e-9:
            depth = min(depth, (ex * (point[1] - ay) - ey * (point[0] - ax)) / length)
        ax, ay = bx, by
    return depth
