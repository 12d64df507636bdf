"""What the viewer can see and read."""

from __future__ import annotations

import math

import mujoco
import numpy as np
import pytest

from rpg.blocks import camera
from rpg.blocks.initial import sample_start
from rpg.blocks.physics import Physics
from rpg.blocks.scene import SHOWN, build_spec
from rpg.blocks.state import BlockState, World
from rpg.blocks.visibility import NORMALS, TOWARD, UPS, dot, readable, reads, turned, visible
from rpg.ir.assets import FACES, Face, SemanticCube
from rpg.ir.schema import InitialState
from tests.scene.builders import HALF, about, at, lettered, plain, tower

UP, UP_GLYPH = TOWARD["up"]
FRONT, FRONT_GLYPH = TOWARD["front"]
NORMAL_LIMIT = math.degrees(math.acos(0.97))
UPRIGHT_LIMIT = math.degrees(math.acos(0.94))


def lone(**turn: float) -> object:
    ((axis, degrees),) = turn.items() or (("z", 0.0),)
    return at(lettered(), (0.55, 0.0, HALF), turns={"x": about(axis, degrees)})


def test_unturned_the_viewer_reads_top_from_above_and_back_from_the_front() -> None:
    state = at(lettered(), (0.55, 0.0, HALF))
    assert reads(state, "x", UP, UP_GLYPH) == ("T", pytest.approx(1.0))
    assert reads(state, "x", FRONT, FRONT_GLYPH) == ("B", pytest.approx(1.0))


@pytest.mark.parametrize(
    ("axis", "degrees", "letter"),
    [("y", 90, "B"), ("y", -90, "F"), ("y", 180, "D"), ("x", 90, "L"), ("x", -90, "R"), ("x", 180, "D")],
)
def test_rolling_a_cube_brings_the_right_face_up(axis: str, degrees: float, letter: str) -> None:
    assert reads(lone(**{axis: degrees}), "x", UP, None) == (letter, pytest.approx(1.0))


def test_the_face_rolled_up_from_the_viewers_side_reads_upright() -> None:
    assert reads(lone(y=90), "x", UP, UP_GLYPH) == ("B", pytest.approx(1.0))


@pytest.mark.parametrize(("axis", "limit"), [("x", NORMAL_LIMIT), ("y", NORMAL_LIMIT), ("z", UPRIGHT_LIMIT)])
def test_readable_up_to_the_tolerance_and_not_beyond(axis: str, limit: float) -> None:
    assert reads(lone(**{axis: limit - 0.1}), "x", UP, UP_GLYPH)[1] > 0
    assert reads(lone(**{axis: limit + 0.1}), "x", UP, UP_GLYPH)[1] < 0
    assert reads(lone(**{axis: -limit - 0.1}), "x", UP, UP_GLYPH)[1] < 0


def test_upside_down_is_a_half_turn_in_the_plane_of_the_face() -> None:
    state = lone(z=180)
    assert not readable(state, "x", "top", UP, UP_GLYPH)
    assert readable(state, "x", "top", UP, turned(UP, UP_GLYPH, 180))


def test_a_turn_counts_counter_clockwise_for_the_reader() -> None:
    assert readable(lone(z=90), "x", "top", UP, turned(UP, UP_GLYPH, 90))
    # Seen from the viewer's side (along +x), the left hand is +y: turning the glyph's up to the left.
    assert readable(lone(x=-90), "x", "back", FRONT, turned(FRONT, FRONT_GLYPH, 90))


def test_faces_have_frames_of_their_own() -> None:
    for face in FACES:
        assert dot(NORMALS[face], UPS[face]) == 0.0


def test_a_lone_block_shows_top_and_back_only() -> None:
    state = at(plain(1), (0.55, 0.0, HALF))
    assert {face for face in FACES if visible(state, "b0", face)} == {"top", "back"}


def test_what_stands_on_a_block_hides_its_top() -> None:
    state = at(plain(2), *tower(2))
    assert not visible(state, "b0", "top")
    assert visible(state, "b0", "back")


def test_a_block_close_in_front_hides_the_side_but_not_the_top() -> None:
    state = at(plain(2), (0.60, 0.0, HALF), (0.555, 0.0, HALF))
    assert not visible(state, "b0", "back")
    assert visible(state, "b0", "top")


def test_a_face_half_hidden_counts_as_visible_while_three_rays_reach_it() -> None:
    world = plain(2)
    states = [at(world, (0.60, 0.0, HALF), (0.555, y, HALF)) for y in (0.0, 0.045)]
    assert [bool(visible(state, "b0", "back")) for state in states] == [False, True]


def test_shortcuts_cast_no_rays() -> None:
    buried = at(plain(2), *tower(2))
    assert visible(buried, "b0", "top", assume="coplanar")
    hidden = at(plain(2), (0.60, 0.0, HALF), (0.555, 0.0, HALF))
    assert visible(hidden, "b0", "back", assume="stack")
    assert not visible(hidden, "b0", "front", assume="stack")


@pytest.mark.parametrize("seed", range(4))
def test_rays_of_the_physics_engine_agree(seed: int) -> None:
    world = World([SemanticCube(name=f"{letter}_block", label=letter) for letter in "ABCDEFGH"])
    heap = InitialState(heaps=(tuple(world.blocks)[:6],))
    state = sample_start(heap, world, seed)
    physics = Physics(world, build_spec(world.assets.values(), textures=True).compile())
    physics.write(state)
    for name in world.blocks:
        for face in FACES:
            assert visible(state, name, face).value == _seen(physics, state, name, face), (name, face)


def _seen(physics: Physics, state: BlockState, name: str, face: Face) -> bool:
    """Do three of five of MuJoCo's rays end on the face?"""
    axes = np.array(state.axes(name))
    normal, up = axes @ NORMALS[face], axes @ UPS[face]
    side = np.cross(normal, up)
    half, eye = state.world.edge[name] / 2, np.array(camera.POSITION)
    reached = 0
    for a, b in ((0.0, 0.0), (0.8, 0.8), (0.8, -0.8), (-0.8, 0.8), (-0.8, -0.8)):
        sight = np.array(state.position[name]) + half * (normal + a * side + b * up) - eye
        geom = np.array([-1], dtype=np.int32)
        shown = np.array(SHOWN, dtype=np.uint8)
        distance = mujoco.mj_ray(physics.model, physics.data, eye, sight, shown, 1, -1, geom)
        reached += normal @ sight < 0 and abs(distance - 1.0) < 1e-4 and distance > 0
    return reached >= 3
