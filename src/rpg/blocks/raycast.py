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
OFFSETS = tuple((dx / 6, dy / 6) for dx in (-2, 0, 2) for dy in (-2, 0, 2))
"""Where in a pixel on an edge the rays go, in pixels from its centre."""
CONTRAST = 0.02
BIAS = 1e-4
"""Shadow rays start from this far (m) in front of a surface."""


def draw(
    model: mujoco.MjModel, data: mujoco.MjData, world: World, camera: str, width: int, height: int
) -> NDArray[np.uint8]:
    """What a camera sees of a textured scene: RGB pixels, top row first. Pixels on edges get several rays each."""
    y, x = (axis.ravel().astype(np.float64) for axis in np.indices((height, width)))
    size = (width, height)
    colour = _shade(model, data, world, camera, x, y, size)
    rough = _rough(colour.reshape(height, width, 3)).ravel()
    finer = [_shade(model, data, world, camera, x[rough] + dx, y[rough] + dy, size) for dx, dy in OFFSETS]
    colour[rough] = np.mean(finer, axis=0)
    return (np.clip(colour, 0.0, 1.0) * 255 + 0.5).astype(np.uint8).reshape(height, width, 3)


def _rough(image: Floats) -> NDArray[np.bool_]:
    """Pixels that differ from a neighbour."""
    found = np.zeros(image.shape[:2], dtype=bool)
    for axis in (0, 1):
        step = np.abs(np.diff(image, axis=axis)).max(axis=2) > CONTRAST
        low = [slice(None), slice(None)]
        high = [slice(None), slice(None)]
        low[axis], high[axis] = slice(None, -1), slice(1, None)
        found[tuple(low)] |= step
        found[tuple(high)] |= step
    return found


def _shade(
    model: mujoco.MjModel,
    data: mujoco.MjData,
    world: World,
    camera: str,
    x: Floats,
    y: Floats,
    size: tuple[int, int],
) -> Floats:
    """Colours in [0, 1] of points of the picture, in pixels from the upper left corner's centre."""
    number = model.camera(camera).id
    origin, axes = np.array(data.cam_xpos[number]), np.array(data.cam_xmat[number]).reshape(3, 3)
    rays = _rays(axes, model.cam_fovy[number], x, y, size)
    geom, distance = _cast(model, data, origin, rays)
    hit = geom >= 0
    points = origin + rays[hit] * distance[hit, None]
    normal = _normals(model, data, geom[hit], points)
    colour = _sky(rays)
    surface = _surface(model, data, world, geom[hit], points)
    lit = _lit(model, data, points + normal * BIAS)
    lamp = np.clip(-(normal @ _unit(np.array(LAMP_DIRECTION))), 0.0, 1.0) * lit
    head = np.clip(normal @ axes[:, 2], 0.0, 1.0)
    colour[hit] = surface * (AMBIENT + HEADLIGHT * head + LAMP * lamp)[:, None]
    return np.clip(colour, 0.0, 1.0)


def _unit(vector: Floats) -> Floats:
    length: Floats = np.linalg.norm(vector, axis=-1, keepdims=True)
    unit: Floats = vector / length
    return unit


def _rays(axes: Floats, fovy: float, x: Floats, y: Floats, size: tuple[int, int]) -> Floats:
    """Unit directions through points of the picture."""
    scale = math.tan(math.radians(fovy) / 2) / (size[1] / 2)
    across, up = (x + 0.5 - size[0] / 2) * scale, (size[1] / 2 - y - 0.5) * scale
    turned: Floats = np.stack([across, up, np.full_like(x, -1.0)], axis=-1) @ axes.T
    return _unit(turned)


def _cast(model: mujoco.MjModel, data: mujoco.MjData, origin: Floats, rays: Floats) -> tuple[NDArray[np.int32], Floats]:
    """Geom hit by each ray (-1: none), and its distance (m)."""
    count = len(rays)
    geom, distance = np.full(count, -1, dtype=np.int32), np.zeros(count)
    more = {"normal": None} if "normal" in (mujoco.mj_multiRay.__doc__ or "") else {}
    mujoco.mj_multiRay(
        m=model,
        d=data,
        pnt=origin,
        vec=rays.ravel(),
        geomgroup=np.array(SHOWN, dtype=np.uint8),
        flg_static=True,
        bodyexclude=-1,
        geomid=geom,
        dist=distance,
        nray=count,
        cutoff=mujoco.mjMAXVAL,
        **more,
    )
    return geom, distance


def _normals(model: mujoco.MjModel, data: mujoco.MjData, geom: NDArray[np.int32], points: Floats) -> Floats:
    """The way surfaces face at points of boxes; of all else, straight up in the geom's frame."""
    found = np.empty_like(points)
    for number in np.unique(geom):
        chosen = geom == number
        axes = np.array(data.geom_xmat[number]).reshape(3, 3)
        found[chosen] = axes[:, 2]
        if int(model.geom_type[number]) == int(mujoco.mjtGeom.mjGEOM_BOX):
            local = (points[chosen] - data.geom_xpos[number]) @ axes / model.geom_size[number]
            side = np.abs(local).argmax(axis=1)
            sign = np.sign(local[np.arange(len(side)), side])
            found[chosen] = axes[:, side].T * sign[:, None]
    return found


def _lit(model: mujoco.MjModel, data: mujoco.MjData, points: Floats) -> Floats:
    """1 where the lamp shines on a point, 0 where something stands between."""
    lamp = np.array([0.55, 0.0, TABLE_Z]) - _unit(np.array(LAMP_DIRECTION)) * LAMP_DISTANCE
    towards = points - lamp
    length = np.linalg.norm(towards, axis=1)
    _, distance = _cast(model, data, lamp, towards / length[:, None])
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
