"""A repair never weakens what was asked: every condition of the instruction is still there afterwards."""

from __future__ import annotations

from collections.abc import Iterator

from rpg.blocks.predicates import PREDICATES
from rpg.blocks.state import World
from rpg.ir import goal as g
from rpg.ir.relations import Above
from rpg.ir.schema import TaskSchema
from rpg.ir.walk import transform


def dropped(asked: g.Goal, task: TaskSchema) -> list[g.Goal]:
    """Conditions of `asked` that the goal of `task` neither has word for word nor implies."""
    kept = {_bare(part) for part in conditions(task.goal)}
    below = _below(task)
    return [part for part in conditions(asked) if _bare(part) not in kept and not _implied(part, below)]


def conditions(goal: g.Goal) -> Iterator[g.Goal]:
    """The parts that all have to hold."""
    if isinstance(goal, g.All):
        for part in goal.goals:
            yield from conditions(part)
    else:
        yield goal


def bare(goal: g.Goal) -> g.Goal:
    """A goal without its places in the instruction."""
    return transform(goal, lambda node: node.model_copy(update={"span": None}))


def _bare(goal: g.Goal) -> str:
    return bare(goal).model_dump_json()


def _below(task: TaskSchema) -> dict[str, set[str]]:
    """What each block directly rests on, as the goal demands."""
    world = World(task.assets)
    found: dict[str, set[str]] = {}
    for part in conditions(task.goal):
        if part.kind in PREDICATES and not isinstance(part, Above):
            for top, under in PREDICATES[part.kind].supports(part, world):
                found.setdefault(top, set()).add(under)
    return found


def _implied(part: g.Goal, below: dict[str, set[str]]) -> bool:
    """ "Above" follows from a chain of blocks that each rest on the next."""
    if not isinstance(part, Above) or not isinstance(part.a, tuple) or not isinstance(part.b, tuple):
        return False
    return all(_reaches(top, under, below) for top in part.a for under in part.b)


def _reaches(top: str, under: str, below: dict[str, set[str]]) -> bool:
    frontier, seen = [top], {top}
    while frontier:
        for node in sorted(below.get(frontier.pop(), ())):
            if node == under:
                return True
            if node not in seen:
                seen.add(node)
                frontier.append(node)
    return False
