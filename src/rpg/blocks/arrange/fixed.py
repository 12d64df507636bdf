"""Blocks whose poses the start of the episode decides: those that stay, and those that take the place of others."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from rpg.blocks.geometry import supporters
from rpg.blocks.state import IDENTITY, BlockState, Quat, Vec3, World
from rpg.ir import goal as g
from rpg.ir.relations import Stayed, Swapped, TookPlace

Poses = dict[str, tuple[Vec3, Quat]]


def fixed_poses(atoms: Iterable[g.Atom], world: World, start: BlockState | None) -> Poses | None:
    """World poses of blocks that stay or swap, and of what holds them up; None where two conditions disagree."""
    if start is None:
        return {}
    poses: Poses = {}
    for name, pose in _asked(atoms, world, start):
        known = poses.setdefault(name, pose)
        if max(abs(p - q) for p, q in zip(known[0], pose[0], strict=True)) > 1e-6:
            return None
    waiting = list(poses)
    while waiting:
        for below in supporters(start, waiting.pop()):
            if below not in poses:
                poses[below] = _pose(below, start)
                waiting.append(below)
    return poses


def _asked(atoms: Iterable[g.Atom], world: World, start: BlockState) -> Iterator[tuple[str, tuple[Vec3, Quat]]]:
    for atom in atoms:
        if isinstance(atom, Stayed):
            yield from ((name, _pose(name, start)) for name in start.resolve(atom.a))
        elif isinstance(atom, Swapped):
            for a, b in zip(atom.a, atom.b, strict=False):
                yield a, _in_place_of(a, b, world, start)
                yield b, _in_place_of(b, a, world, start)
        elif isinstance(atom, TookPlace):
            yield from ((a, _in_place_of(a, b, world, start)) for a, b in zip(atom.a, atom.b, strict=False))


def _pose(name: str, start: BlockState) -> tuple[Vec3, Quat]:
    return start.position[name], start.orientation.get(name, IDENTITY)


def _in_place_of(name: str, other: str, world: World, start: BlockState) -> tuple[Vec3, Quat]:
    """The pose of `name` on the ground that `other` had."""
    x, y, z = start.position[other]
    return (x, y, z + (world.edge[name] - world.edge[other]) / 2), start.orientation.get(other, IDENTITY)
