"""Pieces: blocks whose places relative to each other are settled, merged from clusters, stacks and fixed poses."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from rpg.blocks.arrange.stability import stands
from rpg.blocks.constants import TABLE_Z, WORKSPACE_X, WORKSPACE_Y
from rpg.blocks.evaluate import rests
from rpg.blocks.geometry import body_gap
from rpg.blocks.predicate import Cluster
from rpg.blocks.state import IDENTITY, BlockState, Quat, Vec3, World
from rpg.ir.node import Highest, Lowest, Operand, members

AGREE = 1e-3
"""Places and turns that differ by less agree."""
OVERLAP = 5e-4


class Clash(Exception):
    """Two demands on the same blocks that cannot both be met."""


@dataclass
class Piece:
    """Centres with z above the table, and orientations (None: any that is level). `fixed`: x and y are the world's."""

    position: dict[str, Vec3]
    orientation: dict[str, Quat | None]
    fixed: bool = False
    trusted: bool = False

    def shifted(self, dx: float, dy: float, dz: float) -> dict[str, Vec3]:
        return {n: (x + dx, y + dy, z + dz) for n, (x, y, z) in self.position.items()}


class Assembly:
    """All blocks of a task as pieces; every block starts as a piece of its own."""

    def __init__(self, world: World) -> None:
        self.world = world
        self.of: dict[str, Piece] = {
            name: Piece({name: (0.0, 0.0, edge / 2)}, {name: None}) for name, edge in world.edge.items()
        }

    def pieces(self) -> list[Piece]:
        """Every piece once, in the order of the world's blocks."""
        found: dict[int, Piece] = {}
        for piece in self.of.values():
            found.setdefault(id(piece), piece)
        return list(found.values())

    def add(self, cluster: Cluster) -> None:
        """Merge a structure's cluster with whatever holds its blocks already."""
        position = {name: pose for name, (pose, _) in cluster.poses.items()}
        turns = {name: turn for name, (_, turn) in cluster.poses.items()}
        piece = Piece(position, turns, cluster.fixed, trusted=True)
        owners = [self.of[name] for name in position]
        held = {id(owner): owner for owner in owners if owner.fixed or len(owner.position) > 1}
        for other in held.values():
            shared = next(name for name in position if name in other.position)
            piece = self._joined(piece, other, _minus(other.position[shared], piece.position[shared]))
        self._own(piece)

    def fix(self, poses: dict[str, tuple[Vec3, Quat]]) -> None:
        """Blocks at poses in the world."""
        if poses:
            relative = {n: (x, y, z - TABLE_Z) for n, ((x, y, z), _) in poses.items()}
            self.add(Cluster({n: (relative[n], quat) for n, (_, quat) in poses.items()}, fixed=True))

    def put_on(self, a: str, b: str) -> None:
        """Merge so that `a` is centred on top of `b`."""
        upper, lower = self.of[a], self.of[b]
        if upper is lower:
            return
        x, y, z = lower.position[b]
        z += (self.world.edge[a] + self.world.edge[b]) / 2
        self._own(self._joined(upper, lower, _minus((x, y, z), upper.position[a])))

    def turn(self, name: str, quat: Quat) -> None:
        """Give a block its orientation."""
        self.of[name].orientation[name] = quat

    def resolve(self, operand: Operand) -> str:
        """The block that an operand stands for, as far as the pieces tell."""
        names = members(operand)
        if isinstance(operand, Highest | Lowest):
            sign = 1.0 if isinstance(operand, Highest) else -1.0
            return max(names, key=lambda n: sign * self.of[n].position[n][2])
        return names[0]

    def column_top(self, name: str) -> str:
        """The topmost block over `name` in its own piece."""
        piece = self.of[name]
        x, y, _ = piece.position[name]
        edge = self.world.edge[name]
        over = [n for n, (u, v, _) in piece.position.items() if max(abs(u - x), abs(v - y)) < 0.6 * edge]
        return max(over, key=lambda n: piece.position[n][2])

    def column_foot(self, name: str) -> str:
        """The lowest block under `name` in its own piece."""
        piece = self.of[name]
        x, y, _ = piece.position[name]
        edge = self.world.edge[name]
        under = [n for n, (u, v, _) in piece.position.items() if max(abs(u - x), abs(v - y)) < 0.6 * edge]
        return min(under, key=lambda n: piece.position[n][2])

    def _joined(self, moving: Piece, still: Piece, by: Vec3) -> Piece:
        """One piece of two, `moving` shifted by `by` unless it is the fixed one."""
        if moving.fixed and not still.fixed:
            moving, still, by = still, moving, (-by[0], -by[1], -by[2])
        elif moving.fixed and max(map(abs, by)) > AGREE:
            raise Clash
        position = dict(still.position)
        turns = dict(still.orientation)
        for name, place in moving.shifted(*by).items():
            if name in position and max(map(abs, _minus(place, position[name]))) > AGREE:
                raise Clash
            position[name] = position.get(name, place)
            turn = turns.get(name)
            # a block that keeps its place keeps its turn, whatever a structure would prefer
            turns[name] = turn if turn and still.fixed else _agreed(turn, moving.orientation[name])
        return Piece(position, turns, still.fixed)

    def _own(self, piece: Piece) -> None:
        self._grounded(piece)
        for name in piece.position:
            self.of[name] = piece

    def _grounded(self, piece: Piece) -> None:
        lowest = min(z - self.world.edge[n] / 2 for n, (_, _, z) in piece.position.items())
        if piece.fixed and lowest < -AGREE:
            raise Clash
        if not piece.fixed:
            piece.position = piece.shifted(0.0, 0.0, -lowest)

    def check(self) -> None:
        """Raise Clash where blocks of a piece overlap, hang in the air, or leave the workspace."""
        for piece in self.pieces():
            if piece.fixed and not all(
                _within(x, WORKSPACE_X) and _within(y, WORKSPACE_Y) for x, y, _ in piece.position.values()
            ):
                raise Clash
            mixed = len({self.world.edge[name] for name in piece.position}) > 1
            if (mixed or not piece.trusted) and len(piece.position) > 1 and not sound(piece, self.world):
                raise Clash


def _within(place: float, span: tuple[float, float]) -> bool:
    return span[0] - AGREE <= place <= span[1] + AGREE


def sound(piece: Piece, world: World) -> bool:
    """Does nothing in the piece overlap, float or topple?"""
    position = {n: (x, y, z + TABLE_Z) for n, (x, y, z) in piece.position.items()}
    state = BlockState(world, position, {n: q or IDENTITY for n, q in piece.orientation.items()})
    names = list(position)
    clear = all(body_gap(state, a, b) > -OVERLAP for a, b in _near_pairs(names, position, world))
    return clear and rests(state) and all(stands(state, name) for name in names)


def _near_pairs(names: list[str], position: dict[str, Vec3], world: World) -> Iterator[tuple[str, str]]:
    """Pairs whose bounding balls overlap."""
    for i, a in enumerate(names):
        for b in names[:i]:
            reach = 0.8661 * (world.edge[a] + world.edge[b])
            if all(abs(p - q) < reach for p, q in zip(position[a], position[b], strict=True)):
                yield a, b


def _agreed(a: Quat | None, b: Quat | None) -> Quat | None:
    if a is None or b is None:
        return a or b
    if abs(sum(p * q for p, q in zip(a, b, strict=True))) < 1.0 - AGREE:
        raise Clash
    return a


def _minus(a: Vec3, b: Vec3) -> Vec3:
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2])
