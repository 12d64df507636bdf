"""The arrangement solver: goal states for a goal expression, or the conditions in it that clash."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from functools import cached_property, lru_cache
from itertools import count, islice, product
from random import Random
from threading import Lock
from typing import NamedTuple

from rpg.blocks.arrange.alternatives import alternatives, lies_flat, single
from rpg.blocks.arrange.bounds import Bounds, Contradiction
from rpg.blocks.arrange.builds import layouts_of
from rpg.blocks.arrange.fixed import Poses, fixed_poses
from rpg.blocks.arrange.pieces import Assembly, Clash
from rpg.blocks.arrange.place import DENSE, NATURAL, VARIED, Budget, Exhausted, Search, Style
from rpg.blocks.arrange.rules import Way
from rpg.blocks.arrange.turning import orientation_for
from rpg.blocks.evaluate import rests, satisfied
from rpg.blocks.geometry import is_level
from rpg.blocks.predicate import Cluster
from rpg.blocks.state import BlockState, World, yaw_quat
from rpg.ir import goal as g
from rpg.ir.assets import Asset
from rpg.ir.node import members

MAX_ALTERNATIVES = 200
SPIN = 0.6
"""Greatest turn (radians) of a block that is turned for variety."""
MOST_COMBINED = 300
"""Combinations of layouts of several structures that are put together."""
LAYOUT_COST = 4
ASSEMBLY_COST = 8
"""What laying out a structure, and putting pieces together, costs in candidate places."""
LEAVES = 12
"""Arrangements of one layout that are checked against the whole goal."""


class Effort(NamedTuple):
    """How hard one sweep over the alternatives of a goal tries.

    `layouts` of the structures are tried for each alternative, `tries` candidate places judged for each layout.
    """

    layouts: int
    tries: int
    thorough: bool = False
    dense: bool = False
    hasty: bool = False

    def style(self, vary: bool) -> Style:
        """How places are chosen."""
        style = DENSE if self.dense else VARIED if vary else NATURAL
        return style._replace(hasty=self.hasty)


HARD = (Effort(3, 5000, dense=True), Effort(80, 3000, thorough=True))
THOROUGHLY = (Effort(12, 400), *HARD)
"""A quick look at every alternative comes before a long one at any; then closely packed, then unusual layouts."""
AT_A_GLANCE = (Effort(12, 400, hasty=True),)
"""Just whether there is a goal state."""
ANYHOW = (*AT_A_GLANCE, *HARD)
"""Any goal state, if there is one."""


class Solver:
    """Goal states of one goal in one world. `tries`: candidate places that may be judged in all, with these efforts."""

    def __init__(
        self,
        goal: g.Goal,
        world: World,
        start: BlockState | None,
        tries: int = 40000,
        efforts: Sequence[Effort] = THOROUGHLY,
    ) -> None:
        self.goal, self.world, self.start, self.tries, self.efforts = goal, world, start, tries, efforts
        self.reasons: list[Contradiction] = []

    def solve(self, rng: Random, vary: bool = False) -> BlockState | None:
        """A goal state; None where none is found. `vary`: any one rather than the most natural one."""
        budget = Budget(self.tries)
        ways: Iterable[Way] = self._ways
        if vary:
            ways = list(ways)
            rng.shuffle(ways)
        try:
            for effort in self.efforts:
                for way in ways:
                    state = self._sweep(way, rng, effort, budget, vary)
                    if state is not None:
                        return state
        except Exhausted:
            pass
        return None

    @cached_property
    def _ways(self) -> _Ways:
        """The alternatives of the goal; to look them up takes about as long as to place a block."""
        return _ways(self.goal, tuple(self.world.assets.values()))

    def _sweep(self, way: Way, rng: Random, effort: Effort, budget: Budget, vary: bool) -> BlockState | None:
        """A goal state that meets one alternative of the goal."""
        assemblies = self._assemblies(way, rng, effort, budget, vary)
        for assembly in islice(assemblies, effort.layouts):
            share = Budget(min(effort.tries, budget.left))
            before = share.left
            state = self._placed(assembly, way, rng, share, effort.style(vary))
            if state is not None:
                return state
            budget.spend(before - max(share.left, 0))
        return None

    def _placed(self, assembly: Assembly, way: Way, rng: Random, budget: Budget, style: Style) -> BlockState | None:
        try:
            bounds = Bounds(assembly, way.wanted)
        except Contradiction as reason:
            self.reasons.append(reason)
            return None
        if bounds.tight is not None:
            self.reasons.append(bounds.tight)
        search = Search(assembly, bounds, way.rules(assembly), rng, budget, self.start, style)
        try:
            for state in islice(search.run(), LEAVES):
                if satisfied(self.goal, state) and rests(state):
                    return state
        except Exhausted:
            pass
        return None

    def _assemblies(self, way: Way, rng: Random, effort: Effort, budget: Budget, vary: bool) -> Iterator[Assembly]:
        """Every way to lay out the structures of a conjunction and what stands on what."""
        fixed = fixed_poses(way.wanted, self.world, self.start)
        if fixed is None:
            return
        layouts = [builds for _, builds in layouts_of(way.literals, self.world, rng, effort.thorough, self.start)]
        budget.spend(LAYOUT_COST * sum(map(len, layouts)))
        if vary:
            for clusters in layouts:
                rng.shuffle(clusters)
        for chosen in islice(product(*layouts), MOST_COMBINED):
            budget.spend(ASSEMBLY_COST)
            assembly = Assembly(self.world)
            try:
                self._assemble(assembly, way, fixed, chosen)
            except Clash:
                continue
            if vary:
                self._spin(assembly, way, rng)
            yield assembly

    def _spin(self, assembly: Assembly, way: Way, rng: Random) -> None:
        """Turn blocks about the vertical that may be turned in any way, so that goal states differ in this as well."""
        for piece in assembly.pieces():
            upright = len({place[:2] for place in piece.position.values()}) == 1
            for name in piece.position if upright and not piece.fixed else ():
                if piece.orientation[name] is None and name not in way.square:
                    piece.orientation[name] = yaw_quat(rng.choice((0.0, rng.uniform(-SPIN, SPIN))))

    def _assemble(self, assembly: Assembly, way: Way, fixed: Poses, chosen: tuple[list[Cluster], ...]) -> None:
        assembly.fix(fixed)
        for clusters in chosen:
            for cluster in clusters:
                assembly.add(cluster)
        for on in way.stacked:
            a, b = assembly.resolve(on.a), assembly.resolve(on.b)
            if a == b:
                raise Clash
            assembly.put_on(a, b)
        for above in way.above:
            for a in members(above.a):
                for b in members(above.b):
                    assembly.put_on(assembly.column_foot(a), assembly.column_top(b))
        self._turn(assembly, way)
        assembly.check()

    def _turn(self, assembly: Assembly, way: Way) -> None:
        for name, wanted in way.turns.items():
            quat = orientation_for(name, wanted, self.world, self.start, assembly.of[name].orientation[name])
            if quat is None:
                raise Clash
            flat = BlockState(self.world, {name: (0.0, 0.0, 0.0)}, {name: quat})
            if not is_level(flat, name):
                raise Clash
            assembly.turn(name, quat)


class _Ways:
    """The alternatives of a goal that are tried, each made when it is asked for first: most often one will do."""

    def __init__(self, goal: g.Goal, world: World) -> None:
        self._made: list[Way] = []
        found = filter(lies_flat, islice(alternatives(goal, world), MAX_ALTERNATIVES))
        self._coming = (Way(single(literals), world) for literals in found)
        self._making = Lock()

    def __iter__(self) -> Iterator[Way]:
        for number in count():
            if number == len(self._made):
                with self._making:
                    self._made += islice(self._coming, number + 1 - len(self._made))
            if number == len(self._made):
                return
            yield self._made[number]


@lru_cache(maxsize=32)
def _ways(goal: g.Goal, assets: tuple[Asset, ...]) -> _Ways:
    """The same ones for every start and every further goal state."""
    return _Ways(goal, World(assets))


def imagined_start(world: World, rng: Random) -> BlockState | None:
    """Blocks scattered over the table: a start for conditions that speak of one where none is given."""
    return Solver(g.All(goals=()), world, None).solve(rng, vary=True)
