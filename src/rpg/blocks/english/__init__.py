"""Tasks and goals read back as English, from their data alone.

`goals.CLAUSES` has a clause for every kind of atom; what is said here compiles back to the same goal.
"""

from __future__ import annotations

from rpg.blocks.english.goals import sentences, spoken
from rpg.blocks.english.scene import objects, starts
from rpg.blocks.english.speaker import Inexpressible, Speaker
from rpg.blocks.state import World
from rpg.ir import goal as g
from rpg.ir.schema import TaskSchema

__all__ = ["Inexpressible", "clause", "describe", "describe_goal"]


def clause(goal: g.Goal, world: World) -> str:
    """A goal as one clause: "the red block is on the yellow block". Look-alikes are told apart by number if need be."""
    try:
        return spoken(goal, Speaker(world))
    except Inexpressible:
        return spoken(goal, _numbered(world))


def describe_goal(schema: TaskSchema) -> str:
    """What a task asks for, as sentences."""
    world = World(schema.assets)
    try:
        said = sentences(schema.goal, Speaker(world, modal="must"))
    except Inexpressible:
        said = sentences(schema.goal, _numbered(world, modal="must"))
    return " ".join(f"{sentence}." for sentence in said)


def describe(schema: TaskSchema) -> str:
    """A task as one paragraph: what there is, how it starts, what it asks for."""
    world = World(schema.assets)
    for say in (Speaker(world, modal="must"), _numbered(world, modal="must")):
        try:
            said = [*objects(schema, Speaker(world)), *starts(schema, say), *sentences(schema.goal, say)]
        except Inexpressible:
            continue
        return " ".join(f"{sentence}." for sentence in said)
    raise AssertionError("numbered blocks are always told apart")


def _numbered(world: World, modal: str = "") -> Speaker:
    """A speaker that calls look-alikes "red block 1", "red block 2"."""
    say = Speaker(world, modal=modal)
    groups: dict[str, list[str]] = {}
    for name in world.assets:
        groups.setdefault(say.noun(name), []).append(name)
    for noun, names in groups.items():
        if len(names) > 1:
            say.aliases.update({name: f"{noun} {i}" for i, name in enumerate(names, start=1)})
    return say
