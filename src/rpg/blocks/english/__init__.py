"""Tasks and goals read back as English, from their data alone.

`goals.CLAUSES` has a clause for every kind of atom; what is said here compiles back to the same goal.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TypeVar

from rpg.blocks.english.goals import sentences, spoken
from rpg.blocks.english.scene import objects, starts
from rpg.blocks.english.speaker import Inexpressible, Speaker
from rpg.blocks.state import World
from rpg.ir import goal as g
from rpg.ir.schema import TaskSchema

__all__ = ["Inexpressible", "clause", "describe", "describe_goal"]


T = TypeVar("T")


def clause(goal: g.Goal, world: World) -> str:
    """A goal as one clause: "the red block is on the yellow block". Look-alikes are told apart by number if need be."""
    return _said(lambda say: spoken(goal, say), world)


def describe_goal(schema: TaskSchema) -> str:
    """What a task asks for, as sentences."""
    return _text(_said(lambda say: sentences(schema.goal, say), World(schema.assets), "must"))


def describe(schema: TaskSchema) -> str:
    """A task as one paragraph: what there is, how it starts, what it asks for."""
    world = World(schema.assets)
    there = objects(schema, Speaker(world))
    return _text([*there, *_said(lambda say: [*starts(schema, say), *sentences(schema.goal, say)], world, "must")])


def _text(said: list[str]) -> str:
    return " ".join(f"{sentence}." for sentence in said)


def _said(tell: Callable[[Speaker], T], world: World, modal: str = "") -> T:
    """What `tell` says; blocks that it cannot tell apart otherwise have numbers."""
    numbered: frozenset[str] = frozenset()
    while True:
        try:
            return tell(Speaker(world, modal=modal, numbered=numbered))
        except Inexpressible as failure:
            numbered |= {failure.noun}
