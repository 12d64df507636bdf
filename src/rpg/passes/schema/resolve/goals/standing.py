"""Towers that stand at the start and that the goal speaks of: "there is a tower of three; put the blue block on it"."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from rpg.ir import goal as g
from rpg.ir import structures as s
from rpg.ir.node import Highest, Lowest, members
from rpg.ir.walk import atoms, names
from rpg.passes.schema.resolve.goals.logic import conj


def still_standing(goal: g.Goal, starts: Iterable[g.Goal]) -> g.Goal:
    """`goal`, and that the towers still stand to which it relates blocks: what is on top of a tower is on no heap.

    Left alone where the goal itself says of a block of the tower where it should be.
    """
    towers_begun = [start for start in starts if isinstance(start, s.Stack)]
    if not towers_begun:
        return goal
    related = [set(_operands(atom)) for atom in atoms(goal)]
    spoken = {name for atom, towers in zip(atoms(goal), related, strict=True) for name in names(atom) if not towers}
    found: list[g.Goal] = []
    for start in towers_begun:
        if spoken.isdisjoint(start.blocks):
            ends = [end for towers in related for end in towers if set(members(end)) == set(start.blocks)]
            if ends:
                covered = any(isinstance(end, Highest) for end in ends)
                found.append(start.model_copy(update={"exact": start.exact and not covered}))
    return conj([*found, goal]) if found else goal


def _operands(atom: g.Atom) -> Iterator[Lowest | Highest]:
    """The towers that an atom relates something to."""
    for field in ("a", "b", "c"):
        value = getattr(atom, field, None)
        if isinstance(value, Lowest | Highest):
            yield value
