"""Two tasks that differ in a choice that an instruction leaves, as one task."""

from __future__ import annotations

from collections.abc import Sequence

from rpg.ir import goal as g
from rpg.ir.schema import TaskSchema
from rpg.ir.walk import plain, within
from rpg.passes.schema.names import family_name
from rpg.passes.schema.resolve.goals.logic import conj, disj


def either_task(tasks: Sequence[TaskSchema | None]) -> TaskSchema | None:
    """The task to reach the end of any of these; None where they are not of the same things and the same start, or
    tell what is to be so in between."""
    known = [task for task in tasks if task is not None]
    if len(known) < len(tasks) or any(_things(task) != _things(known[0]) for task in known):
        return None
    goals = [task.goal.goals if isinstance(task.goal, g.All) else (task.goal,) for task in known]
    if any(isinstance(x, g.Sequence | g.Always) for goal in goals for part in goal for x in within(part)):
        return None
    said = [{plain(part) for part in goal} for goal in goals]
    shared = set.intersection(*said)
    own = [[part for part in goal if plain(part) not in shared] for goal in goals]
    if not all(own):
        return None
    goal = conj([*(part for part in goals[0] if plain(part) in shared), disj([conj(parts) for parts in own])])
    return known[0].model_copy(update={"goal": goal, "name": _name(known[0], goal)})


def _name(task: TaskSchema, goal: g.Goal) -> str:
    """The name of the family, where it was made from the goal."""
    return family_name(goal) if task.name == family_name(task.goal) else task.name


def _things(task: TaskSchema) -> object:
    """What there is, in whatever order it was told, and how it starts."""
    return sorted(map(repr, task.assets)), task.init
