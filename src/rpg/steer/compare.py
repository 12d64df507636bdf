"""Two goals on one bank of states: which implies which, with a witness for every difference."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal

from rpg.blocks import alike
from rpg.blocks.centres import Centres
from rpg.blocks.english import clause
from rpg.blocks.evaluate import evaluate, rests, satisfied
from rpg.blocks.state import BlockState
from rpg.ir import goal as g
from rpg.ir.walk import names, transform
from rpg.steer.bank import RANDOM, Bank, Sample, Side
from rpg.steer.identity import Identity, look
from rpg.steer.shape import conjuncts

Relation = Literal["equal", "implies", "implied by", "overlaps", "disjoint"]
"""How the new goal relates to the old one: "implies" is that every state that satisfies the new one satisfies both."""


LITTLE = 0.5
"""A goal is decided by little where its margin is less than this part of a tolerance."""


@dataclass(frozen=True)
class Witness:
    """A state that satisfies one of the two goals only, as the version that accepts it sees it.

    `fails`: the conditions of the other version that do not hold in it, as clauses.
    """

    accepted_by: Literal["old", "new"]
    source: str
    state: BlockState
    fails: tuple[str, ...] = ()


@dataclass(frozen=True)
class Comparison:
    """What the bank says. Counts of states: in all, accepted by both, by the old goal only, by the new goal only.

    `edge`: states that speak against the relation, all of them where both goals are decided by little.
    """

    relation: Relation
    states: int
    both: int
    only_old: int
    only_new: int
    edge: int
    witnesses: tuple[Witness, ...]


class Judge:
    """A version's goal, under every renaming of its look-alikes and with those of the other version in their place.

    What the blocks rest on is left aside: it may be a block that only the other version has.
    """

    def __init__(self, side: Side, other: Side) -> None:
        self.side = side
        self._judge = alike.Judge(side.goal, side.world)
        self.holds = self._judge.unsettled
        self.choices = side.choices(other)

    def __call__(self, sample: Sample) -> bool:
        known = sample.known.get(self.side.label)
        if known is not None and (known or len(self.choices) == 1):
            return known
        if len(self.choices) == 1:
            return self.holds(self.side.state(sample))
        return any(self.holds(self.side.state(sample, keys)) for keys in self.choices)

    def alone(self, sample: Sample) -> bool:
        """The verdict with the version's own blocks in their places."""
        known = sample.known.get(self.side.label)
        return self.holds(self.side.state(sample)) if known is None else known

    def perhaps(self, samples: Sequence[Sample]) -> list[bool]:
        """May the goal hold with the version's own blocks? Looked at for all states at once, which rules out most."""
        many = Centres(self.side.world, [sample.layout.position for sample in samples])
        found: list[bool] = self._judge.perhaps(many).tolist()
        return found

    def margin(self, sample: Sample) -> float:
        """By how much of its tolerances the goal holds, or fails, with its own blocks."""
        return evaluate(self.side.goal, self.side.state(sample)).margin


def compare(identity: Identity, bank: Bank) -> Comparison:
    """Judge every state of the bank by both goals."""
    old, new = Judge(bank.old, bank.new), Judge(bank.new, bank.old)
    both: list[Sample] = []
    only_old: list[Sample] = []
    only_new: list[Sample] = []
    included = _included(bank)
    hopeful = old.perhaps(bank.samples)
    others = hopeful if bank.same else new.perhaps(bank.samples)
    for sample, maybe_old, maybe_new in zip(bank.samples, hopeful, others, strict=True):
        before = maybe_old and old.alone(sample)
        after = before if bank.same else maybe_new and new.alone(sample)
        if before != after or not (before or sample.source == RANDOM):
            # Blocks of the other version may stand in; in a random layout that neither accepts it is not worth a look.
            before = before or old(sample)
            after = before if bank.same else after or new(sample)
        if after and not before and included:
            before = True
        if (before or after) and rests(bank.whole(sample)):
            (both if before and after else only_old if before else only_new).append(sample)
    relation, edge = _up_to_tolerance(_relation(len(both), len(only_old), len(only_new)), old, new, only_old, only_new)
    relation = _temporal(identity, relation)
    witnesses = (
        *_witness("new", bank.new, bank.old, only_new),
        *_witness("old", bank.old, bank.new, only_old),
    )
    return Comparison(relation, len(bank.samples), len(both), len(only_old), len(only_new), edge, witnesses)


def _included(bank: Bank) -> bool:
    """Whether the new goal says all that the old one says of the same objects: what holds with the blocks of the new
    version then holds of the old ones, though some of them may rest on blocks that only the new version has."""
    old, new = bank.old, bank.new
    told = set(names(old.goal))
    return (
        all(look(old.world.assets[k]) == look(new.world.assets[k]) for k in told if k in new.world.assets)
        and told <= set(new.world.assets)
        and {_bare(part) for part in conjuncts(old.goal)} <= {_bare(part) for part in conjuncts(new.goal)}
    )


def _bare(goal: g.Goal) -> str:
    return transform(goal, lambda node: node.model_copy(update={"span": None})).model_dump_json()


def _relation(both: int, only_old: int, only_new: int) -> Relation:
    if not both:
        return "disjoint"
    if only_old and only_new:
        return "overlaps"
    return "implies" if only_old else "implied by" if only_new else "equal"


def _up_to_tolerance(
    relation: Relation, old: Judge, new: Judge, only_old: list[Sample], only_new: list[Sample]
) -> tuple[Relation, int]:
    """Goals that overlap only where tolerances of one make up for tolerances of the other imply one another otherwise.

    A row of three, out of line by little, may be part of a row of four that is just in line.
    """
    if relation != "overlaps":
        return relation, 0
    against_old = sum(not _by_little(old, new, sample) for sample in only_old)
    against_new = sum(not _by_little(new, old, sample) for sample in only_new)
    if against_old and not against_new:
        return "implies", len(only_new)
    if against_new and not against_old:
        return "implied by", len(only_old)
    return relation, 0


def _by_little(accepting: Judge, rejecting: Judge, sample: Sample) -> bool:
    return accepting.margin(sample) < LITTLE and rejecting.margin(sample) > -LITTLE


def _temporal(identity: Identity, relation: Relation) -> Relation:
    """Goals that end alike may still differ on the way there."""
    old, new = _stages(identity.old.goal), _stages(identity.new.goal)
    if relation != "equal" or old == new:
        return relation
    return "implies" if not old else "implied by" if not new else "overlaps"


def _stages(goal: g.Goal) -> tuple[str, ...]:
    """What a goal asks for over time: its sequences and what must hold always."""
    found: list[str] = []

    def note(node: g.Goal) -> g.Goal:
        if isinstance(node, g.Sequence | g.Always):
            found.append(node.model_dump_json(exclude={"span"}))
        return node

    transform(goal, note)
    return tuple(found)


def _witness(accepted_by: Literal["old", "new"], side: Side, other: Side, samples: list[Sample]) -> tuple[Witness, ...]:
    """The plainest witness: a goal of that version rather than a random state."""
    if not samples:
        return ()
    best = min(samples, key=lambda sample: sample.source != f"{accepted_by} goal")
    seen = other.named(best)
    fails = [clause(part, seen.world) for part in conjuncts(other.schema.goal) if not satisfied(part, seen)]
    return (Witness(accepted_by, best.source, side.named(best), tuple(fails)),)
