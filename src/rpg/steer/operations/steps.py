"""The order in which a task's steps are done."""

from __future__ import annotations

from rpg.ir import goal as g
from rpg.ir.edits import SetGoal
from rpg.steer.draft import Draft
from rpg.steer.requests import requests as r
from rpg.steer.requests.language import m


def of_steps(draft: Draft, request: r.Reorder) -> bool:
    """Whether a request for another order may be about the steps of the task rather than about a line of blocks."""
    whole = request.theme is None or isinstance(request.theme, m.Pronoun)
    sequence = isinstance(draft.schema.goal, g.Sequence)
    return request.how == "steps" or (sequence and whole and request.how in ("reverse", "swap"))


def turn_steps(draft: Draft, request: r.Reorder) -> None:
    """The steps in the opposite order."""
    goal = draft.schema.goal
    if not isinstance(goal, g.Sequence):
        told, hint = "the task has no steps that come one after the other", "say which blocks are to change places"
        raise draft.refusal("edit-unclear", told, request.span, hint)
    if request.how != "steps" and not request.of_doing:
        told = "this may be the order of the steps or the order of the blocks"
        raise draft.refusal("edit-unclear", told, request.span, "say 'swap the steps', or which blocks to swap")
    if any(stage.undone for stage in goal.stages):
        told, hint = "a later step undoes one of these steps", "give the whole instruction"
        raise draft.refusal("breaks-structure", told, request.span, hint)
    draft.aim("MODIFY")
    draft.note("order", {"how": "steps"})
    draft.do(SetGoal(goal=goal.model_copy(update={"stages": tuple(reversed(goal.stages))})), request.span)
