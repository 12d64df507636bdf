"""Towers that stand at the start and that the goal speaks of: "there is a tower of three; put the blue block on it"."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from rpg.ir import goal as g
from rpg.ir import structures as s
from rpg.ir.node import Highest, Lowest, members
from rpg.ir.walk import atoms, children, names, rebuild
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


def none_left_out_on_top(goal: g.Goal, left_out: set[str]) -> g.Goal:
    """ "Stack A, B and C without using D": nor is D on top of them."""
    if not left_out or isinstance(goal, g.Not):
        return goal
    if isinstance(goal, s.Stack):
        return goal if goal.exact or goal.raised else goal.model_copy(update={"exact": True})
    inner = children(goal)
    return rebuild(goal, tuple(none_left_out_on_top(x, left_out) for x in inner)) if inner else goal


def _operands(atom: g.Atom) -> Iterator[Lowest | Highest]:
    """The towers that an atom relates something to."""
    for field in ("a", "b", "c"):
        value = getattr(atom, field, None)
        if isinstance(value, Lowest | Highest):
            yield value
