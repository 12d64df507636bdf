"""Ways to lay out one structure: those that its predicate builds, and wider ones where it leaves the spacing open."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import islice
from random import Random

from rpg.blocks.arrange.alternatives import Conjunction
from rpg.blocks.arrange.seats import alone, reseated
from rpg.blocks.predicate import Cluster
from rpg.blocks.predicates import PREDICATES
from rpg.blocks.predicates.common import SPANS
from rpg.blocks.predicates.row import lay
from rpg.blocks.state import BlockState, World
from rpg.ir import goal as g
from rpg.ir import structures
from rpg.ir.node import Node, members
from rpg.ir.relations import Shifted
from rpg.ir.walk import names

STRUCTURES = frozenset(
    model.model_fields["kind"].default
    for model in vars(structures).values()
    if isinstance(model, type) and issubclass(model, Node) and "kind" in model.model_fields
)
ABSOLUTE = frozenset(
    {
        *("in_region", "on_patch", "empty", "facing", "stayed", "moved", "shifted", "approached", "receded"),
        *("swapped", "took_place", "turned"),
    }
)
"""Atoms about places in the world, even where their blocks are of one piece."""
TEXTS = frozenset({"spells", "equation"})
MOST_RESEATED = 3
MAX_BUILDS = 12
MOST_BUILDS = 40
MOST_STRETCHED = 24
STRETCHES = (1.5, 1.25)


def layouts_of(
    literals: Conjunction, world: World, rng: Random, thorough: bool, start: BlockState | None = None
) -> Iterator[tuple[g.Atom, list[list[Cluster]]]]:
    """For every structure that must be, ways to lay it out, most natural first. `thorough`: unusual ones as well.

    Where the blocks of one structure are all part of another one, it may have nothing to lay out itself; else, where
    there is no way to lay it out, there is none to arrange the whole.
    """
    wanted = [literal.atom for literal in literals if literal.holds]
    lines = [atom for atom in wanted if isinstance(atom, structures.Row) and atom.order.by == "any"]
    found = [(atom, *_builds(atom, lines, world, rng, thorough)) for atom in wanted if atom.kind in STRUCTURES]
    for atom, usual, wide in found:
        if start is not None and _moves_as_one(atom, wanted) and PREDICATES[atom.kind].evaluate(atom, start).value:
            yield atom, [[_as_begun(atom, start)], *usual]
            continue
        inside = set(names(atom))
        asked = [part for part in literals if part.atom is not atom and _within(part.atom, inside)]
        if any(_covers(other, atom) or _parts_of(other, atom) for other, *_ in found):
            yield atom, [[], *usual, *wide]
            continue
        first = [*usual[: MOST_RESEATED if thorough else 1], *wide[:MOST_RESEATED]] if asked else []
        seated = [reseated(atom, clusters, asked, world, thorough) for clusters in first]
        yield atom, [*(clusters for clusters in seated if clusters is not None), *usual, *wide]


def _moves_as_one(atom: g.Atom, wanted: list[g.Atom]) -> bool:
    """Is every block of a structure to go the same way, and as far?"""
    shifts = [part for part in wanted if isinstance(part, Shifted)]
    ways = {(part.toward, part.at_least, part.at_most) for part in shifts}
    return len(ways) == 1 and {*names(atom)} <= {name for part in shifts for name in members(part.a)}


def _as_begun(atom: g.Atom, start: BlockState) -> Cluster:
    """The blocks of a structure as they stand at the start."""
    blocks = names(atom)
    (x, y, _), low = start.position[blocks[0]], min(map(start.bottom, blocks))
    return Cluster(
        {
            name: ((u - x, v - y, w - low), start.orientation.get(name))
            for name in blocks
            for u, v, w in (start.position[name],)
        }
    )


def _covers(other: g.Atom, atom: g.Atom) -> bool:
    """Do the blocks of `atom` all have their places by `other`? Of two with the same blocks, a group is the looser, and
    a line or a stack is looser than a text."""
    if other is atom or other.kind == "group_by":
        return False
    mine, theirs = set(names(atom)), set(names(other))
    looser = atom.kind == "group_by" or (atom.kind in ("row", "stack") and other.kind in TEXTS)
    return mine < theirs or (mine == theirs and looser)


def _parts_of(other: g.Atom, atom: g.Atom) -> bool:
    """Is `other` a structure within a group, so that the group is better put together of such pieces?"""
    return atom.kind == "group_by" and other.kind != "group_by" and len(set(names(atom)) & set(names(other))) > 1


def _within(atom: g.Atom, blocks: set[str]) -> bool:
    return atom.kind not in ABSOLUTE and blocks.issuperset(names(atom))


def _builds(
    atom: g.Atom, lines: list[structures.Row], world: World, rng: Random, thorough: bool
) -> tuple[list[list[Cluster]], list[list[Cluster]]]:
    """The usual ways to lay a structure out, and wider ones; a text as far apart as a line of its blocks is."""
    found = list(islice(PREDICATES[atom.kind].build(atom, world, rng), MOST_BUILDS if thorough else MAX_BUILDS))
    line = next((line for line in lines if atom.kind in TEXTS and set(line.blocks) == set(names(atom))), None)
    if line is not None:
        found = [[laid] for clusters in found if (laid := _respaced(clusters[0], line, world)) is not None]
    if not thorough or any(name in world.patches for name in names(atom)):
        return found, []
    wider = [
        [stretched]
        for factor in STRETCHES
        for clusters in found[:MOST_STRETCHED]
        if len(clusters) == 1 and (stretched := _stretched(atom, clusters[0], factor, world)) is not None
    ]
    return found, wider


def _respaced(text: Cluster, line: structures.Row, world: World) -> Cluster | None:
    """A text from left to right with the spacing of `line`; None where the workspace has no room for it."""
    sequence = sorted(text.poses, key=lambda name: -text.poses[name][0][1])
    return lay(line.model_copy(update={"axis": "y", "readable": True}), sequence, 0.0, world)


def _stretched(atom: g.Atom, cluster: Cluster, factor: float, world: World) -> Cluster | None:
    """A flat cluster with its spacing wider by a factor, where the structure allows that and the workspace has room."""
    places = [place for place, _ in cluster.poses.values()]
    flat = all(place[2] <= world.edge[name] / 2 + 1e-6 for name, (place, _) in cluster.poses.items())
    wide = any(factor * (max(p[k] for p in places) - min(p[k] for p in places)) > SPANS["xy"[k]] for k in (0, 1))
    if not flat or wide or cluster.fixed:
        return None
    poses = {name: ((factor * x, factor * y, z), quat) for name, ((x, y, z), quat) in cluster.poses.items()}
    made = Cluster(poses)
    seats = {name: (0, *pose) for name, pose in poses.items()}
    return made if PREDICATES[atom.kind].evaluate(atom, alone(atom, seats, world)).margin > 0.05 else None
