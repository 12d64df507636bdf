"""Goal scenes moved a little: flat, centred, spread, back inside the workspace."""

from __future__ import annotations

import math
from dataclasses import replace

from rpg.blocks.constants import TABLE_Z, WORKSPACE_X, WORKSPACE_Y
from rpg.blocks.state import BlockState, Quat, Vec3, World, yaw_quat
from rpg.ir.artifact import Placement, Scene

BORDER = 0.005
"""Distance (m) that a moved block keeps from the border of the workspace."""


def state_of(scene: Scene, world: World) -> BlockState:
    """The state that a scene places."""
    return BlockState(world, {p.block: p.position for p in scene}, {p.block: p.orientation for p in scene})


def with_last(path: tuple[Scene, ...], state: BlockState) -> tuple[Scene, ...]:
    """`path` with its last scene replaced."""
    return (*path[:-1], scene_of(state))


def scene_of(state: BlockState) -> Scene:
    """A state as placements, rounded to what code shows: 0.1 mm, a millionth of a turn."""
    return tuple(
        Placement(block=name, position=_rounded(state.position[name]), orientation=_tidy(state.orientation[name]))
        for name in state.world.blocks
    )


def levelled(state: BlockState) -> BlockState:
    """Every block turned onto its nearest face and let down, bottom ones first, onto what it stands over."""
    flat = {name: yaw_quat(_yaw(state, name)) for name in state.position}
    placed: dict[str, Vec3] = {}
    for name in _upwards(state):
        x, y, _ = state.position[name]
        half = state.world.edge[name] / 2
        below = [
            n for n in placed if _over(placed[n], state.world.edge[n], (x, y), half) and _was_below(state, n, name)
        ]
        height = max((placed[n][2] + state.world.edge[n] / 2 for n in below), default=TABLE_Z)
        placed[name] = (x, y, height + half)
    order = tuple(state.position)
    return replace(state, position={n: placed[n] for n in order}, orientation=flat, _axes={})


def centred(state: BlockState) -> BlockState:
    """Every block that stands on one other block moved over its centre, and turned like it."""
    position, orientation = dict(state.position), dict(state.orientation)
    for name in _upwards(state):
        half = state.world.edge[name] / 2
        below = [
            n
            for n in position
            if n != name
            and abs(position[n][2] + state.world.edge[n] / 2 - (state.position[name][2] - half)) < BORDER
            and _over(position[n], state.world.edge[n], state.position[name][:2], half)
        ]
        if len(below) == 1:
            position[name] = (*position[below[0]][:2], position[name][2])
            orientation[name] = orientation[below[0]]
    return replace(state, position=position, orientation=orientation, _axes={})


def spread(state: BlockState, factor: float) -> BlockState | None:
    """The arrangement stretched in the plane about its middle; stacks move as one. None where it no longer fits."""
    columns = {name: _foot(state, name) for name in state.position}
    feet = [state.position[foot] for foot in columns.values()]
    middle = tuple(sum(place[k] for place in feet) / len(feet) for k in (0, 1))
    position: dict[str, Vec3] = {}
    for name, (x, y, z) in state.position.items():
        foot = state.position[columns[name]]
        dx, dy = ((foot[k] - middle[k]) * (factor - 1) for k in (0, 1))
        position[name] = (x + dx, y + dy, z)
    return inside(replace(state, position=position, _axes={}))


def inside(state: BlockState) -> BlockState | None:
    """The arrangement moved as a whole until every centre is in the workspace; None where it is too large."""
    shift = []
    for axis, (low, high) in enumerate((WORKSPACE_X, WORKSPACE_Y)):
        values = [place[axis] for place in state.position.values()]
        room_low, room_high = low + BORDER - min(values), high - BORDER - max(values)
        if room_low > room_high:
            return None
        shift.append(min(max(0.0, room_low), room_high))
    moved = {name: (x + shift[0], y + shift[1], z) for name, (x, y, z) in state.position.items()}
    return replace(state, position=moved, _axes={})


def _upwards(state: BlockState) -> list[str]:
    return sorted(state.position, key=lambda name: (state.position[name][2], name))


def _was_below(state: BlockState, lower: str, upper: str) -> bool:
    return state.position[upper][2] - state.position[lower][2] > state.world.edge[lower] / 2


def _over(place: Vec3 | tuple[float, float], edge: float, other: tuple[float, ...], half: float) -> bool:
    """Do two level blocks overlap as seen from above?"""
    return max(abs(place[0] - other[0]), abs(place[1] - other[1])) < edge / 2 + half - 1e-4


def _foot(state: BlockState, name: str) -> str:
    """The lowest block of the column that a block is in."""
    x, y, _ = state.position[name]
    half = state.world.edge[name] / 2
    column = [n for n in state.position if _over(state.position[n], 0.0, (x, y), half)]
    return min(column, key=lambda n: (state.position[n][2], n), default=name)


def _yaw(state: BlockState, name: str) -> float:
    """The turn about the vertical of the most level axis of a block."""
    axes = state.axes(name)
    level = min(range(3), key=lambda k: abs(axes[2][k]))
    return math.atan2(axes[1][level], axes[0][level])


def _rounded(place: Vec3) -> Vec3:
    x, y, z = (round(value, 6) for value in place)
    return x, y, z


def _tidy(quat: Quat) -> Quat:
    """Level blocks as the yaw that code shows gives them, so that reading the code gives the same scene."""
    w, x, y, z = quat
    if abs(x) < 1e-9 and abs(y) < 1e-9:
        return yaw_quat(round(2 * math.atan2(z, w), 6))
    w, x, y, z = (round(value, 9) for value in quat)
    return w, x, y, z
