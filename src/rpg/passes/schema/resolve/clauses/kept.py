""" "Keep red on blue", "leave red on blue": it is so and stays so; where nothing else is to be done, it has to get
there."""

from __future__ import annotations

from collections.abc import Sequence

from rpg.ir import goal as g
from rpg.ir import relations as r
from rpg.ir.node import members
from rpg.ir.structures import Row, Stack
from rpg.ir.walk import names
from rpg.language.meaning import Clause, Coord, In, Loc, Meaning, Noun, Pronoun, TableTop
from rpg.passes.schema.resolve.goals.logic import conj
from rpg.passes.schema.resolve.things.world import Ref, Scene


def put_so(clause: Clause, theme: Ref, scene: Scene) -> bool:
    """ "Put red and blue on the mat and keep them 10 cm apart": how those are to be that are moved in the sentence, and
    were nowhere before."""
    ahead = [m for m in scene.mentions if m.role == "theme" and m.sentence == scene.sentence and not m.start]
    moved = {name for m in ahead if m.clause < scene.clause for name in m.ref.names}
    begun = {name for fact in scene.start_goals for name in names(fact)}
    denied = any(getattr(x, "negated", False) or getattr(x, "rel", "") == "off" for x in clause.adjuncts)
    return {*theme.names} <= moved - begun and not denied


def left_so(clause: Clause, theme: Ref, scene: Scene) -> bool:
    """ "Take red off the mat and leave blue on it": a block that is known, and that was neither moved nor told of at
    the start before, is there already; "leave one on the mat" and "take red off and leave it there" tell of the end."""
    if clause.lemma != "leave" or clause.mode != "command" or clause.negated or not _known(clause.theme):
        return False
    ahead = [m for m in scene.mentions if m.role == "theme" and m.clause < scene.clause and not m.start]
    moved = {name for m in ahead for name in m.ref.names if not _others(clause.theme)}
    begun = {name for fact in scene.start_goals for name in _told_of(fact)}
    somewhere = [x for x in clause.adjuncts if isinstance(x, Loc | In)]
    there = all(not x.negated and (isinstance(x, In) or x.rel != "off") for x in somewhere)
    table = any(isinstance(x, Loc) and isinstance(x.landmark, TableTop) for x in somewhere)
    return there and not table and {*theme.names}.isdisjoint(moved | begun)


def of_what_is_built(goals: Sequence[g.Goal], scene: Scene) -> bool:
    """ "Make a tower of three, leave the other two next to it": which they cannot be before it is there."""
    begun = [{*members(fact.blocks)} for fact in scene.start_goals if isinstance(fact, Stack | Row)]
    built = [{*line.members} for line in scene.built if line.kind in ("stack", "row")]
    return any(line < {*names(goal)} for line in built if line not in begun for goal in goals)


def _told_of(fact: g.Goal) -> tuple[str, ...]:
    """The blocks of which a fact says where they are, which what bears them is none of."""
    return members(fact.a) if isinstance(fact, r.On | r.OnPatch) else tuple(names(fact))


def _others(theme: Meaning | None) -> bool:
    """ "the other one", "the rest": those of a lot that are not moved, though the lot was spoken of."""
    if isinstance(theme, Pronoun):
        return theme.word.startswith(("the other", "the rest"))
    return isinstance(theme, Noun) and theme.det == "other"


def _known(theme: Meaning | None) -> bool:
    """ "the red block", "all the others", "A and B"."""
    if isinstance(theme, Coord):
        return all(map(_known, theme.items))
    if _others(theme):
        return True
    single = isinstance(theme, Noun) and theme.det == "bare" and not theme.amount and not theme.plural
    return isinstance(theme, Noun) and (single or theme.det in ("the", "all", "both"))


def brought_about(goal: g.Goal, scene: Scene) -> g.Goal:
    """A goal that only keeps what is so already asks for nothing: what is kept is then to be brought about.

    "Keep red near blue without the two touching": what is denied of blocks whose start nobody told need not be done.
    """
    parts = goal.goals if isinstance(goal, g.All) else (goal,)
    if (freed := _beside_what_is_built(parts, scene)) is not None:
        return conj(freed, goal.span)
    kept = [always for always, _ in scene.kept]
    begun = [fact for _, facts in scene.kept for fact in facts]
    told = {name for fact in scene.start_goals if fact not in begun for name in names(fact)}
    denied = [part for part in parts if isinstance(part, g.Not) and told.isdisjoint(names(part))]
    if not any(part in kept for part in parts) or not all(part in kept or part in denied for part in parts):
        return goal
    scene.start_goals = [fact for fact in scene.start_goals if fact not in begun]
    scene.assume("nothing else is to be done: what is to be kept is brought about, and need not be so at the start")
    return conj([part.goal if isinstance(part, g.Always) else part for part in parts], goal.span)


def _beside_what_is_built(parts: Sequence[g.Goal], scene: Scene) -> list[g.Goal] | None:
    """The goals when a block is kept beside a tower that is only built: "stack the red blocks and keep the blue one
    next to the stack" cannot be so from the start on. None if there is no such."""
    kept = [always for always, _ in scene.kept]
    begun = {name for fact in scene.start_goals for name in names(fact) if isinstance(fact, Stack)}
    built = {name for part in parts if isinstance(part, Stack) for name in part.blocks} - begun
    themes = {name for part in parts if part in kept and built & {*names(part)} for name in names(part)} - built
    freed = [part for part in parts if part in kept and themes & {*names(part)}]
    if not freed:
        return None
    gone = [fact for always, facts in scene.kept if always in freed for fact in facts]
    scene.start_goals = [fact for fact in scene.start_goals if fact not in gone]
    scene.assume("what is to be kept beside a tower that is only built is to be so at the end")
    return [part.goal if part in freed and isinstance(part, g.Always) else part for part in parts]
