"""The MuJoCo scene of a task: table, camera, light and physics are the same for all; blocks and patches are its own."""

from __future__ import annotations

from collections.abc import Iterable
from functools import lru_cache

import mujoco

from rpg.blocks import camera
from rpg.blocks.constants import PATCH_THICKNESS, TABLE_SIZE, TABLE_X, TABLE_Z, TIMESTEP
from rpg.blocks.textures import CUBE_FACES, cube_files, face_file, rgba
from rpg.ir.assets import Asset, Block, GoalPatch

DENSITY = 600.0
"""Of a block's wood, kg/m^3: a 4 cm cube weighs 38 g."""
FRICTION = (0.8, 0.005, 0.0001)
SOLREF = (0.01, 1.0)
SOLIMP = (0.99, 0.999, 0.001, 0.5, 2.0)
SKIN = 5e-4
"""A block's collision box is this much (m) smaller on every side, the table as much lower, and contacts act from
twice that distance on.

So blocks touch where they seem to, and rest as they are placed; but their boxes never overlap, for then the contact
points of yawed blocks would change from step to step, and tall stacks tremble until they fall.
"""
TOUCH = 5e-6
"""Contacts act from a little farther (m) than where blocks touch, so that rounding does not let them fall apart."""
LOOK = " look"
"""Ends the name of the geom that shows a block in a textured scene; the one it collides with is hidden."""
SHOWN = (1, 1, 1, 0, 0, 0)
"""Geom groups that pictures show."""
HIDDEN_GROUP = 3

AMBIENT, HEADLIGHT, LAMP = 0.46, 0.34, 0.40
"""Shares of light from everywhere, from the camera, and from the lamp that throws shadows."""
LAMP_DIRECTION = (0.42, -0.45, -1.0)


def build_spec(assets: Iterable[Asset], *, textures: bool = False) -> mujoco.MjSpec:
    """The scene as an editable spec. Only pictures need `textures`; physics is the same without."""
    spec = mujoco.MjSpec()
    spec.modelname = "blocks"
    _physics(spec)
    _surroundings(spec, textures)
    for asset in assets:
        if isinstance(asset, GoalPatch):
            _add_patch(spec, asset)
        else:
            _add_block(spec, asset, textures)
    return spec


@lru_cache(maxsize=64)
def compiled(assets: tuple[Asset, ...]) -> mujoco.MjModel:
    """The compiled scene; never modify it, for it is shared."""
    return build_spec(assets).compile()


def _physics(spec: mujoco.MjSpec) -> None:
    spec.option.timestep = TIMESTEP
    spec.option.cone = mujoco.mjtCone.mjCONE_ELLIPTIC
    spec.option.impratio = 5.0
    spec.stat.center = [0.55, 0.0, TABLE_Z]
    spec.stat.extent = 0.8
    spec.visual.global_.azimuth, spec.visual.global_.elevation = 0.0, camera.ELEVATION
    spec.visual.global_.fovy = camera.FOVY * 1.2
    spec.visual.global_.offwidth = 1280
    spec.visual.global_.offheight = 960
    spec.visual.quality.shadowsize = 2048
    spec.visual.headlight.ambient = [AMBIENT] * 3
    spec.visual.headlight.diffuse = [HEADLIGHT] * 3
    spec.visual.headlight.specular = [0.0, 0.0, 0.0]


def _surroundings(spec: mujoco.MjSpec, textures: bool) -> None:
    world = spec.worldbody
    if textures:
        spec.add_texture(
            name="sky",
            type=mujoco.mjtTexture.mjTEXTURE_SKYBOX,
            builtin=mujoco.mjtBuiltin.mjBUILTIN_GRADIENT,
            rgb1=[0.93, 0.95, 0.97],
            rgb2=[0.80, 0.84, 0.88],
            width=64,
            height=384,
        )
    world.add_geom(
        name="floor", type=mujoco.mjtGeom.mjGEOM_PLANE, size=[4.0, 4.0, 0.1], rgba=[0.72, 0.74, 0.76, 1.0], **_contact()
    )
    half = [TABLE_SIZE[0] / 2, TABLE_SIZE[1] / 2, TABLE_SIZE[2] / 2]
    world.add_geom(
        name="table",
        type=mujoco.mjtGeom.mjGEOM_BOX,
        size=half,
        pos=[TABLE_X, 0.0, TABLE_Z - half[2] - SKIN],
        margin=SKIN + TOUCH,
        rgba=[0.86, 0.80, 0.71, 1.0],
        **_contact(),
    )
    world.add_light(
        name="lamp",
        type=mujoco.mjtLightType.mjLIGHT_DIRECTIONAL,
        pos=[-0.2, 0.9, 2.6],
        dir=list(LAMP_DIRECTION),
        diffuse=[LAMP] * 3,
        specular=[0.08, 0.08, 0.08],
        castshadow=True,
    )
    world.add_camera(
        name=camera.NAME,
        pos=list(camera.POSITION),
        quat=list(camera.orientation()),
        fovy=camera.FOVY,
    )


def _contact() -> dict[str, list[float]]:
    return {"friction": list(FRICTION), "solref": list(SOLREF), "solimp": list(SOLIMP)}


def _add_patch(spec: mujoco.MjSpec, patch: GoalPatch) -> None:
    if patch.position is None:
        raise ValueError(f"the patch {patch.name!r} has no position yet")
    x, y = patch.position
    circle = patch.shape == "circle"
    flat = PATCH_THICKNESS / 2
    spec.worldbody.add_geom(
        name=patch.name,
        type=mujoco.mjtGeom.mjGEOM_CYLINDER if circle else mujoco.mjtGeom.mjGEOM_BOX,
        size=[patch.size[0] / 2, flat, 0.0] if circle else [patch.size[0] / 2, patch.size[1] / 2, flat],
        pos=[x, y, TABLE_Z],
        rgba=list(rgba(patch.color)),
        contype=0,
        conaffinity=0,
    )


def _add_block(spec: mujoco.MjSpec, block: Block, textures: bool) -> None:
    body = spec.worldbody.add_body(name=block.name, pos=[0.0, 0.0, TABLE_Z + block.size / 2])
    body.add_freejoint(name=block.name)
    body.add_geom(
        name=block.name,
        type=mujoco.mjtGeom.mjGEOM_BOX,
        size=[block.size / 2 - SKIN] * 3,
        margin=SKIN + TOUCH,
        mass=DENSITY * block.size**3,
        rgba=list(rgba(block.color)),
        group=HIDDEN_GROUP if textures else 0,
        **_contact(),
    )
    if textures:
        body.add_geom(
            name=block.name + LOOK,
            type=mujoco.mjtGeom.mjGEOM_BOX,
            size=[block.size / 2] * 3,
            mass=0.0,
            contype=0,
            conaffinity=0,
            material=_material(spec, block),
        )


def _material(spec: mujoco.MjSpec, block: Block) -> str:
    """The block's material, added when it is the first of its look."""
    files = [face_file(block, face) for face in CUBE_FACES]
    shown = [file.rsplit("_", 1)[0] for file in files]
    name = "cube_" + "_".join(shown if len(set(shown)) > 1 else shown[:1])
    if spec.texture(name) is None:
        spec.assets.update(cube_files(block))
        spec.add_texture(name=name, type=mujoco.mjtTexture.mjTEXTURE_CUBE, cubefiles=files)
        roles = [""] * int(mujoco.mjtTextureRole.mjNTEXROLE)
        roles[int(mujoco.mjtTextureRole.mjTEXROLE_RGB)] = name
        spec.add_material(name=name, textures=roles, specular=0.15, shininess=0.2)
    return name
