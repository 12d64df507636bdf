"""Pictures of states as the viewer sees them: with OpenGL where it works, else with rays that MuJoCo casts."""

from __future__ import annotations

import io
import math
from collections.abc import Iterable, Iterator, Sequence

import mujoco
import numpy as np
from numpy.typing import NDArray
from PIL import Image

from rpg.blocks import camera, opengl, raycast
from rpg.blocks.constants import TABLE_Z
from rpg.blocks.geometry import corners, patch_outline
from rpg.blocks.physics import Physics
from rpg.blocks.scene import build_spec
from rpg.blocks.state import BlockState, Vec3

SUPERSAMPLING = 2
"""OpenGL draws pictures this many times larger, and they are scaled down."""
MARGIN = 1.5
"""Degrees kept free between what must be seen and the picture's edges."""
CLOSEST = 14.0
"""The narrowest view in degrees: few blocks are seen with some of the table around them."""


def method() -> str:
    """How pictures are drawn here: "egl", "osmesa", another OpenGL back end, or "rays"."""
    return opengl.backend() or "rays"


def draw(
    state: BlockState, *, beside: Sequence[BlockState] = (), size: tuple[int, int] = (camera.WIDTH, camera.HEIGHT)
) -> bytes:
    """A PNG of `state` from where the viewer is, framed so that `state` and the states `beside` it are seen whole."""
    buffer = io.BytesIO()
    Image.fromarray(pixels(state, beside=beside, size=size)).save(buffer, "PNG", optimize=True)
    return buffer.getvalue()


def pixels(
    state: BlockState, *, beside: Sequence[BlockState] = (), size: tuple[int, int], how: str | None = None
) -> NDArray[np.uint8]:
    """RGB pixels of `state`, top row first; `how` is what `method` gives unless it is told."""
    rays = (how or method()) == "rays"
    spec = build_spec(state.world.assets.values(), textures=True)
    spec.visual.quality.offsamples = 0
    _aim(spec, (state, *beside), size[0] / size[1])
    model = spec.compile()
    physics = Physics(state.world, model)
    physics.write(state)
    if rays:
        return raycast.draw(model, physics.data, state.world, camera.NAME, *size)
    canvas = opengl.Canvas(model, size[0] * SUPERSAMPLING, size[1] * SUPERSAMPLING)
    try:
        large = canvas.draw(physics.data, camera.NAME)
    finally:
        canvas.close()
    return np.asarray(Image.fromarray(large).resize(size, Image.Resampling.BOX))


def _aim(spec: mujoco.MjSpec, states: Iterable[BlockState], aspect: float) -> None:
    """Tilt the viewer's camera and narrow or widen its view, so that all blocks and patches fill the picture."""
    points = [point for state in states for point in _to_be_seen(state)]
    low, high = min(map(_elevation, points)) - MARGIN, max(map(_elevation, points)) + MARGIN
    middle = (low + high) / 2
    across = 2 * math.degrees(math.atan(max(_aside(point, middle) for point in points) / aspect))
    spec.camera(camera.NAME).fovy = max(CLOSEST, high - low, across + MARGIN)
    spec.camera(camera.NAME).quat = camera.orientation(middle)


def _to_be_seen(state: BlockState) -> Iterator[Vec3]:
    for name in state.position:
        yield from corners(state, name)
    for patch in state.world.patches.values():
        yield from ((x, y, TABLE_Z) for x, y in patch_outline(patch))


def _elevation(point: Vec3) -> float:
    """Angle (degrees) over the horizon at which the camera sees a point, projected on its middle plane."""
    dx, dz = point[0] - camera.POSITION[0], point[2] - camera.POSITION[2]
    return math.degrees(math.atan2(dz, dx))


def _aside(point: Vec3, elevation: float) -> float:
    """How far to the side of the camera's axis a point is, relative to its distance along the axis."""
    dx, dz = point[0] - camera.POSITION[0], point[2] - camera.POSITION[2]
    angle = math.radians(elevation)
    return abs(point[1] - camera.POSITION[1]) / (dx * math.cos(angle) + dz * math.sin(angle))
