"""How much room a structure would need, where it does not fit into the workspace."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import islice
from random import Random

from rpg.blocks.arrange.bounds import Contradiction
from rpg.blocks.constants import WORKSPACE_X, WORKSPACE_Y
from rpg.blocks.predicate import Cluster
from rpg.blocks.predicates import PREDICATES
from rpg.blocks.state import World
from rpg.ir import goal as g
from rpg.ir.assets import GoalPatch
from rpg.ir.order import Order
from rpg.ir.structures import Row

SHRUNK = (0.75, 0.5, 0.25)
"""Shares of their size at which the blocks of a structure are tried."""
LENGTHS = (WORKSPACE_X[1] - WORKSPACE_X[0], WORKSPACE_Y[1] - WORKSPACE_Y[0])


def oversize(atom: g.Atom, world: World) -> Contradiction | None:
    """The length that a structure takes, if there is no way to build it in its size but there is in a smaller one."""
    predicate = PREDICATES[atom.kind]
    if next(predicate.build(atom, world, Random(0)), None) is not None:
        return None
    if isinstance(atom, Row):
        return _long_row(atom, world)
    for share in SHRUNK:
        small = _shrunk(world, share)
        for clusters in islice(predicate.build(atom, small, Random(0)), 1):
            lengths = [_extent(clusters, axis, small) / share for axis in (0, 1)]
            axis = max((0, 1), key=lambda k: lengths[k] - LENGTHS[k])
            return Contradiction((atom,), axis, lengths[axis], LENGTHS[axis])
    return None


def _shrunk(world: World, share: float) -> World:
    assets = [
        asset if isinstance(asset, GoalPatch) else asset.model_copy(update={"size": asset.size * share})
        for asset in world.assets.values()
    ]
    return World(assets)


def _extent(clusters: list[Cluster], axis: int, world: World) -> float:
    """Length along an axis from face to face, of the longest cluster."""
    return max(max(_ends(c, axis, world, 1)) - min(_ends(c, axis, world, -1)) for c in clusters)


def _ends(cluster: Cluster, axis: int, world: World, side: int) -> Iterator[float]:
    return (place[axis] + side * world.edge[n] / 2 for n, (place, _) in cluster.poses.items())


def _long_row(row: Row, world: World) -> Contradiction | None:
    axis = 0 if row.axis == "x" else 1
    needed = _side_by_side(row, world)
    return Contradiction((row,), axis, needed, LENGTHS[axis]) if needed > LENGTHS[axis] else None


def most_that_fit(row: Row, world: World) -> int:
    """How many of a row's blocks would still stand side by side within the workspace."""
    for count in range(len(row.blocks) - 1, 1, -1):
        shorter = row.model_copy(update={"blocks": row.blocks[:count], "order": Order()})
        if next(PREDICATES["row"].build(shorter, world, Random(0)), None) is not None:
            return count
    return 0


def _side_by_side(row: Row, world: World) -> float:
    """Length of a row from face to face with the least gaps that it allows."""
    edges = [world.edge[name] for name in row.blocks]
    if row.spacing is not None:
        return row.spacing * (len(edges) - 1) + (edges[0] + edges[-1]) / 2
    return sum(edges) + (row.gap or 0.0) * (len(edges) - 1)
