"""What can only be done after what stands in front of it, though no "then" does: "unstack and restack them"."""

from __future__ import annotations

from collections.abc import Sequence

from rpg.ir import goal as g
from rpg.ir import relations as r
from rpg.ir.node import members
from rpg.language.meaning import Clause, Manner, Pronoun
from rpg.passes.schema.resolve.goals.conflicts import required, undoes
from rpg.passes.schema.resolve.things.world import Scene

Goals = Sequence[g.Goal]


def comes_later(before: Goals, after: Goals, clause: Clause | None, scene: Scene) -> bool:
    """Whether a clause, or a sentence, tells a later step."""
    restacked = bool(before) and _restacked(before, after, scene) and not _left(clause)
    return bool(before) and (restacked or _refilled(before, after, scene) or _put_back(clause))


def _restacked(before: Goals, after: Goals, scene: Scene) -> bool:
    """ "unstack the tower and rebuild it": what was taken apart is stacked afterwards, not at the same time."""
    taken = [x for x in before if isinstance(x, r.OnTable) and scene.unstacked.issuperset(members(x.a))]
    return bool(taken) and any(undoes(x, y) for x in after for y in taken)


def _left(clause: Clause | None) -> bool:
    """ "(Take the tower apart,) but leave two of them stacked": they are so all the time."""
    theme, word = (clause.theme, clause.word) if clause is not None else (None, None)
    return theme is not None and word is not None and getattr(clause, "verb", "") == "stack" and word > theme.span


def _refilled(before: Goals, after: Goals, scene: Scene) -> bool:
    """ "(Red starts on the mat.) Clear the mat and put the green block on it": it is there when the mat was empty."""
    filled = {x.patch for x in scene.start_goals if isinstance(x, r.OnPatch)}
    emptied = {x.patch for goal in before for x in required(goal) if isinstance(x, r.Empty)} & filled
    return any(isinstance(x, r.OnPatch) and x.patch in emptied for goal in after for x in required(goal))


def _put_back(clause: Clause | None) -> bool:
    """ "Take red off blue and put it back where it was"."""
    if clause is None:
        return False
    told = clause.mode == "command" and clause.verb in ("place", "stack") and isinstance(clause.theme, Pronoun)
    return told and any(isinstance(a, Manner) and a.kind == "stay" for a in clause.adjuncts)
