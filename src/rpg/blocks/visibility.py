"""What the viewer can see and read of a block's faces. Pure Python: no physics engine is asked.

A glyph on TOP is upright when its up-direction is +x, on a side face when it is +z (BOTTOM as TOP), in the block's
own frame. A face is readable when its normal lies within a cosine of the expected viewing direction and its glyph's
up-direction within a cosine of upright; it is visible when three of five rays from the camera reach it.
"""

from __future__ import annotations

import math
from functools import lru_cache
from typing import Literal

from rpg.blocks.camera import POSITION
from rpg.blocks.state import BlockState, Matrix, Vec3
from rpg.blocks.verdict import Verdict, holds
from rpg.ir.assets import Face, SemanticCube

NORMAL_COS = 0.97
UPRIGHT_COS = 0.94
RAYS_NEEDED = 3
CORNER_EXTENT = 0.8
"""Rays go to a face's centre and to four points at this share of its extent."""
RAYS = ((0.0, 0.0), *((u * CORNER_EXTENT, v * CORNER_EXTENT) for u in (1.0, -1.0) for v in (1.0, -1.0)))

X, Y, Z = (1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)
NORMALS: dict[Face, Vec3] = {
    "top": Z,
    "bottom": (0.0, 0.0, -1.0),
    "front": X,
    "back": (-1.0, 0.0, 0.0),
    "left": Y,
    "right": (0.0, -1.0, 0.0),
}
"""Outward normal of each face in the block's own frame."""
UPS: dict[Face, Vec3] = {"top": X, "bottom": X, "front": Z, "back": Z, "left": Z, "right": Z}
"""Up-direction of each face's glyph in the block's own frame."""
ALONG: dict[Face, tuple[int, float]] = {
    face: next((k, part) for k, part in enumerate(normal) if part) for face, normal in NORMALS.items()
}
"""The axis of a block that a face's normal lies along, and in which sense."""

Toward = Literal["up", "down", "left", "right", "front", "back"]
TOWARD: dict[Toward, tuple[Vec3, Vec3]] = {
    "up": (Z, X),
    "down": ((0.0, 0.0, -1.0), X),
    "front": ((-1.0, 0.0, 0.0), Z),
    "back": (X, Z),
    "left": (Y, Z),
    "right": ((0.0, -1.0, 0.0), Z),
}
"""For each direction of the viewer's: the way a face's normal points, and the way its glyph is then upright.

"front" is towards the viewer, as in "facing the front"; an unrotated block shows its BACK there.
"""


def dot(a: Vec3, b: Vec3) -> float:
    """Scalar product."""
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def cross(a: Vec3, b: Vec3) -> Vec3:
    """Vector product."""
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def outward(axes: Matrix, face: Face) -> Vec3:
    """The normal of a face in the world."""
    k, sign = ALONG[face]
    return (sign * axes[0][k], sign * axes[1][k], sign * axes[2][k])


def upward(axes: Matrix, face: Face) -> Vec3:
    """The up-direction of a face's glyph in the world."""
    k = 0 if ALONG[face][0] == 2 else 2
    return (axes[0][k], axes[1][k], axes[2][k])


@lru_cache(maxsize=256)
def turned(normal: Vec3, up: Vec3, degrees: float) -> Vec3:
    """`up` turned counter-clockwise, as seen by the reader whom `normal` points at."""
    angle = math.radians(degrees)
    c, s = math.cos(angle), math.sin(angle)
    side = cross(normal, up)
    return (c * up[0] + s * side[0], c * up[1] + s * side[1], c * up[2] + s * side[2])


def nearest_face(state: BlockState, name: str, direction: Vec3) -> Face:
    """The face of the block whose normal is nearest to `direction` (a unit vector in the world)."""
    (fx, lx, tx), (fy, ly, ty), (fz, lz, tz) = state.axes(name)
    x, y, z = direction
    top, front, left = tx * x + ty * y + tz * z, fx * x + fy * y + fz * z, lx * x + ly * y + lz * z
    if abs(top) >= abs(front) and abs(top) >= abs(left):
        return "top" if top >= 0.0 else "bottom"
    if abs(front) >= abs(left):
        return "front" if front >= 0.0 else "back"
    return "left" if left >= 0.0 else "right"


def symbol(state: BlockState, name: str, face: Face) -> str:
    """The symbol on a face; empty for plain cubes and blank faces."""
    block = state.world.blocks[name]
    return block.symbol(face) if isinstance(block, SemanticCube) else ""


def readable(
    state: BlockState,
    name: str,
    face: Face,
    normal: Vec3,
    up: Vec3 | None,
    normal_cos: float = NORMAL_COS,
    upright_cos: float = UPRIGHT_COS,
) -> Verdict:
    """Does `face` point along `normal` with its glyph's up-direction along `up` (None: turned in any way)?"""
    axes = state.axes(name)
    margin = (dot(outward(axes, face), normal) - normal_cos) / (1.0 - normal_cos)
    if up is not None:
        margin = min(margin, (dot(upward(axes, face), up) - upright_cos) / (1.0 - upright_cos))
    return holds(margin)


def reads(
    state: BlockState,
    name: str,
    normal: Vec3,
    up: Vec3 | None,
    normal_cos: float = NORMAL_COS,
    upright_cos: float = UPRIGHT_COS,
) -> tuple[str, float]:
    """What a reader at `normal` of the block sees: the symbol of the face nearest to it, and readability's margin."""
    face = nearest_face(state, name, normal)
    return symbol(state, name, face), readable(state, name, face, normal, up, normal_cos, upright_cos).margin


def visible(state: BlockState, name: str, face: Face, assume: Literal["coplanar", "stack"] | None = None) -> Verdict:
    """Do at least three of five rays from the camera reach `face`?

    `assume`: in a coplanar arrangement every face that points up counts as visible, in a vertical stack every face
    that points at the viewer, with no rays cast.
    """
    axes = state.axes(name)
    normal = outward(axes, face)
    if assume is not None:
        expected = TOWARD["up" if assume == "coplanar" else "front"][0]
        if dot(normal, expected) > math.cos(math.pi / 4):
            return holds(1.0)
    half = state.world.edge[name] / 2
    position = state.position[name]
    up = upward(axes, face)
    side = cross(normal, up)
    sights = []
    for u, v in RAYS:
        a, b = u * half, v * half
        point = (
            position[0] + half * normal[0] + a * side[0] + b * up[0],
            position[1] + half * normal[1] + a * side[1] + b * up[1],
            position[2] + half * normal[2] + a * side[2] + b * up[2],
        )
        sight = _from(POSITION, point)
        if dot(normal, sight) < 0.0:
            sights.append(sight)
    for other in state.position:
        if sights and other != name:
            sights = _past(state, other, sights)
    return holds((len(sights) - RAYS_NEEDED + 0.5) / 2.5)


def _from(origin: Vec3, end: Vec3) -> Vec3:
    return (end[0] - origin[0], end[1] - origin[1], end[2] - origin[2])


def _past(state: BlockState, name: str, sights: list[Vec3]) -> list[Vec3]:
    """The segments from the camera that do not pass through a block (slab test in the block's frame)."""
    (xx, xy, xz), (yx, yy, yz), (zx, zy, zz) = state.axes(name)
    half = state.world.edge[name] / 2
    x, y, z = _from(state.position[name], POSITION)
    slabs = [(a, b, c, a * x + b * y + c * z) for a, b, c in ((xx, yx, zx), (xy, yy, zy), (xz, yz, zz))]
    return [sight for sight in sights if not _crosses(slabs, half, sight)]


def _crosses(slabs: list[tuple[float, float, float, float]], half: float, sight: Vec3) -> bool:
    """Does a segment pass through a block? `slabs`: each of its axes, and where along it the segment begins."""
    x, y, z = sight
    near, far = 0.0, 1.0
    for a, b, c, start in slabs:
        step = a * x + b * y + c * z
        if abs(step) < 1e-12:
            if abs(start) > half:
                return False
            continue
        low, high = (-half - start) / step, (half - start) / step
        if low > high:
            low, high = high, low
        near = low if low > near else near
        far = high if high < far else far
        if far - near <= 1e-9:
            return False
    return True
