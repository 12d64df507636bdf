"""One alternative of a goal as what a search for it asks again and again: its literals as rules, found once."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, replace
from functools import cached_property

from rpg.blocks.arrange.alternatives import Conjunction
from rpg.blocks.arrange.builds import ABSOLUTE, STRUCTURES
from rpg.blocks.arrange.pieces import Assembly
from rpg.blocks.predicate import Predicate
from rpg.blocks.predicates import PREDICATES
from rpg.blocks.state import BlockState, World
from rpg.ir import goal as g
from rpg.ir.node import Highest, Lowest
from rpg.ir.relations import Above, Facing, On, Turned
from rpg.ir.walk import names

OPEN = STRUCTURES | {"clear", "empty", "facing"}
"""Atoms that other blocks can break: judged again whenever something is placed."""
TIGHT = {"touching": 5, "adjacent": 3, "distance": 3, "beside": 2}
"""How much conditions on a place press for it to be taken before others."""
SQUARE = frozenset({"touching", "distance", "facing", "turned"})
"""Conditions that are hard to meet for blocks that stand askew, or that say how they are turned."""


@dataclass(frozen=True)
class Rule:
    """A literal with what the search needs to know of it. `per_place`: it is about where pieces stand."""

    atom: g.Atom
    hint: g.Atom
    holds: bool
    predicate: Predicate[g.Atom]
    blocks: tuple[str, ...]
    together: frozenset[str]
    patches: tuple[str, ...]
    per_place: bool
    open_ended: bool
    press: int

    def slack(self, state: BlockState) -> float | None:
        """How well the literal is met (not negative, and exact below 1); None where it is not."""
        if self.predicate.plainly_not(self.atom, state):
            return None if self.holds else 1.0
        verdict = self.predicate.evaluate(self.atom, state)
        return abs(verdict.margin) if verdict.value == self.holds else None

    @cached_property
    def between(self) -> Rule:
        """The same where its blocks are of several pieces."""
        return replace(self, per_place=True)


class Way:
    """An alternative of a goal: its literals, and what follows from them alone."""

    def __init__(self, literals: Conjunction, world: World) -> None:
        self.literals = literals
        self._blocks = world.blocks.keys()

    @cached_property
    def wanted(self) -> list[g.Atom]:
        """What must hold."""
        return [atom for atom, holds, _ in self.literals if holds]

    @cached_property
    def stacked(self) -> list[On]:
        """What must be directly on something: what is on the foot or the top of a tower comes last."""
        found = [atom for atom in self.wanted if isinstance(atom, On)]
        return sorted(found, key=lambda on: isinstance(on.b, Highest | Lowest))

    @cached_property
    def above(self) -> list[Above]:
        """What must be above something."""
        return [atom for atom in self.wanted if isinstance(atom, Above)]

    @cached_property
    def turns(self) -> dict[str, list[tuple[Facing | Turned, bool]]]:
        """By block, how it must be turned, and how not."""
        asked: dict[str, list[tuple[Facing | Turned, bool]]] = {}
        for atom, holds, _ in self.literals:
            if isinstance(atom, Facing | Turned):
                asked.setdefault(atom.block, []).append((atom, holds))
        return asked

    @cached_property
    def square(self) -> frozenset[str]:
        """The blocks that had better stand along the axes."""
        return frozenset(name for atom, _, _ in self.literals if atom.kind in SQUARE for name in names(atom))

    @cached_property
    def _rules(self) -> list[Rule]:
        return list(_rules_of(self.literals, self._blocks))

    def rules(self, assembly: Assembly) -> list[Rule]:
        """The literals as rules, with respect to the pieces at hand."""
        return [rule.between if _split(rule, assembly) else rule for rule in self._rules]


def _rules_of(literals: Conjunction, there: Iterable[str]) -> Iterable[Rule]:
    """The literals as rules, as if all blocks were of one piece."""
    known = frozenset(there)
    for atom, holds, hint in literals:
        mentioned = names(atom)
        blocks = tuple(n for n in mentioned if n in known)
        patches = tuple(n for n in mentioned if n not in known)
        together = known.intersection(blocks if hint is None else names(hint))
        per_place = atom.kind in ABSOLUTE or bool(patches)
        said, press = (holds, PREDICATES[atom.kind], blocks, together, patches), TIGHT.get(atom.kind, 1)
        yield Rule(atom, hint or atom, *said, per_place, atom.kind in OPEN, press)


def _split(rule: Rule, assembly: Assembly) -> bool:
    """Are the blocks of a rule of several pieces?"""
    if rule.per_place or len(rule.blocks) < 2:
        return False
    of = assembly.of
    first = of[rule.blocks[0]]
    return any(of[name] is not first for name in rule.blocks)
