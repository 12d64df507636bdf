"""Goal states: physically valid arrangements of blocks that satisfy a goal expression."""

from __future__ import annotations

from random import Random

from rpg.blocks.arrange.explain import Impossible, explain
from rpg.blocks.arrange.solve import Solver, imagined_start
from rpg.blocks.state import BlockState, World
from rpg.ir import goal as g
from rpg.ir.walk import atoms

__all__ = ["CHANGES", "Impossible", "arrange"]

CHANGES = frozenset({"stayed", "moved", "shifted", "approached", "receded", "swapped", "took_place", "turned"})
"""Atoms that compare with the start of the episode."""
IMAGINED = 4
"""Starts that are imagined: a block at the edge of the table has no room to go on that way."""


def arrange(
    goal: g.Goal,
    world: World,
    *,
    rng: Random,
    start: BlockState | None = None,
    count: int = 1,
    natural: bool = True,
) -> list[BlockState]:
    """`count` states in which `goal` holds, every block settled and well inside of the workspace and of tolerances.

    The first one is the most natural where `natural`; equal generators give equal states. `start`: where the episode
    begins, for conditions relative to it (imagined where it is not given); the states carry it. Raises Impossible.
    """
    if start is None and any(atom.kind in CHANGES for atom in atoms(goal)):
        for _ in range(IMAGINED - 1):
            try:
                return _arranged(goal, world, rng, imagined_start(world, rng), count, natural)
            except Impossible:
                continue
        start = imagined_start(world, rng)
    return _arranged(goal, world, rng, start, count, natural)


def _arranged(
    goal: g.Goal, world: World, rng: Random, start: BlockState | None, count: int, natural: bool
) -> list[BlockState]:
    solver = Solver(goal, world, start)
    found: list[BlockState] = []
    for k in range(count):
        state = solver.solve(rng, vary=k > 0 or not natural)
        if state is None and not (found or natural):
            state = solver.solve(rng)
        if state is None and not found:
            raise Impossible(explain(goal, world, start))
        if state is not None:
            found.append(state)
    return found
