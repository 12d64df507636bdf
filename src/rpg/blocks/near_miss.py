"""Near-misses of a goal state: states a small change away in which the goal must not hold, each with what was done.

For every condition of the goal, what its predicate can spoil by construction: past each tolerance, on the other side,
the wrong one. For conditions of several parts, an arrangement of everything else in which just this one fails. And
what any placed structure must notice: a block moved off, lifted, tilted or gone, two unlike ones exchanged.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import combinations, islice
from random import Random

from rpg.blocks.alike import Judge
from rpg.blocks.arrange.explain import conditions
from rpg.blocks.arrange.solve import AT_A_GLANCE, Solver
from rpg.blocks.evaluate import satisfied
from rpg.blocks.geometry import riders
from rpg.blocks.predicate import NearMiss
from rpg.blocks.predicates import PREDICATES
from rpg.blocks.predicates.common import put, set_aside, shift, swap, tilted
from rpg.blocks.state import BlockState
from rpg.ir import goal as g
from rpg.ir.walk import atoms, children, instances, names

MOST_INNER = 12
"""Near-misses of what is inside of one condition."""
PER_KIND = 6
"""Generic near-misses of each kind."""
ARRANGE_TRIES = 200
"""Candidate places for an arrangement in which one condition fails: those that exist are found within a hundred."""
LIFT = 0.03
TILT = 35.0
GONE = (1.3, 0.0)
"""A place on the floor beside the table."""


def near_misses(goal: g.Goal, state: BlockState, rng: Random) -> list[NearMiss]:
    """States close to `state` (in which `goal` holds) in which it must not hold."""
    of_conditions, generic = both_kinds(goal, state, rng, Judge(goal, state.world))
    return of_conditions + generic


def both_kinds(goal: g.Goal, state: BlockState, rng: Random, judge: Judge) -> tuple[list[NearMiss], list[NearMiss]]:
    """Near-misses of single conditions, in which the goal does not hold under other names, and is not to hold with its
    own; and those of any structure, in which it holds under no names, as is known of them."""
    of_conditions = [miss for miss in _of_conditions(goal, state, rng) if not judge.renamed(miss.state)]
    return of_conditions, [miss for miss in _generic(goal, state, rng) if not judge.any_name(miss.state)]


def _of_conditions(goal: g.Goal, state: BlockState, rng: Random) -> Iterator[NearMiss]:
    parts = list(conditions(goal))
    for part in parts:
        others = [other for other in parts if other is not part]
        predicate = PREDICATES.get(part.kind)
        misses = list(predicate.near_misses(part, state, rng)) if predicate is not None else []
        yield from misses
        if predicate is None:
            yield from islice(_of_what_holds(part, state, rng), MOST_INNER)
        if not misses:
            yield from _arranged_without(part, others, state, rng)


def _of_what_holds(part: g.Goal, state: BlockState, rng: Random) -> Iterator[NearMiss]:
    """Near-misses of the atoms that make a condition of several parts true, where they spoil the whole of it."""
    for atom in _instances(part):
        if satisfied(atom, state):
            for miss in PREDICATES[atom.kind].near_misses(atom, state, rng):
                if not satisfied(part, miss.state):
                    yield miss


def _instances(goal: g.Goal) -> Iterator[g.Atom]:
    """The atoms of a goal, with each block that is counted in its place."""
    if isinstance(goal, g.Count):
        for part in instances(goal):
            yield from _instances(part)
    elif children(goal):
        for part in children(goal):
            yield from _instances(part)
    else:
        yield from atoms(goal)


def _arranged_without(part: g.Goal, others: list[g.Goal], state: BlockState, rng: Random) -> Iterator[NearMiss]:
    """Everything else holds, and this condition does not."""
    for what, broken in _violations(part):
        violated = _quick(g.All(goals=(*others, broken)), state).solve(rng)
        if violated is not None:
            yield NearMiss(what, violated)


def _quick(goal: g.Goal, state: BlockState) -> Solver:
    """A solver that takes a quick look at every alternative: many of these goals cannot be met at all."""
    return Solver(goal, state.world, state.start, ARRANGE_TRIES, AT_A_GLANCE)


def _violations(part: g.Goal) -> Iterator[tuple[str, g.Goal]]:
    """Goals under which a condition fails, by as little as it can."""
    match part:
        case g.Count():
            if part.at_least > 0:
                fewer = part.at_least - 1
                yield "one too few", part.model_copy(update={"at_least": fewer, "at_most": fewer})
            if part.at_most is not None and part.at_most < len(part.over):
                more = part.at_most + 1
                yield "one too many", part.model_copy(update={"at_least": more, "at_most": more})
        case g.Not():
            yield "what must not be", part.goal
        case g.Any():
            yield "none of the alternatives", g.Not(goal=part)
        case _:
            yield f"{part.kind.replace('_', ' ')} does not hold", g.Not(goal=part)


def _generic(goal: g.Goal, state: BlockState, rng: Random) -> Iterator[NearMiss]:
    mentioned = [name for name in names(goal) if name in state.position]
    some = rng.sample(mentioned, min(PER_KIND, len(mentioned)))
    for name in some:
        yield NearMiss(f"{name} moved off", set_aside(state, name))
        if not riders(state, name):
            yield NearMiss(f"{name} lifted", shift(state, [name], 0.0, 0.0, LIFT))
        yield NearMiss(f"{name} tilted", tilted(state, name, TILT))
        yield NearMiss(f"{name} gone", put(state, name, (*GONE, state.world.edge[name] / 2)))
    look = state.world.look
    unlike = [(a, b) for a, b in combinations(mentioned, 2) if look[a] != look[b]]
    for a, b in rng.sample(unlike, min(PER_KIND, len(unlike))):
        yield NearMiss(f"{a} and {b} exchanged", swap(state, a, b))
