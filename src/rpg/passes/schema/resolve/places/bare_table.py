"""The table beside its patches: "move the red block from the mat to the table" is off the mat."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable

from rpg.core.diagnostics import Span
from rpg.ir import goal as g
from rpg.ir import relations as r
from rpg.ir.node import members
from rpg.ir.walk import atoms, children, names, rebuild
from rpg.language.meaning import Loc, Meaning, TableTop
from rpg.passes.schema.resolve.goals.conflicts import undoes
from rpg.passes.schema.resolve.goals.logic import conj
from rpg.passes.schema.resolve.things.operands import base_of, foot, spread
from rpg.passes.schema.resolve.things.world import Ref, Scene, refuse

Marks = dict[str, dict[str, None]]
"""The patches on which a block was before."""


def is_table(place: Meaning) -> bool:
    """ "On the table", "off the table"."""
    return isinstance(place, Loc) and isinstance(place.landmark, TableTop)


def lies_on(place: Meaning) -> bool:
    """ "(Remove the block) on top of the red block": where it lies."""
    return isinstance(place, Loc) and place.rel == "on" and not place.negated and not is_table(place)


def on_the_table(theme: Ref, loc: Loc, scene: Scene, span: Span) -> g.Goal:
    """ "on the table", which says nothing of a structure unless it was on a patch before."""
    if loc.rel in ("off", "above"):
        raise refuse("out-of-reach", "blocks cannot leave the table", loc.span,
                     "say where on the table, or on which block, they should be")  # fmt: skip
    if loc.rel == "touching" and any(m.ref.patch and m.clause == scene.clause for m in scene.mentions):
        raise refuse("contradiction", "what is put on a patch lies on the table", loc.span, "leave one of them out")
    if loc.rel in ("front", "behind"):
        raise refuse(
            "out-of-reach",
            "blocks must stay on the table",
            loc.span,
            "say 'the near half of the table' or 'the far half of the table'",
        )
    if isinstance(loc.landmark, TableTop) and loc.landmark.bare and not (loc.negated or scene.denying):
        scene.on_bare.update(theme.names)
    rows = len(theme.built) > 1 and all(built.kind in ("row", "line", "column") for built in theme.built)
    if theme.patch:
        return g.All(goals=())
    if theme.built and not rows:
        before: Marks = defaultdict(dict)
        _note(scene.start_goals, before)
        if loc.rel == "on" and not before.keys().isdisjoint(theme.names):
            return r.OnTable(a=foot(theme), span=span)
        return g.All(goals=())  # one row stands on what its blocks stand on; of several one may be on another
    if (
        theme.quant is None
        and theme.op == "and"
        and any(scene.on_clause.get(n) == scene.clause for n in theme.names)
        and loc.rel == "on"
        and not (loc.negated or scene.denying)
    ):
        names = tuple(n for n in theme.names if n not in scene.on_top)
        lower = {base_of(n, scene) for n in theme.names}
        theme = Ref(names=tuple(dict.fromkeys((*names, *sorted(lower)))))
    return spread(theme, lambda a: r.OnTable(a=a, span=span), span, together=True)


def off_their_patches(goal: g.Goal, scene: Scene) -> g.Goal:
    """The goal, in which what is put on the table is on no patch on which it was: there it lay on the table as well."""
    before: Marks = defaultdict(dict)
    _note(scene.start_goals, before)
    patches = [thing.name for thing in scene.things.values() if thing.patch]
    for name in scene.on_bare if patches else ():
        before[name].update(dict.fromkeys(patches))
    return _off(goal, before, ()) if before or any(isinstance(x, g.Sequence) for x in (goal, *children(goal))) else goal


def besides_their_patches(goal: g.Goal) -> g.Goal:
    """ "On the mat, not on the table": the bare table, where a block on a patch is not."""
    if not isinstance(goal, g.All):
        return goal
    there = {name for part in goal.goals if isinstance(part, r.OnPatch) for name in members(part.a)}
    kept = tuple(part for part in goal.goals if not (_denies_table(part) and there.issuperset(names(part))))
    return conj(kept, goal.span) if len(kept) < len(goal.goals) else goal


def off_is_elsewhere(goal: g.Goal) -> g.Goal:
    """ "Off the mat, anywhere else": what is off the mat has been moved; it need not be moved any farther."""
    if not isinstance(goal, g.All):
        return goal
    denied = [part.goal for part in goal.goals if isinstance(part, g.Not)]
    off = {name for atom in denied if isinstance(atom, r.OnPatch) for name in members(atom.a)}
    farther = r.Moved.model_fields["at_least"].default
    kept = tuple(
        part for part in goal.goals
        if not (isinstance(part, r.Moved) and part.at_least == farther and off.issuperset(members(part.a)))
    )  # fmt: skip
    return conj(kept, goal.span) if len(kept) < len(goal.goals) else goal


def _denies_table(goal: g.Goal) -> bool:
    return isinstance(goal, g.Not) and isinstance(goal.goal, r.OnTable)


def _note(goals: Iterable[g.Goal], before: Marks) -> None:
    for atom in (a for goal in goals for a in atoms(goal) if isinstance(a, r.OnPatch)):
        for name in members(atom.a):
            before[name][atom.patch] = None


def _off(goal: g.Goal, before: Marks, over: tuple[str, ...]) -> g.Goal:
    if isinstance(goal, g.Always | g.Not) or (isinstance(goal, g.Count) and not goal.at_least):
        return goal  # nothing is put anywhere
    if isinstance(goal, r.OnTable):
        pairs: list[tuple[tuple[str, ...], str]] = [
            ((n,), patch) for n in members(goal.a) for patch in before.get(n, ())
        ]
        pairs += [(members(goal.a), patch) for patch in dict.fromkeys(p for n in over for p in before.get(n, ()))]
        there = [r.OnPatch(a=names, patch=patch, span=goal.span) for names, patch in pairs]
        return conj([goal, *(g.Not(goal=x, span=goal.span) for x in there)], goal.span) if there else goal
    if isinstance(goal, g.Sequence):
        goals: list[g.Goal] = []
        for stage in goal.stages:
            goals.append(_off(stage.goal, before, over))
            _note([stage.goal], before)
        undone = [any(undoes(after, one) for after in goals[n + 1 :]) for n, one in enumerate(goals)]
        stages = tuple(
            g.Stage(goal=one, undone=stage.undone or gone)
            for stage, one, gone in zip(goal.stages, goals, undone, strict=True)
        )
        return goal.model_copy(update={"stages": stages})
    inner = children(goal)
    for put in (x for x in inner if isinstance(goal, g.All) and isinstance(x, r.OnPatch)):  # it lies on that itself
        on = {*members(put.a)}
        left = {n: {p: None for p in marks if n not in on or p != put.patch} for n, marks in before.items()}
        before = defaultdict(dict, left)
    bound = goal.over if isinstance(goal, g.Count) else over
    return rebuild(goal, tuple(_off(child, before, bound) for child in inner)) if inner else goal
