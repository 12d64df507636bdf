"""Ways to lay out one structure: those that its predicate builds, and wider ones where it leaves the spacing open."""

from __future__ import annotations

from itertools import islice
from random import Random

from rpg.blocks.constants import TABLE_Z
from rpg.blocks.predicate import Cluster
from rpg.blocks.predicates import PREDICATES
from rpg.blocks.predicates.common import SPANS
from rpg.blocks.state import IDENTITY, BlockState, World
from rpg.ir import goal as g
from rpg.ir.walk import names

MAX_BUILDS = 12
MOST_BUILDS = 40
MOST_STRETCHED = 24
STRETCHES = (1.5, 1.25)
CENTRE = (0.55, 0.0)


def builds_of(atom: g.Atom, world: World, rng: Random, thorough: bool) -> list[list[Cluster]]:
    """Layouts of a structure, most natural first; none for a relation. `thorough`: unusual ones as well."""
    found = list(islice(PREDICATES[atom.kind].build(atom, world, rng), MOST_BUILDS if thorough else MAX_BUILDS))
    if not thorough or any(name in world.patches for name in names(atom)):
        return found
    wider = (
        stretched
        for factor in STRETCHES
        for clusters in found[:MOST_STRETCHED]
        if len(clusters) == 1 and (stretched := _stretched(atom, clusters[0], factor, world)) is not None
    )
    return [*found, *([cluster] for cluster in wider)]


def _stretched(atom: g.Atom, cluster: Cluster, factor: float, world: World) -> Cluster | None:
    """A flat cluster with its spacing wider by a factor, where the structure allows that and the workspace has room."""
    places = [place for place, _ in cluster.poses.values()]
    flat = all(place[2] <= world.edge[name] / 2 + 1e-6 for name, (place, _) in cluster.poses.items())
    wide = any(factor * (max(p[k] for p in places) - min(p[k] for p in places)) > SPANS["xy"[k]] for k in (0, 1))
    if not flat or wide or cluster.fixed:
        return None
    poses = {name: ((factor * x, factor * y, z), quat) for name, ((x, y, z), quat) in cluster.poses.items()}
    position = {n: (x + CENTRE[0], y + CENTRE[1], z + TABLE_Z) for n, ((x, y, z), _) in poses.items()}
    state = BlockState(world, position, {n: quat or IDENTITY for n, (_, quat) in poses.items()})
    return Cluster(poses) if PREDICATES[atom.kind].evaluate(atom, state).margin > 0.05 else None
