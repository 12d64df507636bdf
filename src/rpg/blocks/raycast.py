"""Drawing without OpenGL: MuJoCo casts the rays, NumPy shades what they hit."""

from __future__ import annotations

import math

import mujoco
import numpy as np
from numpy.typing import NDArray

from rpg.blocks.constants import TABLE_Z
from rpg.blocks.scene import AMBIENT, HEADLIGHT, LAMP, LAMP_DIRECTION, LOOK, SHOWN
from rpg.blocks.state import World
from rpg.blocks.textures import PIXELS, face_pixels
from rpg.blocks.visibility import NORMALS, UPS, cross
from rpg.ir.assets import FACES

Floats = NDArray[np.float64]

LAMP_DISTANCE = 6.0
SKY_TOP, SKY_HORIZON = np.array([0.93, 0.95, 0.97]), np.array([0.80, 0.84, 0.88])
BIAS = 1e-4
"""Shadow rays start from this far (m) in front of a surface."""


def draw(
    model: mujoco.MjModel, data: mujoco.MjData, world: World, camera: str, width: int, height: int
) -> NDArray[np.uint8]:
    """What a camera sees of a textured scene: RGB pixels, top row first."""
    number = model.camera(camera).id
    origin = np.array(data.cam_xpos[number])
    rays = _rays(np.array(data.cam_xmat[number]).reshape(3, 3), model.cam_fovy[number], width, height)
    geom, distance, normal = _cast(model, data, origin, rays)
    hit = geom >= 0
    points = origin + rays * np.where(hit, distance, 0.0)[:, None]
    colour = _sky(rays)
    colour[hit] = _surface(model, data, world, geom[hit], points[hit])
    lamp = points[hit] + normal[hit] * BIAS
    lit = _lit(model, data, lamp)
    facing = np.clip(-(normal[hit] @ _unit(np.array(LAMP_DIRECTION))), 0.0, 1.0) * lit
    head = np.clip(normal[hit] @ np.array(data.cam_xmat[number]).reshape(3, 3)[:, 2], 0.0, 1.0)
    colour[hit] *= (AMBIENT + HEADLIGHT * head + LAMP * facing)[:, None]
    return (np.clip(colour, 0.0, 1.0) * 255 + 0.5).astype(np.uint8).reshape(height, width, 3)


def _unit(vector: Floats) -> Floats:
    length: Floats = np.linalg.norm(vector, axis=-1, keepdims=True)
    unit: Floats = vector / length
    return unit


def _rays(axes: Floats, fovy: float, width: int, height: int) -> Floats:
    """Unit directions through the middle of every pixel, row by row."""
    reach = math.tan(math.radians(fovy) / 2)
    x = (np.arange(width) + 0.5 - width / 2) / (height / 2) * reach
    y = (height / 2 - np.arange(height) - 0.5) / (height / 2) * reach
    grid = np.stack([*np.meshgrid(x, y), np.full((height, width), -1.0)], axis=-1).reshape(-1, 3)
    turned: Floats = grid @ axes.T
    return _unit(turned)


def _cast(
    model: mujoco.MjModel, data: mujoco.MjData, origin: Floats, rays: Floats
) -> tuple[NDArray[np.int32], Floats, Floats]:
    """Geom hit by each ray (-1: none), its distance (m) and the surface's normal."""
    count = len(rays)
    geom = np.full(count, -1, dtype=np.int32)
    distance, normal = np.zeros(count), np.zeros(3 * count)
    mujoco.mj_multiRay(
        model,
        data,
        origin,
        rays.ravel(),
        np.array(SHOWN, dtype=np.uint8),
        True,
        -1,
        geom,
        distance,
        normal,
        count,
        mujoco.mjMAXVAL,
    )
    return geom, distance, normal.reshape(-1, 3)


def _lit(model: mujoco.MjModel, data: mujoco.MjData, points: Floats) -> Floats:
    """1 where the lamp shines on a point, 0 where something stands between."""
    lamp = np.array([0.55, 0.0, TABLE_Z]) - _unit(np.array(LAMP_DIRECTION)) * LAMP_DISTANCE
    towards = points - lamp
    length = np.linalg.norm(towards, axis=1)
    _, distance, _ = _cast(model, data, lamp, towards / length[:, None])
    reached: NDArray[np.bool_] = distance >= length - 5 * BIAS
    return reached.astype(np.float64)


def _sky(rays: Floats) -> Floats:
    share = np.clip(rays[:, 2:3] * 0.5 + 0.5, 0.0, 1.0)
    colour: Floats = SKY_HORIZON * (1.0 - share) + SKY_TOP * share
    return colour


def _surface(
    model: mujoco.MjModel, data: mujoco.MjData, world: World, geom: NDArray[np.int32], points: Floats
) -> Floats:
    """Colour of each point: the geom's, or that of the face's picture on a block."""
    colour: Floats = np.array(model.geom_rgba[geom][:, :3], dtype=np.float64)
    for name in world.blocks:
        number = model.geom(name + LOOK).id
        chosen = geom == number
        if chosen.any():
            axes = np.array(data.geom_xmat[number]).reshape(3, 3)
            local = (points[chosen] - data.geom_xpos[number]) @ axes / (world.edge[name] / 2)
            colour[chosen] = _block_colours(world, name, local)
    return colour


def _block_colours(world: World, name: str, local: Floats) -> Floats:
    """Colours of points on a block; `local` in the block's frame, in half edges."""
    found = np.empty_like(local)
    nearest = np.argmax([local @ np.array(NORMALS[face]) for face in FACES], axis=0)
    for index, face in enumerate(FACES):
        chosen = nearest == index
        if chosen.any():
            up, right = np.array(UPS[face]), np.array(cross(UPS[face], NORMALS[face]))
            row = np.clip((1.0 - local[chosen] @ up) / 2 * PIXELS, 0, PIXELS - 1).astype(int)
            column = np.clip((1.0 + local[chosen] @ right) / 2 * PIXELS, 0, PIXELS - 1).astype(int)
            found[chosen] = face_pixels(world.blocks[name], face)[row, column] / 255.0
    return found
