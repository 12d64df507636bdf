"""What has to be so all the time, beside what is to be done: outside of the stages, and never all that a task asks."""

from __future__ import annotations

from rpg.ir import goal as g
from rpg.ir import relations as r
from rpg.ir.node import members
from rpg.ir.walk import names, transform
from rpg.passes.schema.resolve.goals.logic import conj
from rpg.passes.schema.resolve.things.world import Scene, refuse

LATER = "what has to be so all the time is not so yet at the start, as nothing else is to be done"


def beside_what_is_done(goal: g.Goal, scene: Scene) -> g.Goal:
    """`goal` with what lasts outside of its stages. Where there is nothing else, distances are to be brought about
    ("red must stay away from blue"), and so is what is not so at the start ("neither stays on the mat where both
    start"); anything else would be so already, and is refused."""
    placed = {n for start in scene.start_goals for n in names(start)} | {n for heap in scene.heaps for n in heap}
    goal = transform(goal, lambda node: _as_before(_unstaged(node, placed), scene.start_goals))
    parts = goal.goals if isinstance(goal, g.All) else (goal,)
    if not all(isinstance(part, g.Always | r.Stayed) or _few_moved(part) for part in parts):
        return goal
    lasting = conj([part.goal for part in parts if isinstance(part, g.Always)], goal.span)
    inside = lasting.goals if isinstance(lasting, g.All) else (lasting,)
    stays = any(isinstance(part, r.Stayed) or _few_moved(part) for part in parts)
    if stays or not all(_ahead(part, scene) for part in inside):
        raise refuse(
            "start-solves-goal",
            "this is so from the beginning, and nothing else is to be done",
            goal.span,
            "say what is to be done while this stays as it is",
        )
    scene.start_goals = [
        start
        for start in scene.start_goals
        if not all(part in inside for part in (start.goals if isinstance(start, g.All) else (start,)))
    ]
    scene.assume(LATER)
    return lasting


def _few_moved(goal: g.Goal) -> bool:
    """ "Move at most one of A, B and C": as good as done where nothing is."""
    return isinstance(goal, g.Count) and goal.at_least == 0 and isinstance(goal.goal, r.Moved | r.Shifted)


def _unstaged(goal: g.Goal, placed: set[str]) -> g.Goal:
    """ "First A, then B. C stays where it is throughout": what lasts is no stage, as it is so from the start; nor are
    blocks on the table first, but for those that start elsewhere."""
    if not isinstance(goal, g.Sequence):
        return goal
    stages = [stage for stage in goal.stages if not isinstance(stage.goal, g.Always)]
    lasting: list[g.Goal] = [stage.goal for stage in goal.stages if isinstance(stage.goal, g.Always)]
    while stages and isinstance(stages[0].goal, r.OnTable) and placed.isdisjoint(names(stages[0].goal)):
        first = stages.pop(0)
        lasting += [] if first.undone else [first.goal]
    if len(stages) == len(goal.stages) or not stages:
        return goal
    done = goal.model_copy(update={"stages": tuple(stages)}) if len(stages) > 1 else stages[0].goal
    return conj([done, *lasting], goal.span)


def _as_before(goal: g.Goal, starts: list[g.Goal]) -> g.Goal:
    """ "White is on black. Put red beside black; afterwards white should still be on black": what is so from the start
    is no step, where nothing is done before it with what it is said of."""
    if not isinstance(goal, g.Sequence):
        return goal
    begun = [_plain(start) for start in starts]
    steps: list[g.Stage] = []
    kept: list[g.Goal] = []
    for stage in goal.stages:
        before = {name for step in steps for name in names(step.goal)}
        told = set(members(stage.goal.a)) if isinstance(stage.goal, r.On | r.OnPatch) else set(names(stage.goal))
        if steps and not stage.undone and _plain(stage.goal) in begun and told.isdisjoint(before):
            kept.append(stage.goal)
        else:
            steps.append(stage)
    if not kept:
        return goal
    return conj(
        [goal.model_copy(update={"stages": tuple(steps)}) if len(steps) > 1 else steps[0].goal, *kept], goal.span
    )


def _plain(goal: g.Goal) -> g.Goal:
    return goal.model_copy(update={"span": None})


def _ahead(goal: g.Goal, scene: Scene) -> bool:
    """Does it say how far from each other blocks are, or that they are not where they start?"""
    if isinstance(goal, g.All | g.Any):
        return all(_ahead(part, scene) for part in goal.goals)
    if isinstance(goal, g.Not):
        told, blocks = goal.goal, {*names(goal)}
        return any(start.kind == told.kind and blocks <= {*names(start)} for start in scene.start_goals)
    return isinstance(goal, r.Apart) or (isinstance(goal, r.Distance) and goal.maximum is None)
