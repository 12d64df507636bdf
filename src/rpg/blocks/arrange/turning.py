"""Orientations: how a block must be turned so that its faces point where the goal wants them."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from itertools import chain

from rpg.blocks.predicates import PREDICATES
from rpg.blocks.predicates.facing import directions, shown_faces
from rpg.blocks.state import IDENTITY, BlockState, Matrix, Quat, Vec3, World, product, yaw_quat
from rpg.blocks.visibility import NORMALS, TOWARD, UPS, cross, turned
from rpg.ir.relations import Facing, Turned

TURNS = (0.0, 90.0, 180.0, 270.0)


def orientation_for(
    block: str,
    wanted: Iterable[tuple[Facing | Turned, bool]],
    world: World,
    start: BlockState | None,
    given: Quat | None = None,
) -> Quat | None:
    """An orientation that meets every facing and turned atom on `block`, `given` if it does; None where none does."""
    literals = list(wanted)
    candidates = _candidates(block, [atom for atom, _ in literals], world, start)
    for quat in candidates if given is None else chain((given,), candidates):
        alone = BlockState(world, {block: (0.55, 0.0, 1.0)}, {block: quat}, start=start)
        if all(PREDICATES[atom.kind].evaluate(atom, alone).value == holds for atom, holds in literals):
            return quat
    return None


def _candidates(block: str, atoms: list[Facing | Turned], world: World, start: BlockState | None) -> Iterator[Quat]:
    yield IDENTITY
    for atom in atoms:
        if isinstance(atom, Turned):
            begun = start.orientation.get(block, IDENTITY) if start else IDENTITY
            for degrees in (atom.degrees, -atom.degrees, atom.degrees + 90.0):
                yield product(yaw_quat(degrees * 0.017453292519943295), begun)
        else:
            yield from _facing(atom, world)
    for face in NORMALS:
        yield from (_bring(face, "up", turn) for turn in TURNS)


def _facing(atom: Facing, world: World) -> Iterator[Quat]:
    for turn in TURNS if atom.turn is None else (atom.turn,):
        for toward in directions(atom):
            for face in shown_faces(atom, world):
                yield _bring(face, toward, turn)


def _bring(face: str, toward: str, turn: float) -> Quat:
    """The orientation that points `face` in a direction, its glyph turned from upright."""
    normal, upright = TOWARD[toward]  # type: ignore[index]
    up = turned(normal, upright, turn)
    return quaternion(_outer(_basis(normal, up), _basis(NORMALS[face], UPS[face])))  # type: ignore[index]


def _basis(normal: Vec3, up: Vec3) -> tuple[Vec3, Vec3, Vec3]:
    return normal, up, cross(normal, up)


def _outer(to: tuple[Vec3, Vec3, Vec3], of: tuple[Vec3, Vec3, Vec3]) -> Matrix:
    """The rotation that takes the basis `of` to the basis `to`."""
    rows = [tuple(sum(to[k][i] * of[k][j] for k in range(3)) for j in range(3)) for i in range(3)]
    return rows[0], rows[1], rows[2]  # type: ignore[return-value]


def quaternion(m: Matrix) -> Quat:
    """Unit quaternion (w, x, y, z) of a rotation matrix, with w not negative."""
    (a, b, c), (d, e, f), (g, h, i) = m
    squares = (1 + a + e + i, 1 + a - e - i, 1 - a + e - i, 1 - a - e + i)
    largest = max(range(4), key=lambda k: squares[k])
    s = 2 * squares[largest] ** 0.5
    half = s / 4
    w, x, y, z = (
        (half, (h - f) / s, (c - g) / s, (d - b) / s),
        ((h - f) / s, half, (b + d) / s, (c + g) / s),
        ((c - g) / s, (b + d) / s, half, (f + h) / s),
        ((d - b) / s, (c + g) / s, (f + h) / s, half),
    )[largest]
    sign = -1.0 if w < 0 else 1.0
    return (sign * w, sign * x, sign * y, sign * z)
