"""Which block goes where in a structure that leaves it open: blocks change places until further conditions hold."""

from __future__ import annotations

import math
from collections.abc import Sequence
from itertools import combinations
from random import Random

from rpg.blocks.arrange.alternatives import Literal
from rpg.blocks.constants import TABLE_Z
from rpg.blocks.predicate import Cluster
from rpg.blocks.predicates import PREDICATES
from rpg.blocks.state import IDENTITY, BlockState, Quat, Vec3, World
from rpg.ir import goal as g
from rpg.ir.walk import names

UPRIGHT = frozenset({"on", "above", "clear", "stack"})
"""Conditions that do not depend on where the pieces of a structure stand relative to each other."""
FAR = 5.0
"""Distance (m) at which the pieces of a structure are judged, so that none is near another."""
ROUNDS = 10
THIN = 0.05
"""A condition that holds by less than this share of its tolerance could be met better."""
RESTARTS = 4
SHUFFLED = 3
SPOILT = 10.0
"""How much worse a structure that no longer holds is than a condition that does not."""


Seats = dict[str, tuple[int, Vec3, Quat | None]]
"""By block: the piece of the structure it is in, its place there, and its turn if that matters."""


def alone(atom: g.Atom, seats: Seats, world: World) -> BlockState:
    """A structure by itself, its pieces and the blocks that it has no seat for far from each other."""
    pieces = 1 + max(piece for piece, _, _ in seats.values())
    spare = [name for name in names(atom) if name in world.blocks and name not in seats]
    poses = {name: _pose(seat) for name, seat in seats.items()}
    position = {name: place for name, (place, _) in poses.items()}
    position |= {name: (FAR * (pieces + k), 0.0, TABLE_Z + world.edge[name] / 2) for k, name in enumerate(spare)}
    return BlockState(world, position, {name: quat for name, (_, quat) in poses.items()})


def _pose(seat: tuple[int, Vec3, Quat | None]) -> tuple[Vec3, Quat]:
    piece, (x, y, z), quat = seat
    return (x + FAR * piece, y, z + TABLE_Z), quat or IDENTITY


def reseated(
    atom: g.Atom, clusters: Sequence[Cluster], asked: Sequence[Literal], world: World, thorough: bool
) -> list[Cluster] | None:
    """The layout with blocks of one size exchanged so that `asked` holds; None if that is not found, or needed.

    Of `asked`, what mentions blocks that the structure leaves without a place (a letter its word does not need) waits.
    """
    seats = {name for cluster in clusters for name in cluster.poses}
    kept = [
        literal
        for literal in asked
        if seats.issuperset(names(literal.atom)) and (len(clusters) == 1 or literal.atom.kind in UPRIGHT)
    ]
    if not kept or any(cluster.fixed for cluster in clusters):
        return None
    table = _Table(atom, clusters, kept, world)
    if table.faults == 0.0:
        return None
    rng = Random(len(table.seats))
    for attempt in range(RESTARTS if thorough else 1):
        if attempt:
            table.shuffle(rng)
        if table.improved():
            return table.clusters()
    return None


class _Table:
    """Blocks in the seats of a structure, far from everything else.

    `faults`: how far the conditions are from holding: below 1 when all do, 0 when none of them barely.
    """

    def __init__(self, atom: g.Atom, clusters: Sequence[Cluster], asked: list[Literal], world: World) -> None:
        self.atom, self.asked, self.world = atom, asked, world
        self.count = len(clusters)
        self.seats: Seats = {
            n: (k, place, quat) for k, c in enumerate(clusters) for n, (place, quat) in c.poses.items()
        }
        self.state = alone(atom, self.seats, world)
        self.whole = False
        self.faults = self._found()
        self.whole = self.faults > 0.0 and self._stands()

    def improved(self) -> bool:
        """Exchange the pair that helps most until no exchange helps; do all conditions hold then?"""
        pairs = sorted(self.pairs())
        for _ in range(ROUNDS):
            best = None
            for pair in pairs:
                self.exchange(*pair)
                found = self._found(self.faults)
                self.exchange(*pair)
                if found < self.faults:
                    best, self.faults = pair, found
            if best is None:
                break
            self.exchange(*best)
            if self.faults == 0.0:
                break
        return self.faults < 1.0

    def shuffle(self, rng: Random) -> None:
        """Exchange a few pairs by chance."""
        pairs = self.pairs()
        for pair in rng.sample(pairs, min(len(pairs), SHUFFLED)):
            self.exchange(*pair)
        self.faults = self._found()

    def pairs(self) -> list[tuple[str, str]]:
        """Blocks that may change places and do not look alike."""
        edge, look = self.world.edge, self.world.look
        return [(a, b) for a, b in combinations(self.seats, 2) if edge[a] == edge[b] and look[a] != look[b]]

    def exchange(self, a: str, b: str) -> None:
        """Let two blocks change seats; one that may be turned in any way stays so."""
        (i, p, q), (j, r, s) = self.seats[a], self.seats[b]
        free = q is None or s is None
        self.seats[a], self.seats[b] = (j, r, q if free else s), (i, p, s if free else q)
        self.state = self.state.moved({name: _pose(self.seats[name]) for name in (a, b)})

    def _found(self, most: float = math.inf) -> float:
        """The faults of the blocks as they sit; where there are no fewer than `most`, just that many or more."""
        found = 0.0
        for atom, wanted, _ in self.asked:
            predicate = PREDICATES[atom.kind]
            if not wanted and predicate.plainly_not(atom, self.state):
                continue
            verdict = predicate.evaluate(atom, self.state)
            if verdict.value != wanted:
                found += 1.0 + min(abs(verdict.margin), 5.0) / 10.0
            elif abs(verdict.margin) < THIN:
                found += 0.1
            if found >= most:
                return found
        return found + SPOILT if self.whole and not self._stands() else found

    def _stands(self) -> bool:
        """Does the structure itself hold?"""
        return PREDICATES[self.atom.kind].holds(self.atom, self.state)

    def clusters(self) -> list[Cluster]:
        parts: list[dict[str, tuple[Vec3, Quat | None]]] = [{} for _ in range(self.count)]
        for name, (k, place, quat) in self.seats.items():
            parts[k][name] = (place, quat)
        return [Cluster(poses) for poses in parts]
