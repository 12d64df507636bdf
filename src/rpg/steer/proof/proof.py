"""The proof of what an edit preserved: A, rho_0, G and l compared, as data where that will do, else on states."""

from __future__ import annotations

from typing import Literal

from rpg.ir.base import Record
from rpg.ir.schema import TaskSchema
from rpg.steer.proof.bank import STARTS, Bank, Layout
from rpg.steer.proof.compare import Comparison, Relation, Witness, compare
from rpg.steer.proof.diff import Diff, diff
from rpg.steer.proof.identity import Identity, look

Axis = Literal["S", "V", "B"]


class Positions(Record):
    """Starts of untouched blocks under the same seeds. `moved` are the blocks that some seed puts elsewhere."""

    blocks: tuple[str, ...]
    seeds: int
    identical: int
    moved: tuple[str, ...] = ()

    @property
    def kept(self) -> bool:
        """Whether every untouched block starts where it did, for every seed."""
        return self.identical == self.seeds


class Goals(Record):
    """The new goal against the old one on a bank of states; counts of states.

    `edge`: states that speak against the relation, where both goals are decided by little of their tolerances.
    """

    relation: Relation
    states: int
    both: int
    only_old: int
    only_new: int
    edge: int = 0


class Proof(Record):
    """What differs, what stayed, how the goals relate. `axes`: S, language; V, appearance or start; B, behaviour."""

    diff: Diff
    positions: Positions
    goals: Goals
    axes: tuple[Axis, ...]


def prove(old: TaskSchema, new: TaskSchema) -> tuple[Proof, tuple[Witness, ...]]:
    """Compare two versions; the witnesses are states for people to look at."""
    identity = Identity(old, new)
    bank = Bank(identity)
    found = compare(identity, bank)
    changes = diff(identity)
    proof = Proof(
        diff=changes,
        positions=_positions(identity, bank),
        goals=_goals(found),
        axes=_axes(identity, changes, found.relation),
    )
    return proof, found.witnesses


def _goals(found: Comparison) -> Goals:
    return Goals(
        relation=found.relation,
        states=found.states,
        both=found.both,
        only_old=found.only_old,
        only_new=found.only_new,
        edge=found.edge,
    )


def _positions(identity: Identity, bank: Bank) -> Positions:
    """Compare the starts that both versions draw for the same seeds, to the bit."""
    moved: set[str] = set()
    identical = 0
    for before, after in zip(bank.starts["old"], bank.starts["new"], strict=True):
        elsewhere = {k for k in identity.untouched if _pose(before, k) != _pose(after, k)}
        identical += not elsewhere
        moved |= elsewhere
    names = {k: identity.after[k].name for k in identity.untouched}
    return Positions(
        blocks=tuple(names.values()),
        seeds=STARTS,
        identical=identical,
        moved=tuple(names[k] for k in names if k in moved),
    )


def _pose(start: Layout, k: str) -> tuple[object, object]:
    return start.position[k], start.orientation[k]


def _axes(identity: Identity, changes: Diff, relation: Relation) -> tuple[Axis, ...]:
    """Which of language, appearance or start, and required behaviour the edit changed."""
    found: list[Axis] = []
    if _words(identity.old.instruction) != _words(identity.new.instruction):
        found.append("S")
    looks = [sorted(repr(look(asset)) for asset in version.assets) for version in (identity.old, identity.new)]
    if looks[0] != looks[1] or changes.starts_added or changes.starts_removed or changes.assets_changed:
        found.append("V")
    if relation != "equal":
        found.append("B")
    return tuple(found)


def _words(text: str) -> list[str]:
    return "".join(c if c.isalnum() else " " for c in text.lower()).split()
