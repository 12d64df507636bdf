"""Two goals on one bank of states: which implies which, with a witness for every difference."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Literal

from rpg.blocks import alike
from rpg.blocks.centres import Centres, Mask, Numbers, places_of
from rpg.blocks.english import clause
from rpg.blocks.evaluate import evaluate, rests, satisfied
from rpg.blocks.state import BlockState
from rpg.ir import goal as g
from rpg.ir.walk import conjuncts, names, transform
from rpg.steer.proof.bank import RANDOM, Bank, Sample, Side
from rpg.steer.proof.identity import Identity, look

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

    def own(self, bank: Bank, places: Numbers) -> list[bool]:
        """The verdict on every state, with the version's own blocks in their places."""
        known = [sample.known.get(self.side.label) for sample in bank.samples]
        perhaps = self._perhaps(bank, places, self.side.keys)
        return [
            (bool(maybe) and self.holds(self.side.state(sample))) if told is None else told
            for sample, told, maybe in zip(bank.samples, known, perhaps, strict=True)
        ]

    def any(self, bank: Bank, places: Numbers, wanted: Sequence[int]) -> dict[int, bool]:
        """The verdict on the states of these numbers, with blocks of either version in their places: so far as it is
        not that with the version's own blocks."""
        if len(self.choices) == 1 or not wanted:
            return {}
        looked_at = places[:, wanted]
        perhaps = [self._perhaps(bank, looked_at, keys) for keys in self.choices]
        return {
            number: any(
                maybe[k] and self.holds(self.side.state(bank.samples[number], keys))
                for keys, maybe in zip(self.choices, perhaps, strict=True)
            )
            for k, number in enumerate(wanted)
        }

    def _perhaps(self, bank: Bank, places: Numbers, keys: Mapping[str, str]) -> Mask:
        """May the goal hold? All states are looked at at once, which rules out most."""
        column = {k: number for number, k in enumerate(bank.sizes)}
        many = Centres(self.side.world, places, {k: column[taken] for k, taken in keys.items()})
        return self._judge.perhaps(many)

    def margin(self, sample: Sample) -> float:
        """By how much of its tolerances the goal holds, or fails, with its own blocks."""
        return evaluate(self.side.goal, self.side.state(sample)).margin


def compare(identity: Identity, bank: Bank) -> Comparison:
    """Judge every state of the bank by both goals."""
    old, new = Judge(bank.old, bank.new), Judge(bank.new, bank.old)
    befores, afters = _verdicts(old, new, bank)
    both: list[Sample] = []
    only_old: list[Sample] = []
    only_new: list[Sample] = []
    included = _included(bank)
    for sample, before, after in zip(bank.samples, befores, afters, strict=True):
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


def _verdicts(old: Judge, new: Judge, bank: Bank) -> tuple[list[bool], list[bool]]:
    """What either version says of every state."""
    places = places_of(bank.sizes, [sample.layout.position for sample in bank.samples])
    afters = new.own(bank, places)
    befores = afters if bank.same else old.own(bank, places)
    # Blocks of the other version may stand in; in a random layout that neither accepts it is not worth a look.
    doubtful = [
        k
        for k, sample in enumerate(bank.samples)
        if befores[k] != afters[k] or not (befores[k] or sample.source == RANDOM)
    ]
    with_others = new.any(bank, places, [k for k in doubtful if not afters[k]])
    judged = [with_others.get(k, after) for k, after in enumerate(afters)]
    if bank.same:
        return judged, judged
    with_others = old.any(bank, places, [k for k in doubtful if not befores[k]])
    return [with_others.get(k, before) for k, before in enumerate(befores)], judged


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
