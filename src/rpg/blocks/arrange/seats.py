"""Which block goes where in a structure that leaves it open: blocks change places until further conditions hold."""

from __future__ import annotations

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
    position = {name: (x + FAR * piece, y, z + TABLE_Z) for name, (piece, (x, y, z), _) in seats.items()}
    position |= {name: (FAR * (pieces + k), 0.0, TABLE_Z + world.edge[name] / 2) for k, name in enumerate(spare)}
    return BlockState(world, position, {name: quat or IDENTITY for name, (_, _, quat) in seats.items()})


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
    faults = table.at_first
    if faults == 0.0:
        return None
    rng = Random(len(table.seats))
    for attempt in range(RESTARTS if thorough else 1):
        if attempt:
            table.shuffle(rng)
            faults = table.faults()
        if table.improved(faults):
            return table.clusters()
    return None


class _Table:
    """Blocks in the seats of a structure, far from everything else."""

    def __init__(self, atom: g.Atom, clusters: Sequence[Cluster], asked: list[Literal], world: World) -> None:
        self.atom, self.asked, self.world = atom, asked, world
        self.count = len(clusters)
        self.seats: Seats = {
            n: (k, place, quat) for k, c in enumerate(clusters) for n, (place, quat) in c.poses.items()
        }
        state = self._state()
        self.whole = PREDICATES[atom.kind].evaluate(atom, state).value
        self.at_first = self._unmet(state)

    def improved(self, faults: float) -> bool:
        """Exchange the pair that helps most until no exchange helps; do all conditions hold then?"""
        for _ in range(ROUNDS):
            better, pair = min(((self.faults_after(*pair), pair) for pair in self.pairs()), default=(faults, None))
            if pair is None or better >= faults:
                break
            self.exchange(*pair)
            faults = better
            if faults == 0.0:
                break
        return faults < 1.0

    def shuffle(self, rng: Random) -> None:
        """Exchange a few pairs by chance."""
        pairs = self.pairs()
        for pair in rng.sample(pairs, min(len(pairs), SHUFFLED)):
            self.exchange(*pair)

    def pairs(self) -> list[tuple[str, str]]:
        """Blocks that may change places and do not look alike."""
        edge, look = self.world.edge, self.world.look
        return [(a, b) for a, b in combinations(self.seats, 2) if edge[a] == edge[b] and look[a] != look[b]]

    def exchange(self, a: str, b: str) -> None:
        """Let two blocks change seats; one that may be turned in any way stays so."""
        (i, p, q), (j, r, s) = self.seats[a], self.seats[b]
        free = q is None or s is None
        self.seats[a], self.seats[b] = (j, r, q if free else s), (i, p, s if free else q)

    def faults_after(self, a: str, b: str) -> float:
        self.exchange(a, b)
        found = self.faults()
        self.exchange(a, b)
        return found

    def faults(self) -> float:
        """How far the conditions are from holding: below 1 when all do, 0 when none of them barely."""
        state = self._state()
        spoilt = self.whole and not PREDICATES[self.atom.kind].evaluate(self.atom, state).value
        return self._unmet(state) + (SPOILT if spoilt else 0.0)

    def _unmet(self, state: BlockState) -> float:
        """What the conditions amount to, the structure apart."""
        found = 0.0
        for atom, wanted, _ in self.asked:
            verdict = PREDICATES[atom.kind].evaluate(atom, state)
            if verdict.value != wanted:
                found += 1.0 + min(abs(verdict.margin), 5.0) / 10.0
            elif abs(verdict.margin) < THIN:
                found += 0.1
        return found

    def clusters(self) -> list[Cluster]:
        parts: list[dict[str, tuple[Vec3, Quat | None]]] = [{} for _ in range(self.count)]
        for name, (k, place, quat) in self.seats.items():
            parts[k][name] = (place, quat)
        return [Cluster(poses) for poses in parts]

    def _state(self) -> BlockState:
        return alone(self.atom, self.seats, self.world)
