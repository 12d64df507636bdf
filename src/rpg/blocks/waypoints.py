"""The scenes of an episode that ends in a goal state: most goals need the last one only, some look back."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from itertools import chain, islice
from random import Random

from rpg.blocks.arrange import CHANGES, Impossible, arrange
from rpg.blocks.arrange.explain import explain
from rpg.blocks.arrange.solve import AT_A_GLANCE, Solver
from rpg.blocks.evaluate import rests, satisfied
from rpg.blocks.initial import foresee
from rpg.blocks.outset import at_every_start
from rpg.blocks.state import BlockState, World
from rpg.ir import goal as g
from rpg.ir.schema import InitialState
from rpg.ir.walk import atoms, children

STARTS = 50
FIXING = frozenset({"stayed", "swapped", "took_place", "shifted", "approached", "receded"})
"""Atoms that say where blocks are at the end by where they were at the start."""
ROOM_TRIES = 800
"""Candidate places that are judged before a start counts as one that leaves no room: room has to be easy to find."""
LIKELY = 4
"""Starts that are tried: from some, what has to stay where it is leaves no room for the goal."""


def looks_back(goal: g.Goal) -> bool:
    """Does the goal depend on more than the state in which it is judged?"""
    return over_time(goal) or any(atom.kind in CHANGES for atom in atoms(goal))


def waypoints(
    goal: g.Goal, init: InitialState, world: World, rng: Random, start: BlockState | None = None
) -> list[BlockState]:
    """Scenes to pass through, the last one a goal state: [goal], or [start, stage by stage ..., goal].

    Raises Impossible where the goal cannot be arranged.
    """
    if not looks_back(goal):
        return arrange(goal, world, rng=rng)[:1]
    compares = any(atom.kind in CHANGES for atom in atoms(goal))
    starts = [start] if start is not None else islice(_starts(goal, init, world), LIKELY if compares else 1)
    failed: tuple[g.Goal, BlockState] | None = None
    for begin in starts:
        scenes = [begin]
        for moment in _moments(goal):
            scene = Solver(moment, world, begin).solve(rng)
            if scene is None:
                failed = failed or (moment, begin)
                break
            scenes.append(replace(scene, start=begin))
        else:
            return scenes
    assert failed is not None
    moment, begin = failed
    raise Impossible(explain(moment, world, begin))


def fixes(goal: g.Goal) -> bool:
    """Does the goal fix where some blocks are at the end by where they start?"""
    return any(atom.kind in FIXING for atom in atoms(goal))


def leaves_room(goal: g.Goal, world: World, start: BlockState, rng: Random) -> bool:
    """Can every scene of an episode that begins with `start` be arranged?"""
    solvers = (Solver(moment, world, start, ROOM_TRIES, AT_A_GLANCE) for moment in _moments(goal))
    return all(solver.solve(rng) is not None for solver in solvers)


def always_ahead(goal: g.Goal, init: InitialState) -> bool:
    """Does a later stage hold at every start?"""
    sequences = (part for part in _conjuncts(goal) if isinstance(part, g.Sequence))
    return any(at_every_start(stage.goal, init) for sequence in sequences for stage in sequence.stages[1:])


def still_ahead(goal: g.Goal) -> tuple[g.Goal, ...]:
    """What holds at the starts from which `goal` is ahead, so that they may be built by it; nothing where it compares
    with them."""
    parts = [part for part in _conjuncts(goal) if part.kind != "stayed"]
    standing = [part.goal for part in parts if isinstance(part, g.Always)]
    first = [part.stages[0].goal for part in parts if isinstance(part, g.Sequence)]
    rest = tuple(part for part in parts if not isinstance(part, g.Always | g.Sequence))
    unmet = first or ([g.All(goals=rest)] if rest else [])
    found = (*standing, *(g.Not(goal=part) for part in unmet))
    return () if not unmet or any(atom.kind in CHANGES for part in found for atom in atoms(part)) else found


def stage_holds(goal: g.Goal, start: BlockState, later: bool) -> bool:
    """Does the first stage of a sequence hold at `start`, or with `later` any one of them?"""
    seen = start.since(start)
    return any(
        satisfied(stage.goal, seen)
        for part in _conjuncts(goal)
        if isinstance(part, g.Sequence)
        for stage in part.stages[: None if later else 1]
    ) and rests(seen)


def _moments(goal: g.Goal) -> Iterator[g.Goal]:
    """What holds in each scene after the start: a stage and those before it, none of those after it."""
    parts = list(_conjuncts(goal))
    stages = [stage for part in parts if isinstance(part, g.Sequence) for stage in part.stages]
    standing = [part for part in parts if isinstance(part, g.Always)]
    for index, stage in enumerate(stages[:-1]):
        kept = [earlier.goal for earlier in stages[:index] if not earlier.undone]
        ahead = [g.Not(goal=later.goal) for later in stages[index + 1 :]]
        yield g.All(goals=(*standing, *kept, stage.goal, *ahead))
    yield goal


def _starts(goal: g.Goal, init: InitialState, world: World) -> Iterator[BlockState]:
    """Starts from which the whole way is still ahead, and nothing is lost that must always hold; any one at last."""
    parts = list(_conjuncts(goal))
    stages = [stage.goal for part in parts if isinstance(part, g.Sequence) for stage in part.stages]
    standing = [part for part in parts if isinstance(part, g.Always)]
    past = any(at_every_start(part, init) for part in (goal, *stages))
    drawn = foresee(init, world)
    first = next(drawn)
    for start in () if past else chain((first,), islice(drawn, STARTS - 1)):
        seen = start.since(start)
        if any(satisfied(part, seen) for part in (*stages, goal)):
            continue
        if all(satisfied(part, seen) for part in standing):
            yield start
    yield first


def _conjuncts(goal: g.Goal) -> Iterator[g.Goal]:
    if isinstance(goal, g.All):
        for part in goal.goals:
            yield from _conjuncts(part)
    else:
        yield goal


def over_time(goal: g.Goal) -> bool:
    """Does the goal depend on what happened in between, so that a task must remember it?"""
    return isinstance(goal, g.Sequence | g.Always) or any(over_time(child) for child in children(goal))
