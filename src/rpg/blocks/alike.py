"""A goal under every naming of look-alikes, for judging many states: what namings say alike is judged once."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from rpg.blocks.arrange.builds import STRUCTURES
from rpg.blocks.arrange.explain import conditions
from rpg.blocks.centres import Centres, Mask
from rpg.blocks.evaluate import perhaps, rests, satisfied
from rpg.blocks.namings import MANY, Namings, all_namings
from rpg.blocks.predicates import PREDICATES
from rpg.blocks.state import BlockState, World
from rpg.blocks.symmetry import interchangeable
from rpg.ir import goal as g
from rpg.ir.walk import instances, transform, without_span

Tree = dict[int, "Tree"]
"""Numbers of parts under many namings, one below the other: namings that begin alike share their beginning."""


class Renamed:
    """Parts of a goal under every naming that is `found` for it. `goals`: the distinct ones; `namings`: per naming, the
    index of each part, the names as they stand first; `many`: parts that say many different things, with their
    indices."""

    def __init__(self, parts: Sequence[g.Goal], found: Namings) -> None:
        numbers: dict[g.Goal, int] = {}
        columns = []
        self.many: list[tuple[g.Goal, list[int]]] = []
        for part in parts:
            plain = transform(part, without_span)
            different, which = found.spread(plain)
            new = len(numbers)
            known = [numbers.setdefault(one, len(numbers)) for one in different]
            columns.append([known[k] for k in which])
            if len(different) >= MANY and len(numbers) > new:
                self.many.append((plain, known))
        self.namings = tuple(zip(*columns, strict=True)) if columns else ((),) * len(found)
        self.goals = tuple(numbers)


def _spelt_out(node: g.Goal) -> g.Goal:
    """ "At least one of" as the alternatives that it is, so that they are not made anew for every state."""
    if not isinstance(node, g.Count) or node.at_least != 1 or node.at_most is not None or len(node.over) < 2:
        return node
    return g.Any(goals=instances(node))


class Judge:
    """Whether a goal holds under some naming of its look-alikes, every block being at rest and supported.

    `namings`: what they are, where that is known.
    """

    def __init__(self, goal: g.Goal, world: World, namings: Namings | None = None) -> None:
        cheap_first = sorted(conditions(goal), key=lambda part: part.kind not in PREDICATES or part.kind in STRUCTURES)
        found = all_namings(interchangeable(goal, world)) if namings is None else namings
        renamed = Renamed(cheap_first, found)
        self._many = [(found.variants(part, world), np.array(known)) for part, known in renamed.many]
        self._goals = tuple(transform(part, _spelt_out) for part in renamed.goals)
        self._all = _unlike(renamed.namings)
        self._own, self._any = _tree(renamed.namings[:1]), _tree(self._all)
        self._changed = _tree(_unlike(renamed.namings[1:]))

    def as_named(self, state: BlockState) -> bool:
        """Does the goal hold with its names as they stand?"""
        return self._holds(state, self._own)

    def renamed(self, state: BlockState) -> bool:
        """Does the goal hold once look-alikes change places? The names as they stand are left for others to judge."""
        return self._holds(state, self._changed)

    def any_name(self, state: BlockState) -> bool:
        """Does the goal hold under any naming?"""
        return self._holds(state, self._any)

    def unsettled(self, state: BlockState) -> bool:
        """Does the goal hold under any naming, whatever the blocks rest on?"""
        return self._arranged(state, self._any)

    def perhaps(self, many: Centres) -> Mask:
        """The states in which the goal may hold under some naming, as far as the centres of blocks tell."""
        parts = [perhaps(goal, many) for goal in self._goals]
        found = many.none()
        for numbers in self._all:
            found |= np.logical_and.reduce([parts[k] for k in numbers])
            if found.all():
                break
        return found

    def _holds(self, state: BlockState, tree: Tree | None) -> bool:
        # what floats is seen at a glance
        return tree is not None and rests(state) and self._arranged(state, tree)

    def _arranged(self, state: BlockState, tree: Tree | None) -> bool:
        if tree is None:
            return False
        return self._somewhere(tree, state, {} if tree is self._own else self._ruled_out(state))

    def _ruled_out(self, state: BlockState) -> dict[int, bool]:
        """The parts that cannot hold in `state`, of those that say many different things."""
        found: dict[int, bool] = {}
        for variants, known in self._many:
            found.update(dict.fromkeys(known[~variants.perhaps(state)].tolist(), False))
        return found

    def _somewhere(self, tree: Tree, state: BlockState, values: dict[int, bool]) -> bool:
        """Do all the parts along some way down a tree hold?"""
        for number, rest in tree.items():
            held = values.get(number)
            if held is None:
                held = values[number] = satisfied(self._goals[number], state)
            if held and (not rest or self._somewhere(rest, state, values)):
                return True
        return not tree


def _unlike(found: Sequence[tuple[int, ...]]) -> tuple[tuple[int, ...], ...]:
    """Of namings that ask for the same parts, the first."""
    return tuple({frozenset(numbers): numbers for numbers in reversed(found)}.values())[::-1]


def _tree(found: Sequence[tuple[int, ...]]) -> Tree | None:
    """Namings as a tree; None where there is none."""
    tree: Tree = {}
    for numbers in found:
        at = tree
        for number in numbers:
            at = at.setdefault(number, {})
    return tree if found else None
