""" "Put two of the three red blocks on the mat in the left half": it is the same two that are on the mat and there."""

from __future__ import annotations

from rpg.ir import goal as g
from rpg.ir import relations as r
from rpg.ir.walk import names
from rpg.language.meaning import Clause, In, Loc, Pronoun
from rpg.passes.schema.resolve.clauses.turned_as_well import TURNS
from rpg.passes.schema.resolve.goals.logic import conj
from rpg.passes.schema.resolve.things.world import Scene, refuse


def of_the_same(goals: list[g.Goal], clause: Clause, scene: Scene) -> list[g.Goal]:
    """The goals of a clause, where several of them count the same blocks: so many of which all is true.

    What so many are put on holds no more of them than that.
    """
    if isinstance(clause.theme, Pronoun) and clause.theme.word == "same":
        _told_before(goals, clause, scene)
    if sum(isinstance(part, Loc | In) or getattr(part, "kind", "") in TURNS for part in clause.adjuncts) < 2:
        return goals  # "one of them in each corner"
    lots = [(goal, found) for goal in goals if (found := _counted(goal)) is not None]
    if len(lots) != len(goals):
        _no_others(lots, goals, clause)
    if len(lots) < 2 or len(lots) != len(goals):
        return goals
    told_of = [goal.goal if isinstance(goal, g.Not) else goal for goal, _ in lots]
    counts = [goal for goal in told_of if isinstance(goal, g.Count)]
    told = {(count.over, count.var, count.at_least, count.at_most) for count in counts}
    if len(told) != 1 or any({*names(goal)} < {*counts[0].over} for goal in goals):
        return goals
    first = counts[0]
    both = first.model_copy(update={"goal": conj([body for _, body in lots], clause.span)})
    exact = first.at_least == first.at_most and clause.verb in ("place", "stack", "use")
    kept = [goal for goal, body in lots if isinstance(body, r.On | r.OnPatch)][:1] if exact else []
    return [*kept, both]


def _counted(goal: g.Goal) -> g.Goal | None:
    """What is said of each of so many; "not on the mat" was denied of their number."""
    if isinstance(goal, g.Count):
        return goal.goal
    if isinstance(goal, g.Not) and isinstance(goal.goal, g.Count):
        return g.Not(goal=goal.goal.goal, span=goal.span)
    return None


def _no_others(lots: list[tuple[g.Goal, g.Goal]], goals: list[g.Goal], clause: Clause) -> None:
    """Refuse "two of the three red blocks on the mat, 5 cm apart", where it need not be the same two."""
    over = {name for goal, _ in lots for name in names(goal)}
    for goal in goals if over else ():
        if _counted(goal) is None and over & {*names(goal)}:
            raise refuse("ambiguous", "it is not clear of which of these this is said", goal.span or clause.span,
                         "name the blocks that you mean")  # fmt: skip


def _told_before(goals: list[g.Goal], clause: Clause, scene: Scene) -> None:
    """Refuse "two of the three are on the mat and should not touch the green one": the same two?"""
    told = [m.ref for m in scene.mentions if m.clause == scene.clause - 1 and m.role == "theme"]
    some = any(ref.quant is not None and 0 < ref.quant.low < len(ref.names) for ref in told)
    again = scene.verbs[scene.clause][0] == scene.verbs.get(scene.clause - 1, (None,))[0]
    if again and not clause.negated:
        return  # "one of them is on red or on blue"
    if some or any(isinstance(goal, g.Count) for goal in goals):
        raise refuse("ambiguous", "it is not clear whether this is said of the same ones", clause.span,
                     "name the blocks, or say it without a second verb")  # fmt: skip
