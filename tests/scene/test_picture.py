"""Pictures: right side up, the right thing in the right place, with and without OpenGL."""

from __future__ import annotations

import io
import os

import mujoco
import numpy as np
import pytest
from PIL import Image

from rpg.blocks import camera, opengl
from rpg.blocks.initial import sample_start
from rpg.blocks.picture import draw, pixels
from rpg.blocks.scene import LOOK, build_spec
from rpg.blocks.state import BlockState, World
from rpg.blocks.textures import RGB, face_image
from rpg.ir.assets import ColoredCube, Faces, GoalPatch, SemanticCube
from rpg.ir.schema import InitialState
from tests.scene.builders import about, at, lettered, plain, tower

needs_gl = pytest.mark.skipif(opengl.backend() is None, reason="no OpenGL here")
SIZE = (320, 240)


def mixed() -> BlockState:
    colours = ("red", "green", "blue", "yellow", "orange", "purple", "white", "black")
    blocks = [ColoredCube(name=f"{colour}_block", color=colour) for colour in colours]
    letters = [SemanticCube(name=f"letter_block_{i}", label=letter) for i, letter in enumerate("AR5+")]
    patch = GoalPatch(name="patch", color="cyan", shape="circle", position=(0.6, 0.1))
    return sample_start(InitialState(), World([*blocks, *letters, patch]), 4)


def test_a_picture_is_a_png_of_the_promised_size() -> None:
    image = Image.open(io.BytesIO(draw(at(plain(1), (0.55, 0.0, 0.02)))))
    assert (image.format, image.size) == ("PNG", (640, 480))


def test_left_is_left_and_near_is_low() -> None:
    world = World([ColoredCube(name=f"{c}_block", color=c) for c in ("red", "green", "blue", "yellow")])
    state = at(world, (0.45, 0.15, 0.02), (0.45, -0.15, 0.02), (0.65, 0.15, 0.02), (0.65, -0.15, 0.02))
    image = pixels(state, size=SIZE, how="rays").astype(int)
    rows, columns = {}, {}
    for name in ("red", "green", "blue", "yellow"):
        close = np.abs(image - np.array(RGB[name]) * 1.0).sum(axis=2) < 90
        rows[name], columns[name] = (np.nonzero(close)[axis].mean() for axis in (0, 1))
    assert columns["red"] < columns["green"] and columns["blue"] < columns["yellow"]
    assert rows["red"] > rows["blue"] and rows["green"] > rows["yellow"]


@needs_gl
def test_rays_and_opengl_agree_on_what_is_where() -> None:
    state = mixed()
    cast = pixels(state, size=SIZE, how="rays").astype(int)
    drawn = pixels(state, size=SIZE, how=opengl.backend()).astype(int)
    lower = slice(SIZE[1] // 4, None)
    differences = np.abs(cast - drawn).max(axis=2)[lower]
    assert np.mean(differences > 40) < 0.02


@needs_gl
@pytest.mark.parametrize(
    ("axis", "degrees"), [("z", 0), ("y", 90), ("y", -90), ("y", 180), ("x", 90), ("x", -90), ("z", 90)]
)
def test_every_face_reads_the_same_with_both(axis: str, degrees: float) -> None:
    state = at(lettered(), (0.45, 0.0, 0.02), turns={"x": about(axis, degrees)})
    images = [
        pixels(state, size=(640, 480), how=how).astype(int)[185:295, 270:370] for how in ("rays", opengl.backend())
    ]
    assert images[0].std() > 30
    assert np.mean(np.abs(images[0] - images[1]).max(axis=2) > 60) < 0.03


def test_a_tall_tower_is_in_the_picture_whole() -> None:
    image = pixels(at(plain(12), *tower(12)), size=SIZE, how="rays").astype(int)
    red = (image[..., 0] > 90) & (image[..., 1] < 70) & (image[..., 2] < 70)
    assert red.any()
    assert not red[:2].any() and not red[-2:].any()


@pytest.mark.parametrize("edge", [0.04, 0.12])
def test_blocks_in_the_corners_of_the_workspace_are_in_the_picture_whole(edge: float) -> None:
    world = World([ColoredCube(name=f"block_{n}", color="red", size=edge) for n in range(4)])
    places = [(x, y, edge / 2) for x in (0.40, 0.70) for y in (-0.25, 0.25)]
    turns = {f"block_{n}": about("z", 45) for n in range(4)}
    image = pixels(at(world, *places, turns=turns), size=SIZE, how="rays").astype(int)
    red = (image[..., 0] > 90) & (image[..., 1] < 70) & (image[..., 2] < 70)
    rows, columns = np.nonzero(red)
    assert rows.min() > 0 and rows.max() < SIZE[1] - 1
    assert columns.min() > 0 and columns.max() < SIZE[0] - 1


def test_blocks_are_large_in_the_picture() -> None:
    image = pixels(at(plain(1), (0.55, 0.0, 0.02)), size=(640, 480), how="rays").astype(int)
    red = (image[..., 0] > 90) & (image[..., 1] < 70) & (image[..., 2] < 70)
    assert np.ptp(np.nonzero(red)[1]) > 70


def test_a_start_and_its_goal_are_seen_in_one_frame() -> None:
    world = World([ColoredCube(name="red_block", color="red"), GoalPatch(name="p", color="blue", position=(0.5, 0.1))])
    here, there = at(world, (0.42, 0.2, 0.02)), at(world, (0.68, -0.2, 0.02))
    one = pixels(here, beside=(there,), size=SIZE, how="rays").astype(int)
    other = pixels(there, beside=(here,), size=SIZE, how="rays").astype(int)
    blue = [np.nonzero((image[..., 2] > 150) & (image[..., 0] < 90)) for image in (one, other)]
    assert blue[0][0].size > 200
    assert np.array_equal(blue[0], blue[1])


def test_neighbours_of_one_colour_are_told_apart() -> None:
    image = pixels(at(plain(2), (0.55, 0.02, 0.02), (0.55, -0.02, 0.02)), size=(640, 480), how="rays").astype(int)
    top = int(np.nonzero(image[..., 1] < 60)[0].min()) + 10
    assert np.ptp(image[top, 310:331, 0]) > 15


def test_symbols_differ_from_each_other() -> None:
    faces = {
        symbol: np.asarray(face_image(symbol, "ivory"), dtype=int)
        for symbol in "ABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789+-*/="
    }
    for a, one in faces.items():
        for b, other in faces.items():
            assert a == b or np.mean(np.abs(one - other).max(axis=2) > 80) > 0.005, (a, b)


def test_a_textured_scene_survives_being_saved_and_loaded() -> None:
    world = World([SemanticCube(name="A_block", label="A", color="blue"), ColoredCube(name="red_block", color="red")])
    spec = build_spec(world.assets.values(), textures=True)
    xml, files = spec.to_xml(), dict(spec.assets)
    again = mujoco.MjModel.from_xml_string(xml, files)
    assert again.ntex == spec.compile().ntex
    assert again.body("A_block").mass[0] == pytest.approx(600 * 0.04**3)


def test_cubes_with_the_same_letters_on_other_faces_look_different() -> None:
    one = SemanticCube(name="one", labels=Faces(top="A", bottom="B", front="B", back="B", left="B", right="B"))
    other = SemanticCube(name="other", labels=Faces(top="A", bottom="A", front="B", back="B", left="B", right="B"))
    model = build_spec([one, other], textures=True).compile()
    materials = {int(model.geom(name + LOOK).matid[0]) for name in ("one", "other")}
    assert len(materials) == 2


def test_the_camera_looks_along_x_and_down() -> None:
    model = build_spec([]).compile()
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    forward = -data.cam(camera.NAME).xmat.reshape(3, 3)[:, 2]
    assert forward[0] > 0.5 and abs(forward[1]) < 1e-9 and forward[2] < -0.5
    assert data.cam(camera.NAME).xmat.reshape(3, 3)[:, 0] == pytest.approx([0, -1, 0], abs=1e-9)


@needs_gl
@pytest.mark.skipif(not hasattr(os, "fork"), reason="no fork here")
def test_a_forked_child_still_draws() -> None:
    state = at(plain(1), (0.55, 0.0, 0.02))
    pixels(state, size=SIZE)
    child = os.fork()
    if child == 0:
        drawn = pixels(state, size=SIZE)
        os._exit(0 if drawn.std() > 5 else 1)
    _, status = os.waitpid(child, 0)
    assert os.waitstatus_to_exitcode(status) == 0
