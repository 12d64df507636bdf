"""Places pieces on the table by search: proposals around what is placed, judged by the atoms that they complete."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace
from itertools import islice
from math import hypot
from operator import itemgetter
from random import Random
from typing import NamedTuple

from rpg.blocks.arrange.bounds import Bounds
from rpg.blocks.arrange.ground import Ground
from rpg.blocks.arrange.pieces import Assembly, Piece
from rpg.blocks.arrange.rules import Rule
from rpg.blocks.constants import TABLE_Z, WORKSPACE_X, WORKSPACE_Y
from rpg.blocks.state import IDENTITY, BlockState, Quat, Vec3
from rpg.ir.relations import Apart
from rpg.ir.structures import GroupBy

GRADUAL = frozenset({"group_by", "between"})
"""Atoms that propose places while some of their blocks are still to come."""
WIDTH = 6
"""Candidates that are followed at each piece."""
PROPOSALS = 24
FREE_TRIES = 20
ANCHORED_TRIES = 8
MOST_PROPOSED = 48
PROPOSED = 0.6
"""What it is worth that a condition proposed a place, rather than chance."""
LEAST_MARGIN = 0.02
"""What is placed later must leave conditions that any block can break this share of their tolerance."""
GOOD_MARGIN = 0.3
"""More slack than this share of a tolerance is worth little."""
GOOD_CLEARANCE = 0.02
SCATTER_CLEARANCE = 0.10
CENTRE = (sum(WORKSPACE_X) / 2, sum(WORKSPACE_Y) / 2)
Origin = tuple[float, float]


class Style(NamedTuple):
    """What a search likes: chance, places that conditions propose, standing shoulder to shoulder from one corner; and
    whether the first places that will do are good enough."""

    noise: float
    worth: float
    dense: bool = False
    hasty: bool = False


NATURAL = Style(0.1, PROPOSED)
VARIED = Style(0.7, 0.2)
DENSE = Style(0.02, PROPOSED, dense=True)
LATTICE_STEP = 0.03
LATTICE_GAP = 0.006


class Exhausted(Exception):
    """The budget of a search is used up."""


class Budget:
    """How many candidates may still be judged."""

    def __init__(self, tries: int) -> None:
        self.left = tries

    def spend(self, tries: int = 1) -> None:
        """Use up some of it; raises Exhausted when there is none left."""
        self.left -= tries
        if self.left < 0:
            raise Exhausted


class Search:
    """One search for places of all pieces of an assembly."""

    def __init__(
        self,
        assembly: Assembly,
        bounds: Bounds,
        rules: list[Rule],
        rng: Random,
        budget: Budget,
        start: BlockState | None = None,
        style: Style = NATURAL,
    ) -> None:
        self.world, self.assembly, self.bounds, self.rules = assembly.world, assembly, bounds, rules
        self.rng, self.budget = rng, budget
        self.style = style
        self.position: dict[str, Vec3] = {}
        orientation: dict[str, Quat] = {n: assembly.of[n].orientation[n] or IDENTITY for n in assembly.of}
        self.state = BlockState(self.world, self.position, orientation, start=start)
        self.origins: dict[int, Origin] = {}
        self.pieces = bounds.pieces

    def run(self) -> Iterator[BlockState]:
        """Arrangements that meet all rules, as they are found."""
        if not all(rule.blocks or rule.open_ended or rule.slack(self.state) is not None for rule in self.rules):
            return
        if self._sound():
            self._survey()
            yield from self._descend(self.pieces)

    def _survey(self) -> None:
        """What the search asks again and again: which rules are about which pieces, and how much room those take."""
        rules = self.rules
        self.ground = Ground(self.pieces, self.state, [r.atom for r in rules if r.holds])
        self.touching = {
            id(piece): [r for r in rules if not piece.position.keys().isdisjoint(r.blocks)] for piece in self.pieces
        }
        self.wanted = {piece: [r for r in found if r.holds and r.per_place] for piece, found in self.touching.items()}
        self.press = {piece: sum(r.press for r in found) for piece, found in self.wanted.items()}
        self.bound = {piece: any(rule.holds for rule in found) for piece, found in self.touching.items()}
        self.open_ended = [rule for rule in rules if rule.open_ended]

    def _sound(self) -> bool:
        """Do the conditions within each piece hold, which is so wherever it stands?"""
        within = [r for r in self.rules if r.blocks and not r.per_place and (r.holds or not r.open_ended)]
        # what must be fails sooner than what must not; structures take longest to judge
        within.sort(key=lambda rule: (rule.open_ended, not rule.holds))
        for piece in {id(piece): piece for piece in (self.assembly.of[r.blocks[0]] for r in within)}.values():
            self._write(piece, (0.0, 0.0))
            sound = all((r.slack(self.state) or 0.0) > LEAST_MARGIN for r in within if r.blocks[0] in piece.position)
            self._wipe(piece)
            if not sound:
                return False
        return True

    def _descend(self, waiting: list[Piece]) -> Iterator[BlockState]:
        if not waiting:
            yield self._result()
            return
        piece = waiting[0] if len(waiting) == 1 else max(waiting, key=self._urgency)
        rest = [other for other in waiting if other is not piece]
        for origin in self._ranked(piece)[:WIDTH]:
            self._put(piece, origin)
            if self._undisturbed():
                yield from self._descend(rest)
            self._lift(piece)

    def _urgency(self, piece: Piece) -> tuple[bool, int, int, int]:
        """Fixed pieces come first, then those that complete most conditions, then the most bound and the largest."""
        there = self.position.keys() | piece.position.keys()
        ready = sum([r.press for r in self.wanted[id(piece)] if there.issuperset(r.blocks)])
        return piece.fixed, ready, self.press[id(piece)], len(piece.position)

    def _put(self, piece: Piece, origin: Origin) -> None:
        self.origins[id(piece)] = origin
        self._write(piece, origin)
        self.ground.occupy(piece, origin)

    def _write(self, piece: Piece, origin: Origin) -> None:
        ox, oy = origin
        for name, (x, y, z) in piece.position.items():
            self.position[name] = (x + ox, y + oy, z + TABLE_Z)

    def _lift(self, piece: Piece) -> None:
        del self.origins[id(piece)]
        self.ground.leave(piece)
        self._wipe(piece)

    def _wipe(self, piece: Piece) -> None:
        for name in piece.position:
            del self.position[name]

    def _undisturbed(self) -> bool:
        """Do the conditions that any block can break hold, as far as they can be judged? A piece that stands by itself
        is sound."""
        alone = len(self.origins) == 1
        return all(
            (rule.slack(self.state) or 0.0) > LEAST_MARGIN
            for rule in self.open_ended
            if not (alone and rule.holds and not rule.per_place) and all(n in self.position for n in rule.blocks)
        )

    def _ranked(self, piece: Piece) -> list[Origin]:
        """Origins that meet every condition which the piece completes, best first."""
        there = self.position.keys() | piece.position.keys()
        due = [r for r in self.touching[id(piece)] if r.per_place and there.issuperset(r.blocks)]
        begun = [r for r in self._begun(piece) if r not in due]
        telling = [r for r in due if r.holds] + begun
        due += [r for r in (self._so_far(rule, piece) for rule in begun) if r is not None]
        # structures take longest to judge, and need not be where something else rules a place out, as what presses does
        due.sort(key=lambda rule: (rule.open_ended, -rule.press))
        scored = self._scored(piece, self._candidates(piece, telling), due)
        scored.sort(key=itemgetter(0), reverse=True)
        return [origin for _, origin in scored]

    def _begun(self, piece: Piece) -> list[Rule]:
        """Conditions that say something of a place before all of their blocks are there."""
        rules = [r for r in self.wanted[id(piece)] if r.atom.kind in GRADUAL]
        return [r for r in rules if any(n in self.position for n in r.blocks)]

    def _so_far(self, rule: Rule, piece: Piece) -> Rule | None:
        """What a condition on groups says of those of their members that are there already."""
        atom = rule.atom
        if not isinstance(atom, GroupBy) or atom.outliers:
            return None
        there = (tuple(n for n in group if n in self.position or n in piece.position) for group in atom.groups)
        groups = tuple(group for group in there if group)
        return replace(rule, atom=atom.model_copy(update={"groups": groups}))

    def _scored(self, piece: Piece, candidates: dict[Origin, float], due: list[Rule]) -> list[tuple[float, Origin]]:
        """Those of the candidates that will do, each with what it is worth."""
        spend, clearance_of, merit = self.budget.spend, self.ground.clearance, self._merit_of(piece)
        state, most = self.state, WIDTH if self.style.hasty else None
        found: list[tuple[float, Origin]] = []
        for origin, worth in candidates.items():
            spend()
            clearance = clearance_of(piece, origin)
            if clearance is None:
                continue
            if due:
                self._write(piece, origin)
            least = _least_slack(due, state)
            if least is not None:
                found.append((merit(origin, least, clearance) + worth, origin))
                if len(found) == most:
                    break
        if due:
            for name in piece.position:
                self.position.pop(name, None)
        return found

    def _merit_of(self, piece: Piece) -> Callable[[Origin, float, float], float]:
        """What places are worth for a piece, by origin, least slack of a condition, and clearance."""
        rng, noise, dense, trespass = self.rng.random, self.style.noise, self.style.dense, self.ground.trespass
        bound, patches = self.bound[id(piece)], self.ground.patches
        room = GOOD_CLEARANCE if bound else SCATTER_CLEARANCE
        x, y, _ = next(iter(piece.position.values()))

        def merit(origin: Origin, least: float, clearance: float) -> float:
            good = least if least < GOOD_MARGIN else GOOD_MARGIN
            if dense:
                return good / GOOD_MARGIN - trespass(piece, origin) - 0.1 * sum(origin)
            found = 1.5 * good / GOOD_MARGIN + 0.5 * least + (clearance if clearance < room else room) / room
            if bound:
                found -= 0.8 * hypot(x + origin[0] - CENTRE[0], y + origin[1] - CENTRE[1])
            if patches:
                found -= trespass(piece, origin)
            return found + noise * rng()

        return merit

    def _candidates(self, piece: Piece, wanted: list[Rule]) -> dict[Origin, float]:
        """Origins to judge, each with what it is worth to have been proposed."""
        if piece.fixed:
            return {(0.0, 0.0): 0.0}
        (x0, x1), (y0, y1) = (self.bounds.interval(piece, axis, self.origins) for axis in (0, 1))
        if x0 > x1 + 1e-9 or y0 > y1 + 1e-9:
            return {}
        worth, low, near = self.style.worth, min(x0, x1), min(y0, y1)
        # where there is room for the piece, as close as can be to what is proposed
        found: dict[Origin, float] = {
            (round(x1 if x > x1 else max(x, low), 4), round(y1 if y > y1 else max(y, near), 4)): worth
            for x, y in self._proposed(piece, wanted)
        }
        if not found:
            found[round((x0 + x1) / 2, 4), round((y0 + y1) / 2, 4)] = 0.0
        if len(found) > MOST_PROPOSED:
            found = dict(self.rng.sample(list(found.items()), MOST_PROPOSED))
        if self.style.dense:
            found |= {
                (x, y): self.style.worth for x in self._steps(piece, 0, x0, x1) for y in self._steps(piece, 1, y0, y1)
            }
        draw = self.rng.random
        for _ in range(ANCHORED_TRIES if wanted else FREE_TRIES):
            found.setdefault((round(x0 + (x1 - x0) * draw(), 4), round(y0 + (y1 - y0) * draw(), 4)), 0.0)
        return found

    def _steps(self, piece: Piece, axis: int, low: float, high: float) -> list[float]:
        """Origins along an axis at which pieces stand side by side from one end of their room."""
        pitch = LATTICE_STEP
        if len(piece.position) == 1:
            apart = [r.atom.distance for r in self.touching[id(piece)] if r.holds and isinstance(r.atom, Apart)]
            pitch = max([*apart, self.world.edge[next(iter(piece.position))] + LATTICE_GAP])
        return [round(low + k * pitch, 4) for k in range(int((high - low) / pitch + 1e-6) + 1)]

    def _proposed(self, piece: Piece, wanted: list[Rule]) -> Iterator[Origin]:
        for rule in wanted:
            for patch in rule.patches if rule.together <= piece.position.keys() else ():
                inside = [piece.position[n] for n in rule.blocks]
                x, y, _ = self.state.where(patch)
                middle = [sum(place[k] for place in inside) / len(inside) for k in (0, 1)]
                yield x - middle[0], y - middle[1]
            for block in rule.blocks:
                if block in piece.position:
                    px, py, _ = piece.position[block]
                    for x, y in islice(rule.predicate.propose(rule.hint, block, self.state, self.rng), PROPOSALS):
                        yield x - px, y - py

    def _result(self) -> BlockState:
        position: dict[str, Vec3] = {}
        for name in self.world.blocks:
            x, y, z = self.position[name]
            position[name] = (round(x, 4), round(y, 4), round(z, 6))
        orientation = {name: _rounded(self.state.orientation[name]) for name in self.world.blocks}
        return BlockState(self.world, position, orientation, start=self.state.start)


def _least_slack(rules: list[Rule], state: BlockState) -> float | None:
    """How well rules are met, the worst of them (at most 1); None where one is not."""
    least = 1.0
    for rule in rules:
        slack = rule.slack(state)
        if slack is None:
            return None
        if slack < least:
            least = slack
    return least


def _rounded(quat: Quat) -> Quat:
    if quat is IDENTITY:
        return quat
    w, x, y, z = quat
    return round(w, 6) + 0.0, round(x, 6) + 0.0, round(y, 6) + 0.0, round(z, 6) + 0.0
