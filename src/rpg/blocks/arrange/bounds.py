"""Difference constraints: what the goal's directions, regions and the workspace say about each coordinate.

"a at least d beyond b" is an edge of weight d in a graph of pieces, one graph for x and one for y. A cycle of positive
weight proves that no arrangement exists, and its edges name the conditions that clash. Longest paths bound where a
piece may go once others are placed, so that a search never paints itself into a corner.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator
from itertools import product
from typing import NamedTuple

from rpg.blocks.arrange.pieces import Assembly, Piece
from rpg.blocks.constants import WORKSPACE_X, WORKSPACE_Y
from rpg.blocks.predicates.common import BORDER
from rpg.blocks.predicates.direction import DIRECTIONS, edge_between, least_offset
from rpg.blocks.predicates.region import CORNER, EDGE_DEPTH
from rpg.blocks.state import BlockState
from rpg.ir import goal as g
from rpg.ir.node import Highest, Lowest, Operand, members
from rpg.ir.relations import (
    Adjacent,
    Behind,
    Beside,
    Distance,
    InFrontOf,
    InRegion,
    LeftOf,
    Near,
    OnPatch,
    RightOf,
    Touching,
)

WORKSPACE = (WORKSPACE_X, WORKSPACE_Y)
GROUND = 0
SPARE = 0.005
"""Room (m) that directions are given beyond what they ask for, where there is enough."""
Aimed = LeftOf | RightOf | InFrontOf | Behind
TELLING = frozenset({*DIRECTIONS, "on_patch", "in_region", "near", "beside", "adjacent", "distance"})
"""Atoms that say something of coordinates."""
ROOT2 = math.sqrt(2.0)


class Edge(NamedTuple):
    """Origin of piece `head` at least `weight` beyond that of `tail`; `atom` says so (None: the workspace does)."""

    tail: int
    head: int
    weight: float
    atom: g.Atom | None


class Contradiction(Exception):
    """A cycle of constraints that cannot all hold: its atoms, and where the workspace is part of it, the lengths."""

    def __init__(self, atoms: tuple[g.Atom, ...], axis: int, needed: float | None, available: float) -> None:
        super().__init__("no coordinates satisfy these conditions")
        self.atoms = atoms
        self.axis = axis
        self.needed = needed
        self.available = available


class Bounds:
    """Intervals for the origins of pieces, given the origins of those that are placed."""

    def __init__(self, assembly: Assembly, atoms: Iterable[g.Atom]) -> None:
        self.world = assembly.world
        self.assembly = assembly
        self.pieces = assembly.pieces()
        self.index = {id(piece): k + 1 for k, piece in enumerate(self.pieces)}
        told = list(atoms)
        kept = [atom for atom in told if atom.kind in TELLING]
        self.touching = {
            frozenset(pair)
            for atom in told
            if isinstance(atom, Touching)
            for pair in product(members(atom.a), members(atom.b))
        }
        """Pairs that are to touch, which leaves directions no room beyond what they ask for."""
        self.tight: Contradiction | None = None
        """Why the conditions leave no room to spare, where they do not."""
        self.longest: list[list[list[float]]] = []
        self.active: list[list[int]] = []
        self.rooms = [[_workspace(piece, axis) for piece in self.pieces] for axis in (0, 1)]
        for axis in (0, 1):
            try:
                self._close(axis, kept, SPARE)
            except Contradiction as tight:
                self.tight = tight
                self._close(axis, kept, 0.0)

    def interval(self, piece: Piece, axis: int, placed: dict[int, tuple[float, float]]) -> tuple[float, float]:
        """Least and greatest origin of `piece` along an axis; `placed` maps id(piece) to origins."""
        k = self.index[id(piece)]
        low, high = self.rooms[axis][k - 1]
        table = self.longest[axis]
        row = table[k]
        if not row:
            return low, high
        low, high = max(low, table[GROUND][k]), min(high, -row[GROUND])
        for other in self.active[axis]:
            origin = placed.get(id(self.pieces[other - 1]))
            if origin is not None:
                low = max(low, origin[axis] + table[other][k])
                high = min(high, origin[axis] - row[other])
        return low, high

    def _close(self, axis: int, atoms: list[g.Atom], spare: float) -> None:
        edges = [edge for atom in atoms for edge in self._edges(atom, axis, spare)]
        touched = sorted({k for edge in edges for k in (edge.tail, edge.head) if k != GROUND})
        for k, (low, high) in enumerate(self.rooms[axis], start=1):
            if low > high + 1e-9:
                raise Contradiction((), axis, WORKSPACE[axis][1] - WORKSPACE[axis][0] + low - high, _length(axis))
            if k in touched:
                edges += [Edge(GROUND, k, low, None), Edge(k, GROUND, -high, None)]
        table = _longest_paths(len(self.pieces) + 1, [GROUND, *touched], edges, axis)
        del self.longest[axis:], self.active[axis:]
        self.longest.append(table)
        self.active.append(touched)

    def _edges(self, atom: g.Atom, axis: int, spare: float) -> Iterator[Edge]:
        match atom:
            case LeftOf() | RightOf() | InFrontOf() | Behind():
                yield from self._directional(atom, axis, spare)
            case OnPatch():
                patch = self.world.patches[atom.patch]
                if patch.position is not None and not isinstance(atom.a, Lowest | Highest):
                    low, high = (patch.position[axis] + s * patch.size[axis] / 2 for s in (-1, 1))
                    yield from (e for a in members(atom.a) for e in self._inside(a, axis, low, high, atom))
            case InRegion():
                if not isinstance(atom.a, Lowest | Highest):
                    low, high = region_interval(atom.region, axis)
                    yield from (e for a in members(atom.a) for e in self._inside(a, axis, low, high, atom))
            case Near() | Beside() | Adjacent() | Distance():
                yield from self._close_to(atom, axis)
            case _:
                return

    def _directional(self, atom: Aimed, axis: int, spare: float) -> Iterator[Edge]:
        direction = DIRECTIONS[atom.kind]
        empty = BlockState(self.world, {}, {})
        left, right = self._known(atom.a), self._known(atom.b)
        ranked = [sorted(names, key=lambda name: self._anchor(name, axis)[1]) for names in (left, right)]
        # Of two groups each block of the smaller one is put straight before or behind its like in the order across.
        pairs = {*product(left, right)} if len(right) == 1 else {*zip(*ranked, strict=False)}
        for a in left:
            for b in right:
                edge = edge_between(empty, a, b)
                if direction[axis] != 0.0:
                    least = least_offset(atom, a, b, empty) + (0.0 if frozenset((a, b)) in self.touching else spare)
                    high, low = (a, b) if direction[axis] > 0 else (b, a)
                    yield from self._beyond(low, high, least, axis, atom)
                    if atom.immediate and a in self.world.edge and b in self.world.edge:
                        reach = ROOT2 * (self.world.edge[a] + self.world.edge[b]) / 2 + atom.gap_edges * edge
                        yield from self._beyond(high, low, -reach, axis, atom)
                elif atom.directly and (a, b) in pairs:
                    yield from self._beyond(a, b, -atom.across_edges * edge, axis, atom)
                    yield from self._beyond(b, a, -atom.across_edges * edge, axis, atom)

    def _close_to(self, atom: Near | Beside | Adjacent | Distance, axis: int) -> Iterator[Edge]:
        left, right = self._known(atom.a), self._known(atom.b)
        if len(left) != 1 or len(right) != 1 or not {left[0], right[0]} <= set(self.world.edge):
            return
        a, b = left[0], right[0]
        width = ROOT2 * (self.world.edge[a] + self.world.edge[b]) / 2
        match atom:
            case Near():
                reach = atom.distance
            case Distance():
                if atom.maximum is None:
                    return
                reach = atom.maximum + (width if atom.measure == "faces" else 0.0)
            case _:
                reach = width + atom.gap_edges * max(self.world.edge[a], self.world.edge[b])
        yield from self._beyond(a, b, -reach, axis, atom)
        yield from self._beyond(b, a, -reach, axis, atom)

    def _known(self, operand: Operand) -> tuple[str, ...]:
        """The objects of an operand, as far as the pieces tell which they are."""
        if isinstance(operand, Lowest | Highest):
            homes = {id(self.assembly.of[n]) for n in members(operand)}
            return (self.assembly.resolve(operand),) if len(homes) == 1 else ()
        return members(operand)

    def _inside(self, name: str, axis: int, low: float, high: float, atom: g.Atom) -> Iterator[Edge]:
        if name in self.assembly.of:
            piece = self.assembly.of[name]
            k, at = self.index[id(piece)], piece.position[name][axis]
            if low > -math.inf:
                yield Edge(GROUND, k, low - at, atom)
            if high < math.inf:
                yield Edge(k, GROUND, at - high, atom)

    def _beyond(self, low: str, high: str, least: float, axis: int, atom: g.Atom) -> Iterator[Edge]:
        """`high` at least `least` beyond `low`."""
        i, at_low = self._anchor(low, axis)
        j, at_high = self._anchor(high, axis)
        weight = least + at_low - at_high
        if i == j:
            if weight > 1e-6:
                raise Contradiction((atom,), axis, None, _length(axis))
        else:
            yield Edge(i, j, weight, atom)

    def _anchor(self, name: str, axis: int) -> tuple[int, float]:
        patch = self.world.patches.get(name)
        if patch is not None:
            return GROUND, (patch.position or (0.0, 0.0))[axis]
        piece = self.assembly.of[name]
        return self.index[id(piece)], piece.position[name][axis]


def _workspace(piece: Piece, axis: int) -> tuple[float, float]:
    """Least and greatest origin at which a piece is within the workspace."""
    if piece.fixed:
        return 0.0, 0.0
    places = [place[axis] for place in piece.position.values()]
    low, high = WORKSPACE[axis]
    return low + BORDER - min(places), high - BORDER - max(places)


def region_interval(region: str, axis: int) -> tuple[float, float]:
    """The interval that a region leaves for a coordinate; infinite where the region says nothing of it."""
    low, high = WORKSPACE[axis]
    near_side, far_side = (("near", "far"), ("right", "left"))[axis]
    parts = region.split("_")
    depth = CORNER[axis] if parts[-1] == "corner" else EDGE_DEPTH if parts[-1] == "edge" else (high - low) / 2
    if near_side in parts:
        return -math.inf, low + depth
    if far_side in parts:
        return high - depth, math.inf
    return -math.inf, math.inf


def _length(axis: int) -> float:
    return WORKSPACE[axis][1] - WORKSPACE[axis][0]


def _longest_paths(size: int, nodes: list[int], edges: list[Edge], axis: int) -> list[list[float]]:
    """All-pairs longest paths among `nodes` (rows of other nodes stay empty); raises on a cycle of positive weight."""
    table: list[list[float]] = [[] for _ in range(size)]
    for k in nodes:
        table[k] = [-math.inf] * size
        table[k][k] = 0.0
    via: dict[tuple[int, int], tuple[Edge, ...]] = {}
    for edge in edges:
        if edge.weight > table[edge.tail][edge.head]:
            table[edge.tail][edge.head] = edge.weight
            via[edge.tail, edge.head] = (edge,)
    for mid in nodes:
        row = table[mid]
        for i in nodes:
            lead = table[i][mid]
            if lead == -math.inf or i == mid:
                continue
            for j in nodes:
                weight = lead + row[j]
                if j != mid and weight > table[i][j] + 1e-9:
                    path = via[i, mid] + via[mid, j]
                    if i == j:
                        raise _contradiction(path, axis)
                    table[i][j] = weight
                    via[i, j] = path
    return table


def _contradiction(path: tuple[Edge, ...], axis: int) -> Contradiction:
    atoms: list[g.Atom] = []
    for edge in path:
        if edge.atom is not None and all(edge.atom is not other for other in atoms):
            atoms.append(edge.atom)
    needed = None
    if any(edge.atom is None for edge in path):
        needed = sum(edge.weight for edge in path) + _length(axis)
    return Contradiction(tuple(atoms), axis, needed, _length(axis))
