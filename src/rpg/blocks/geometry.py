"""Footprints, gaps and support: the plane and solid geometry that predicates share. Pure Python floats, metres.

Gaps are signed: negative is the depth of an overlap.
"""

from __future__ import annotations

import math
from collections.abc import Iterator

from rpg.blocks.constants import SUPPORT_GAP, TABLE_Z
from rpg.blocks.state import BlockState, Matrix, Vec3
from rpg.ir.assets import GoalPatch

Point = tuple[float, float]
Polygon = tuple[Point, ...]

LEVEL_EPS = 1e-6
OVERLAP_EPS = 1e-4
"""Footprints that overlap by less than this (m) merely touch."""


def is_level(state: BlockState, name: str) -> bool:
    """Does the block lie flat on one of its faces, to numerical precision?"""
    return _flat(state.axes(name))


def _flat(axes: Matrix) -> bool:
    x, y, z = axes[2]
    return abs(z) > 1.0 - LEVEL_EPS or abs(x) > 1.0 - LEVEL_EPS or abs(y) > 1.0 - LEVEL_EPS


def corners(state: BlockState, name: str) -> list[Vec3]:
    """The eight corners of a block in the world."""
    return _corners(state.position[name], state.world.edge[name] / 2, state.axes(name))


def _corners(place: Vec3, h: float, axes: Matrix) -> list[Vec3]:
    (xx, xy, xz), (yx, yy, yz), (zx, zy, zz) = axes
    x, y, z = place
    return [
        (x + h * (a * xx + b * xy + c * xz), y + h * (a * yx + b * yy + c * yz), z + h * (a * zx + b * zy + c * zz))
        for a in (-1, 1)
        for b in (-1, 1)
        for c in (-1, 1)
    ]


def footprint(state: BlockState, name: str) -> Polygon:
    """Outline of the block's shadow on the table, counter-clockwise; of a patch, its outline (a circle as 24 sides)."""
    patch = state.world.patches.get(name)
    if patch is not None:
        return patch_outline(patch)
    return shadow(state.position[name], state.world.edge[name] / 2, state.axes(name))


def shadow(place: Vec3, h: float, axes: Matrix) -> Polygon:
    """The outline of the shadow of a block whose centre is at a place, with half of its edge and its axes."""
    if not _flat(axes):
        return hull([(x, y) for x, y, _ in _corners(place, h, axes)])
    x, y, _ = place
    # Two of the block's axes lie in the plane; either one gives the square.
    k = 0 if abs(axes[2][0]) < 0.5 else 1
    ux, uy = h * axes[0][k], h * axes[1][k]
    s, d = ux + uy, ux - uy
    return (x + d, y + s), (x - s, y + d), (x - d, y - s), (x + s, y - d)


def patch_outline(patch: GoalPatch) -> Polygon:
    """The outline of a patch that has its position."""
    if patch.position is None:
        raise ValueError(f"the patch {patch.name!r} has no position yet")
    if patch.shape != "circle":
        return rectangle(patch.position, patch.size)
    (x, y), radius = patch.position, patch.size[0] / 2
    turns = [2 * math.pi * k / 24 for k in range(24)]
    return tuple((x + radius * math.cos(t), y + radius * math.sin(t)) for t in turns)


def rectangle(middle: Point, size: Point) -> Polygon:
    """The outline of a rectangle along the axes, counter-clockwise."""
    (x, y), hx, hy = middle, size[0] / 2, size[1] / 2
    return (x + hx, y + hy), (x - hx, y + hy), (x - hx, y - hy), (x + hx, y - hy)


def hull(points: list[Point]) -> Polygon:
    """Convex hull, counter-clockwise."""
    ordered = sorted(set(points))
    lower, upper = _chain(ordered), _chain(ordered[::-1])
    return tuple(lower[:-1] + upper[:-1])


def _chain(points: list[Point]) -> list[Point]:
    chain: list[Point] = []
    for p in points:
        while len(chain) >= 2 and _turn(chain[-2], chain[-1], p) <= 1e-12:
            chain.pop()
        chain.append(p)
    return chain


def _turn(a: Point, b: Point, c: Point) -> float:
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])


def polygon_gap(p: Polygon, q: Polygon) -> float:
    """Signed distance between two convex polygons."""
    separation = polygon_separation(p, q)
    if separation <= 0.0:
        return separation
    return min(_vertex_distance(p, q), _vertex_distance(q, p))


def clear_of(p: Polygon, q: Polygon, gap: float) -> bool:
    """Are two convex polygons at least so far apart? Most are by their least extents along the axes alone."""
    (px, py), (qx, qy) = zip(*p, strict=True), zip(*q, strict=True)
    beside = max(min(px) - max(qx), min(qx) - max(px), min(py) - max(qy), min(qy) - max(py))
    return beside >= gap or polygon_gap(p, q) >= gap


def polygon_separation(p: Polygon, q: Polygon) -> float:
    """Greatest distance between two convex polygons along the normal of an edge: at most their gap, and of its sign."""
    return max(_separation(p, q), _separation(q, p))


def _separation(p: Polygon, q: Polygon) -> float:
    """Greatest distance of `q` beyond the line of an edge of `p`; negative when every edge cuts `q`."""
    best = -math.inf
    ax, ay = p[-1]
    for bx, by in p:
        ex, ey = bx - ax, by - ay
        length = math.hypot(ex, ey)
        if length > 0.0:
            nx, ny = ey / length, -ex / length
            beyond = min([(x - ax) * nx + (y - ay) * ny for x, y in q])
            if beyond > best:
                best = beyond
        ax, ay = bx, by
    return best


def _vertex_distance(p: Polygon, q: Polygon) -> float:
    """Least distance from a vertex of `p` to an edge of `q`."""
    best = math.inf
    ax, ay = q[-1]
    for bx, by in q:
        ex, ey = bx - ax, by - ay
        square = ex * ex + ey * ey
        for x, y in p:
            t = max(0.0, min(1.0, ((x - ax) * ex + (y - ay) * ey) / square)) if square else 0.0
            best = min(best, math.hypot(x - ax - t * ex, y - ay - t * ey))
        ax, ay = bx, by
    return best


def footprint_gap(state: BlockState, a: str, b: str) -> float:
    """Signed horizontal gap between the footprints of two blocks or patches."""
    u, v = heading(state, a), heading(state, b)
    if u is None or v is None:
        return polygon_gap(footprint(state, a), footprint(state, b))
    ax, ay, _ = state.position[a]
    bx, by, _ = state.position[b]
    edge = state.world.edge
    return square_gap((bx - ax, by - ay), u, edge[a] / 2, v, edge[b] / 2)


def heading(state: BlockState, name: str) -> Point | None:
    """A unit vector along the sides of a block's square footprint; None for patches and blocks that are not level."""
    return sides(state.axes(name)) if name in state.position else None


def sides(axes: Matrix) -> Point | None:
    """A unit vector along the sides of the square that a block with these axes covers; None where it is not level."""
    (xx, xy, _), (yx, yy, _), (zx, zy, zz) = axes
    if abs(zz) > 1.0 - LEVEL_EPS or abs(zy) > 1.0 - LEVEL_EPS:
        return xx, yx
    return (xy, yy) if abs(zx) > 1.0 - LEVEL_EPS else None


def square_separation(offset: Point, u: Point, h: float, v: Point, k: float) -> float:
    """As `polygon_separation`, of two squares of half sides `h` and `k` along `u` and `v`, the second at `offset`."""
    (dx, dy), (ux, uy), (vx, vy) = offset, u, v
    widening = abs(ux * vx + uy * vy) + abs(ux * vy - uy * vx)
    along = max(abs(dx * ux + dy * uy), abs(dy * ux - dx * uy)) - h - k * widening
    across = max(abs(dx * vx + dy * vy), abs(dy * vx - dx * vy)) - k - h * widening
    return along if along > across else across


def square_gap(offset: Point, u: Point, h: float, v: Point, k: float) -> float:
    """Signed gap between two squares of half sides `h` and `k` along `u` and `v`, the second at `offset`."""
    (dx, dy), (ux, uy), (vx, vy) = offset, u, v
    a, b = dx * ux + dy * uy, dy * ux - dx * uy
    c, d = dx * vx + dy * vy, dy * vx - dx * vy
    cos, sin = ux * vx + uy * vy, ux * vy - uy * vx
    widening = abs(cos) + abs(sin)
    separation = max(max(abs(a), abs(b)) - h - k * widening, max(abs(c), abs(d)) - k - h * widening)
    if separation <= 0.0:
        return separation
    if widening < 1.0 + 1e-9:
        return math.hypot(max(0.0, abs(a) - h - k), max(0.0, abs(b) - h - k))
    return min(_corner_gap(a, b, h, k * cos, k * sin), _corner_gap(c, d, k, h * cos, -h * sin))


def _corner_gap(x: float, y: float, h: float, c: float, s: float) -> float:
    """Least distance to a square of half side `h` at the origin from the corners of one at (x, y) turned by (c, s)."""
    corners = ((x + c - s, y + s + c), (x - c - s, y - s + c), (x - c + s, y - s - c), (x + c + s, y + s - c))
    return min([math.hypot(max(0.0, abs(px) - h), max(0.0, abs(py) - h)) for px, py in corners])


def body_gap(state: BlockState, a: str, b: str) -> float:
    """Signed distance between the bodies of two blocks."""
    if is_level(state, a) and is_level(state, b):
        across = footprint_gap(state, a, b)
        up = max(state.bottom(a) - state.top(b), state.bottom(b) - state.top(a))
        return math.hypot(across, up) if across > 0.0 and up > 0.0 else max(across, up)
    return _box_gap(state, a, b)


def plainly_apart(state: BlockState, a: str, b: str, distance: float) -> bool:
    """Is the gap between two blocks more than `distance`, whichever way they are turned? A cube fits into a ball less
    than 1.7321 as wide as its edge."""
    reach = 1.7321 * (state.world.edge[a] + state.world.edge[b]) / 2
    return math.dist(state.position[a], state.position[b]) > reach + distance + OVERLAP_EPS


def _box_gap(state: BlockState, a: str, b: str) -> float:
    """Distance between two turned cubes: separating axes, then corners to boxes and edges to edges."""
    separation = _box_separation(state, a, b)
    if separation <= 0.0:
        return separation
    best = min(_corners_to_box(state, a, b), _corners_to_box(state, b, a))
    edges_a, edges_b = list(_edges(state, a)), list(_edges(state, b))
    return min(best, min(_segment_distance(p, q, r, s) for p, q in edges_a for r, s in edges_b))


def _columns(state: BlockState, name: str) -> list[Vec3]:
    rows = state.axes(name)
    return [(rows[0][k], rows[1][k], rows[2][k]) for k in range(3)]


def _box_separation(state: BlockState, a: str, b: str) -> float:
    axes_a, axes_b = _columns(state, a), _columns(state, b)
    crosses = [_cross(u, v) for u in axes_a for v in axes_b]
    best = -math.inf
    corners_a, corners_b = corners(state, a), corners(state, b)
    for axis in axes_a + axes_b + crosses:
        length = math.sqrt(_dot(axis, axis))
        if length < 1e-6:
            continue
        on_a = [_dot(axis, c) / length for c in corners_a]
        on_b = [_dot(axis, c) / length for c in corners_b]
        best = max(best, min(on_a) - max(on_b), min(on_b) - max(on_a))
    return best


def _corners_to_box(state: BlockState, a: str, b: str) -> float:
    h = state.world.edge[b] / 2
    centre, axes = state.position[b], _columns(state, b)
    best = math.inf
    for corner in corners(state, a):
        offset = _minus(corner, centre)
        beyond = [max(0.0, abs(_dot(offset, axis)) - h) for axis in axes]
        best = min(best, math.sqrt(sum(d * d for d in beyond)))
    return best


def _edges(state: BlockState, name: str) -> Iterator[tuple[Vec3, Vec3]]:
    points = corners(state, name)
    for i in range(8):
        for bit in (1, 2, 4):
            if not i & bit:
                yield points[i], points[i | bit]


def _segment_distance(p: Vec3, q: Vec3, r: Vec3, s: Vec3) -> float:
    u, v, w = _minus(q, p), _minus(s, r), _minus(p, r)
    a, b, c, d, e = _dot(u, u), _dot(u, v), _dot(v, v), _dot(u, w), _dot(v, w)
    denominator = a * c - b * b
    t = _clamp((b * e - c * d) / denominator) if denominator > 1e-15 else 0.0
    k = _clamp((b * t + e) / c)
    t = _clamp((b * k - d) / a)
    gap = tuple(w[i] + t * u[i] - k * v[i] for i in range(3))
    return math.sqrt(sum(g * g for g in gap))


def _clamp(t: float) -> float:
    return max(0.0, min(1.0, t))


def _dot(a: Vec3, b: Vec3) -> float:
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def _cross(a: Vec3, b: Vec3) -> Vec3:
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def _minus(a: Vec3, b: Vec3) -> Vec3:
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2])


def plane_distance(state: BlockState, a: str, b: str) -> float:
    """Horizontal distance between the centres of two blocks or patches."""
    ax, ay, _ = state.where(a)
    bx, by, _ = state.where(b)
    return math.hypot(ax - bx, ay - by)


def table_gap(state: BlockState, name: str) -> float:
    """Height of the block's lowest point over the table top."""
    return state.bottom(name) - TABLE_Z


def rests_on(state: BlockState, a: str, b: str) -> bool:
    """Does part of `a` rest on `b`: bottom within a centimetre of its top, footprints overlapping?"""
    return abs(state.bottom(a) - state.top(b)) <= SUPPORT_GAP and _overlap(state, a, b)


def _overlap(state: BlockState, a: str, b: str) -> bool:
    """Does one of the two blocks stand over part of the other?"""
    halves, way = (state.world.edge[a] + state.world.edge[b]) / 2, plane_distance(state, a, b)
    # the shadow of a cube holds a circle as wide as its edge, whichever way it is turned, and is less than 1.75 as wide
    if way < halves - 2 * OVERLAP_EPS:
        return True
    if way >= halves * 1.75:
        return False
    return footprint_gap(state, a, b) < -OVERLAP_EPS


def supporters(state: BlockState, name: str) -> list[str]:
    """The blocks that `name` rests on."""
    bottom = state.bottom(name)
    return [
        other
        for other in state.position
        if abs(bottom - state.top(other)) <= SUPPORT_GAP and other != name and _overlap(state, name, other)
    ]


def riders(state: BlockState, name: str) -> list[str]:
    """The blocks that rest on `name`."""
    top = state.top(name)
    return [
        other
        for other in state.position
        if abs(state.bottom(other) - top) <= SUPPORT_GAP and other != name and _overlap(state, other, name)
    ]


def carried(state: BlockState, name: str) -> list[str]:
    """The block with everything that rests on it, directly or not."""
    found = [name]
    for block in found:
        found += [rider for rider in riders(state, block) if rider not in found]
    return found


def reach(state: BlockState, name: str) -> tuple[float, float]:
    """Half of the extent along x and y of a block's or a patch's footprint."""
    outline = footprint(state, name)
    x, y, _ = state.where(name)
    return max(abs(u - x) for u, _ in outline), max(abs(v - y) for _, v in outline)


def grounded(state: BlockState, name: str) -> bool:
    """Does the block rest on the table, or on blocks that do?"""
    frontier, seen = [name], {name}
    while frontier:
        block = frontier.pop()
        if abs(table_gap(state, block)) <= SUPPORT_GAP:
            return True
        below = [b for b in supporters(state, block) if b not in seen]
        seen.update(below)
        frontier.extend(below)
    return False
