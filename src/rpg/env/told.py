"""What a task's code asks for, in the goal language: its conditions are told instead of being judged."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from enum import Enum, auto

from rpg.blocks.verdict import Verdict
from rpg.blocks.verdicts import Closed, Looked
from rpg.ir import goal as g
from rpg.ir.node import EACH
from rpg.ir.walk import instances, names, rename


class Asked(Enum):
    """How a task's code is asked about its goal: under one naming of look-alikes, under all at once, or to tell it."""

    ONE_NAMING = auto()
    ALL_NAMINGS = auto()
    TOLD = auto()


class Told(Closed):
    """A condition that is told. It combines with others as their verdicts do, and cannot be looked at.

    `waits`: it also asks that every block is at rest, which only a whole goal may.
    """

    __slots__ = ("goal", "waits")

    def __init__(self, goal: g.Goal, waits: bool = False) -> None:
        self.goal, self.waits = goal, waits

    def __and__(self, other: object) -> Told:
        if not isinstance(other, Told):
            raise Looked
        return Told(g.All(goals=(self.goal, other.goal)), self.waits or other.waits)

    def __or__(self, other: object) -> Told:
        return Told(g.Any(goals=(goal_of(self), goal_of(other))))

    def __invert__(self) -> Told:
        return Told(g.Not(goal=goal_of(self)))


def goal_of(told: object) -> g.Goal:
    """The goal of a condition that was told. Raises Looked where it is a verdict of its own, or waits for rest."""
    if not isinstance(told, Told) or told.waits:
        raise Looked
    return told.goal


def counted(at_least: int, at_most: int | None, verdicts: Iterable[Verdict]) -> Told:
    """At least / at most so many of conditions that say the same of one block each."""
    parts = tuple(map(goal_of, verdicts))
    if at_most is None and at_least in (1, len(parts)):
        return Told(g.Any(goals=parts) if at_least == 1 else g.All(goals=parts))
    first, *others = [names(part) for part in parts]
    place = next((k for k, name in enumerate(first) if all(name not in other for other in others)), None)
    if place is None or any(len(other) != len(first) for other in others):
        raise Looked
    over = tuple(found[place] for found in (first, *others))
    goal = rename(parts[0], {first[place]: EACH})
    count = g.Count(over=over, at_least=at_least, at_most=at_most, goal=goal)
    if instances(count) != parts:
        raise Looked
    return Told(count)


def in_order(stages: Sequence[Verdict], undone: Sequence[int]) -> Told:
    """The stages one after the other."""
    each = (g.Stage(goal=goal_of(stage), undone=k in undone) for k, stage in enumerate(stages))
    return Told(g.Sequence(stages=tuple(each)))


def always(condition: Verdict) -> Told:
    """What holds at every step."""
    return Told(g.Always(goal=goal_of(condition)))
