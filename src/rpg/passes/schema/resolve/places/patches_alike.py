"""Patches of which neither look nor place is told: "one patch" and "the other" are these either way round."""

from __future__ import annotations

from collections.abc import Mapping
from itertools import permutations

from rpg.ir import goal as g
from rpg.ir.walk import conjuncts, plain, rename, within
from rpg.ir.walk import names as names_in
from rpg.passes.schema.resolve.goals.logic import conj, disj
from rpg.passes.schema.resolve.things.things import alike
from rpg.passes.schema.resolve.things.world import Scene

_MOST = 3
"""So many patches are told in every way round: of four there are 24."""


def either_way_round(goal: g.Goal, scene: Scene, chosen: set[str]) -> g.Goal:
    """`goal` with any of the patches whose colour was `chosen` in the place of each other.

    What is done step by step may begin with any of them, and comes to one way round in the end. Where a step is undone
    again it is left as it is: which patch is meant is settled then by what comes first.
    """
    begun = {name for fact in scene.start_goals for name in names_in(fact)}
    told = set(names_in(goal))
    free = [t for t in scene.things.values() if t.patch and t.name in (chosen & told) - begun]
    looks = {(t.shape, t.size, t.long, t.extent, t.extra) for t in free}
    over_time = [x for x in within(goal) if isinstance(x, g.Sequence | g.Always)]
    if not 1 < len(free) <= _MOST or len(looks) > 1 or over_time not in ([], [goal]):
        return goal
    names = tuple(t.name for t in free)
    return _in_steps(goal, names, scene) if isinstance(goal, g.Sequence) else _any_way(goal, names, scene)


def _in_steps(goal: g.Sequence, names: tuple[str, ...], scene: Scene) -> g.Goal:
    """Each step on any of the patches, and all of them in one way round."""
    ends = conj([stage.goal for stage in goal.stages], goal.span)
    whole = [part for part in conjuncts(_any_way(ends, names, scene)) if part not in conjuncts(ends)]
    if not whole or any(stage.undone for stage in goal.stages):
        return goal
    stages = tuple(g.Stage(goal=_any_way(stage.goal, names, scene)) for stage in goal.stages)
    return conj([goal.model_copy(update={"stages": stages}), *whole], goal.span)


def _any_way(goal: g.Goal, names: tuple[str, ...], scene: Scene) -> g.Goal:
    """The goal with these patches in every way round."""
    ways: dict[object, list[g.Goal]] = {}
    for way in permutations(names):
        turned = rename(goal, dict(zip(names, way, strict=True)))
        same = rename(turned, _taking_turns(goal, dict(zip(names, way, strict=True)), scene))
        if not ways or _said(same) not in ways:
            ways.setdefault(_said(turned), list(conjuncts(turned)))
    said = [{_said(part) for part in parts} for parts in ways.values()]
    shared = set.intersection(*said)
    if len(ways) == 1 or not all(parts - shared for parts in said):
        return goal
    own = [conj([part for part in parts if _said(part) not in shared], goal.span) for parts in ways.values()]
    kept = [part for part in conjuncts(goal) if _said(part) in shared]
    return conj([*kept, disj(own, goal.span)], goal.span)


def _taking_turns(goal: g.Goal, way: Mapping[str, str], scene: Scene) -> dict[str, str]:
    """The blocks on each patch for those on the one that takes its place, where they look alike."""
    on = {patch: [n for part in conjuncts(goal) if patch in (told := names_in(part)) for n in told] for patch in way}
    turns: dict[str, str] = {}
    for patch, other in way.items():
        here, there = ([n for n in dict.fromkeys(on[x]) if not scene.things[n].patch] for x in (patch, other))
        if len(here) == len(there) and all(
            alike([scene.things[n] for n in two]) for two in zip(here, there, strict=True)
        ):
            turns |= dict(zip(here, there, strict=True))
    same = all(alike([scene.things[one], scene.things[other]]) for one, other in turns.items())
    return turns if same and len(set(turns.values())) == len(turns) else {}


def _said(goal: g.Goal) -> object:
    """What a goal says, in whatever order."""
    flat = plain(goal)
    if isinstance(flat, g.All | g.Any):
        return type(flat), frozenset(map(_said, flat.goals))
    return flat
