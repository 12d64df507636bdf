"""The stages of a sequence in time: which of them a later one undoes, and what cannot follow another."""

from __future__ import annotations

from rpg.core.diagnostics import Span
from rpg.ir import goal as g
from rpg.ir import relations as r
from rpg.ir import structures as s
from rpg.ir.node import members
from rpg.ir.walk import names as names_in
from rpg.passes.schema.resolve.clauses.changed_after import exchanged_in_line
from rpg.passes.schema.resolve.goals.conflicts import required, undoes
from rpg.passes.schema.resolve.goals.logic import conj
from rpg.passes.schema.resolve.goals.two_ways import across
from rpg.passes.schema.resolve.things.world import Scene, refuse

_LEVEL = (r.LeftOf, r.RightOf, r.InFrontOf, r.Behind, r.Beside, r.Adjacent)
"""How a block on the table stands to another."""


def staged(goals: list[g.Goal], scene: Scene, span: Span) -> tuple[g.Stage, ...]:
    """The goals, each to be met after the one before; refused where what one of them says is not to be told then."""
    steps = _without_their_tops(_put_down(exchanged_in_line(goals, scene)))
    _still_later(steps, scene, span)
    _swaps_later(steps, span)
    made = []
    for index, step in enumerate(steps):
        undone = any(_undone(after, step, scene) or _carried_off(after, step, steps) for after in steps[index + 1 :])
        _lasts(step, undone, span)
        made.append(g.Stage(goal=step, undone=undone))
    return tuple(made)


def _put_down(goals: list[g.Goal]) -> list[g.Goal]:
    """ "Stack red on blue, then put the red block on the mat", or next to the white one: it lies there itself, not on
    what it was put on."""
    found: list[g.Goal] = []
    for index, goal in enumerate(goals):
        there = [x for x in required(goal) if isinstance(x, r.OnPatch)]
        aside = [x for x in required(goal) if isinstance(x, _LEVEL)]
        put = {name for x in (*there, *aside) for name in members(x.a)}
        carried = {n for before in goals[:index] for x in required(before) for n in _carried(x, put)}
        again = {n for x in required(goal) for n in _carried(x, put)}
        there_or_by = [*there, *(x for x in aside if carried.isdisjoint(members(x.b)))]
        down = [n for x in there_or_by for n in members(x.a) if n in carried - again]
        found.append(conj([goal, r.OnTable(a=tuple(dict.fromkeys(down)))]) if down else goal)
    return found


def _without_their_tops(goals: list[g.Goal]) -> list[g.Goal]:
    """ "Stack red, blue and green, then put green back on the table": what it was taken from is a stack still."""
    found = goals[:1]
    for index, goal in enumerate(goals[1:], 1):
        down = {n for x in required(goal) if isinstance(x, r.OnTable) for n in members(x.a)}
        moved = {n for after in goals[index:] for x in required(after) for n in names_in(x)}
        before = [*required(goals[index - 1])]
        stacks = [x for x in before if isinstance(x, s.Stack) and x.order.by == "given"]
        left: list[g.Goal] = [kept for x in stacks if (kept := _without_top(x, down))]
        left += [x for x in before if isinstance(x, r.On)] if any(_carried(x, down) for x in before) else []
        left = [x for x in left if moved.isdisjoint(names_in(x))]
        found.append(conj([goal, *left]) if left else goal)
    return found


def _without_top(stack: s.Stack, down: set[str]) -> s.Stack | None:
    """A stack without the blocks on top of it that are put down, if two or more are left."""
    ranks = stack.order.ranks[:: -1 if stack.order.first == "top" else 1]
    kept = [rank for rank in ranks if down.isdisjoint(rank)]
    if not 1 < len(kept) < len(ranks) or kept != list(ranks[: len(kept)]):
        return None
    order = stack.order.model_copy(update={"ranks": tuple(kept), "first": "bottom"})
    return s.Stack(blocks=tuple(n for n in stack.blocks if n not in down), order=order)


def _carried(told: g.Goal, put: set[str]) -> set[str]:
    """Those of some blocks that rest on a block that is none of them."""
    if isinstance(told, r.On | r.Above):
        return put.intersection(members(told.a)) if put.isdisjoint(members(told.b)) else set()
    if not isinstance(told, s.Stack) or put.issuperset(told.blocks):
        return set()
    order = told.order
    foot = order.ranks[-1 if (order.first == "top") else 0] if order.by == "given" and order.ranks else ()
    return put.intersection(told.blocks).difference(foot)


def _swaps_later(goals: list[g.Goal], span: tuple[int, int]) -> None:
    """Refuse "put red on blue, then swap them": they swap the places that they have then, not those of the start."""
    placed: set[str] = set()
    for goal in goals:
        for swap in (x for x in required(goal) if isinstance(x, r.Swapped)):
            if placed & set(names_in(swap)):
                raise refuse("ambiguous", "blocks that were moved before swap other places than those of the start",
                             swap.span or span, "say where each of them should be at the end")  # fmt: skip
        for shift in (x for x in required(goal) if isinstance(x, r.Shifted | r.Ranged)):
            if placed & set(names_in(shift)) and not _further_across(shift, goals):
                raise refuse("ambiguous", "seen from where it is by then, or from where it started?",
                             shift.span or span, "say where it should be at the end")  # fmt: skip
        for told in (x for x in required(goal) if not isinstance(x, r.Stayed)):
            placed |= {*(names_in(told) if getattr(told, "blocks", ()) else _subjects(told))}


def _further_across(shift: g.Goal, goals: list[g.Goal]) -> bool:
    """Whether all else that becomes of a block is that it goes along the other axis: "forward, then to the left"."""
    rest = [x for goal in goals for x in required(goal) if x is not shift and {*names_in(x)} & {*names_in(shift)}]
    return isinstance(shift, r.Shifted) and all(across(shift, x) for x in rest)


def _lasts(goal: g.Goal, undone: bool, span: tuple[int, int] | None) -> None:
    """Refuse what always holds and is undone by what comes then."""
    if undone and any(isinstance(part, g.Always) for part in (goal.goals if isinstance(goal, g.All) else (goal,))):
        told, hint = "what always holds cannot end with what comes then", "leave 'always' out, or what comes then"
        raise refuse("contradiction", told, span, hint)


def _still_later(goals: list[g.Goal], scene: Scene, span: tuple[int, int] | None) -> None:
    """Refuse "build a row, then do not move its blocks": to stay is to be where the episode began."""
    moved: set[str] = set()
    for goal in goals:
        stay = {n for x in required(goal) if isinstance(x, r.Stayed) for n in names_in(x)} - scene.returned
        if stay & moved:
            told = "a block that is moved first cannot stay where it was at the start"
            raise refuse("ambiguous", told, span, "say where it should be at the end")
        done = [x for x in required(goal) if not isinstance(x, r.Stayed)]
        moved |= {n for x in done for n in (names_in(x) if getattr(x, "blocks", ()) else _subjects(x))}


def _carried_off(later: g.Goal, earlier: g.Goal, steps: list[g.Goal]) -> bool:
    """ "Put red on the mat and then on the white block": red leaves the mat, where white is not said to be."""
    there = [x for step in steps for x in required(step) if isinstance(x, r.OnPatch | r.InRegion)]
    for told in (x for x in required(earlier) if isinstance(x, r.OnPatch | r.InRegion)):
        alike = [x for x in there if _where(x) == _where(told)]
        for put in (x for x in required(later) if isinstance(x, r.On)):
            moved = {*members(put.a)} & {*members(told.a)}
            below = {*members(put.b)}
            if moved and below.isdisjoint(n for x in alike for n in members(x.a)):
                return True
    return False


def _where(told: r.OnPatch | r.InRegion) -> tuple[str, str]:
    return (told.kind, told.patch if isinstance(told, r.OnPatch) else told.region)


def _undone(later: g.Goal, earlier: g.Goal, scene: Scene) -> bool:
    """Whether `earlier` cannot hold any more: `later` contradicts it, or moves its blocks back to where they were."""
    back = {n for x in required(later) if isinstance(x, r.Stayed) for n in names_in(x)} & scene.returned
    gone = {n for x in required(earlier) for n in (names_in(x) if isinstance(x, r.Swapped) else _subjects(x))}
    down = {n for x in required(later) if isinstance(x, r.OnTable) for n in members(x.a)}
    return undoes(later, earlier) or bool(back & gone) or any(_carried(x, down) for x in required(earlier))


def _subjects(atom: g.Goal) -> tuple[str, ...]:
    told = atom.goal if isinstance(atom, g.Not) else atom  # "taken off" is told as not being there
    return members(getattr(told, "a", ()))
