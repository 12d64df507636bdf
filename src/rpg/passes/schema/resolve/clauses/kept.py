""" "Keep red on blue": it is so and stays so; where nothing else is to be done, it has to get there."""

from __future__ import annotations

from rpg.ir import goal as g
from rpg.passes.schema.resolve.goals.logic import conj
from rpg.passes.schema.resolve.things.world import Scene


def brought_about(goal: g.Goal, scene: Scene) -> g.Goal:
    """A goal that only keeps what is so already asks for nothing: what is kept is then to be brought about."""
    parts = goal.goals if isinstance(goal, g.All) else (goal,)
    kept = [always for always, _ in scene.kept]
    if not parts or not all(part in kept for part in parts):
        return goal
    begun = [fact for _, facts in scene.kept for fact in facts]
    scene.start_goals = [fact for fact in scene.start_goals if fact not in begun]
    scene.assume("nothing else is to be done: what is to be kept is brought about, and need not be so at the start")
    return conj([part.goal for part in parts if isinstance(part, g.Always)], goal.span)
