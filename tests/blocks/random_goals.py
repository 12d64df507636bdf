"""Random worlds, states and goals that are true in them, for properties that must hold of every goal."""

from __future__ import annotations

import math
from dataclasses import replace
from itertools import combinations
from random import Random
from typing import Any

from rpg.blocks.arrange import Impossible, arrange
from rpg.blocks.constants import TABLE_Z
from rpg.blocks.evaluate import evaluate, settled
from rpg.blocks.geometry import body_gap
from rpg.blocks.state import IDENTITY, BlockState, World, yaw_quat
from rpg.blocks.symmetry import link
from rpg.ir import goal as g
from rpg.ir.assets import Asset, ColoredCube, GoalPatch
from tests.blocks.random_structures import random_structure

COLORS = ("red", "blue", "green", "yellow", "purple")
PATCHES = (("red", 0.55, 0.15), ("blue", 0.55, -0.15), ("green", 0.5, 0.0))
DIRECTIONS = ("left_of", "right_of", "in_front_of", "behind")
REGIONS = ("left_half", "right_half", "near_half", "far_half", "middle", "corner", "edge", "near_left_corner")
PAIRS = ("on", "above", "touching", "beside", "adjacent", "near", "apart")
PLACES = ("on_table", "clear", "in_region", "on_patch", "empty")
CHANGES = ("stayed", "moved", "shifted", "approached", "receded", "swapped", "took_place", "turned")
KINDS = (*DIRECTIONS, *PAIRS, *PAIRS, *PLACES, "distance", "between", "closer", "equidistant", "stack", "row")


def random_world(rng: Random) -> World:
    """Two to eight blocks, some of which look alike, and up to two patches."""
    assets: list[Asset] = []
    for _ in range(rng.randint(2, 8)):
        color = rng.choice(COLORS)
        number = sum(asset.color == color for asset in assets) + 1
        assets.append(ColoredCube(name=f"{color}_block_{number}", color=color))
    return World([*assets, *_patches(rng)])


def random_state(world: World, rng: Random) -> BlockState:
    """Stacks here and there, some of them close to each other."""
    piles: list[list[str]] = []
    for name in world.blocks:
        if piles and rng.random() < 0.35:
            rng.choice(piles).append(name)
        else:
            piles.append([name])
    spots: list[tuple[float, float]] = []
    while len(spots) < len(piles):
        x, y = rng.uniform(0.42, 0.68), rng.uniform(-0.23, 0.23)
        if spots and rng.random() < 0.5:
            (u, v), step = rng.choice(spots), rng.choice((0.045, 0.05, 0.06, 0.08))
            dx, dy = rng.choice(((1, 0), (-1, 0), (0, 1), (0, -1)))
            x, y = u + step * dx, v + step * dy
        inside = 0.41 <= x <= 0.69 and -0.24 <= y <= 0.24
        if inside and all(max(abs(x - u), abs(y - v)) >= 0.045 for u, v in spots):
            spots.append((x, y))
    position = {
        name: (x, y, TABLE_Z + 0.02 + 0.04 * level)
        for pile, (x, y) in zip(piles, spots, strict=True)
        for level, name in enumerate(pile)
    }
    return BlockState(world, {n: position[n] for n in world.blocks}, dict.fromkeys(world.blocks, IDENTITY))


def random_atom(world: World, rng: Random) -> g.Goal:
    """Any relation between blocks and patches of the world, or a small structure."""
    blocks, patches = list(world.blocks), list(world.patches)
    a, b = rng.sample(blocks, 2)
    kind = rng.choice(KINDS)
    fields: dict[str, Any] = {"kind": kind, "a": a, "b": b}
    if kind == "distance":
        least = rng.choice((0.05, 0.08, 0.12))
        fields |= {"minimum": least, "maximum": least + 0.03}
    elif kind in DIRECTIONS:
        fields |= {flag: rng.random() < 0.2 for flag in ("somewhere", "directly", "immediate")}
        if patches and rng.random() < 0.3:
            fields["b"] = rng.choice(patches)
        elif len(blocks) >= 4 and rng.random() < 0.2:
            some = rng.sample(blocks, 4)
            fields |= {"a": some[:2], "b": some[2:]}
    elif kind in ("on_table", "clear"):
        del fields["b"]
    elif kind == "in_region":
        fields = {"kind": kind, "a": a, "region": rng.choice(REGIONS)}
    elif kind in ("on_patch", "empty"):
        fields = {"kind": kind, "patch": rng.choice(patches or ["none"])} | ({"a": a} if kind == "on_patch" else {})
    elif kind == "stack":
        fields = {
            "kind": kind,
            "blocks": rng.sample(blocks, min(len(blocks), rng.choice((2, 3)))),
            "exact": rng.random() < 0.5,
        }
    elif kind in ("between", "closer", "equidistant", "row"):
        some = rng.sample(blocks, min(3, len(blocks)))
        if len(some) < 3:
            return random_atom(world, rng)
        fields = (
            {"kind": kind, "blocks": some}
            if kind == "row"
            else {"kind": kind, "a": some[0], "b": some[1], "c": some[2]}
        )
    return random_atom(world, rng) if "none" in fields.values() else g.GOAL.validate_python(fields)


def random_change(world: World, rng: Random) -> g.Goal:
    """A condition relative to the start of the episode."""
    a, b = rng.sample(list(world.blocks), 2)
    kind = rng.choice(CHANGES)
    fields: dict[str, Any] = {"kind": kind, "a": a}
    if kind in ("swapped", "took_place", "approached", "receded"):
        fields["b"] = b
    elif kind == "shifted":
        fields["toward"] = rng.choice(("left", "right", "front", "back"))
    elif kind == "turned":
        fields = {"kind": kind, "block": a, "degrees": rng.choice((45.0, 90.0, -90.0))}
    return g.GOAL.validate_python(fields)


def played_on(start: BlockState, rng: Random) -> BlockState:
    """What one to three moves make of a start: a free block put elsewhere, two free blocks exchanged, or one turned."""
    position, orientation = dict(start.position), dict(start.orientation)
    for _ in range(rng.randint(1, 3)):
        free = [n for n, p in position.items() if not any(q[:2] == p[:2] and q[2] > p[2] for q in position.values())]
        a, b = rng.choice(free), rng.choice(free)
        match rng.choice(("put", "exchanged", "turned")):
            case "put":
                spots = random_state(start.world, rng).position.values()
                clear = [
                    (x, y, TABLE_Z + 0.02)
                    for x, y, _ in spots
                    if all(max(abs(x - u), abs(y - v)) >= 0.045 for u, v, _ in position.values())
                ]
                position[a] = rng.choice(clear) if clear else position[a]
            case "exchanged":
                position[a], position[b] = position[b], position[a]
            case _:
                orientation[a] = yaw_quat(rng.choice((math.pi / 4, math.pi / 2, -math.pi / 2)))
    state = BlockState(start.world, position, orientation, start=start)
    return state if settled(state) and not _overlap(state) else replace(start, start=start)


def _overlap(state: BlockState) -> bool:
    return any(body_gap(state, *pair) < 0.0 for pair in combinations(state.position, 2))


def true_condition(world: World, state: BlockState, rng: Random) -> g.Goal | None:
    """A condition that holds in `state` with some margin, now and then one with "not" or "or" in it."""
    for _ in range(60):
        atom = random_change(world, rng) if state.start and rng.random() < 0.5 else random_atom(world, rng)
        verdict = evaluate(atom, state)
        if verdict.margin > 0.02:
            return atom if rng.random() > 0.1 else g.Any(goals=(atom, random_atom(world, rng)))
        if verdict.margin < -0.05 and rng.random() < 0.04:
            return g.Not(goal=atom)
    return None


def random_task(seed: int) -> tuple[g.Goal, World, BlockState]:
    """A goal of one to five conditions that are true together, as a witness state shows."""
    rng = Random(seed)
    world = random_world(rng)
    state = random_state(world, rng)
    return link(_together(world, state, rng.randint(1, 5), rng), world), world, state


def random_change_task(seed: int) -> tuple[g.Goal, World, BlockState] | None:
    """As random_task, with a start that conditions look back to; None if that satisfies them already."""
    rng = Random(seed)
    world = random_world(rng)
    start = random_state(world, rng)
    state = played_on(start, rng)
    goal = link(_together(world, state, rng.randint(1, 3), rng), world)
    return None if evaluate(goal, replace(start, start=start)) else (goal, world, state)


def random_composition(seed: int) -> tuple[g.Goal, World, BlockState] | None:
    """A structure, and what is true of its blocks, of others beside it and of patches; None if it cannot be formed."""
    rng = Random(seed)
    structure, assets = random_structure(seed)
    extra = [ColoredCube(name=f"extra_{k}", color=rng.choice(COLORS)) for k in range(rng.randint(0, 3))]
    world = World([*assets, *extra, *_patches(rng)])
    try:
        (state,) = arrange(structure, world, rng=rng)
    except Impossible:
        return None
    goal = g.All(goals=(structure, *_together(world, state, rng.randint(0, 3), rng).goals))
    return link(goal, world), world, state


def _together(world: World, state: BlockState, count: int, rng: Random) -> g.All:
    found = [true_condition(world, state, rng) for _ in range(count)]
    return g.All(goals=tuple(condition for condition in found if condition is not None))


def _patches(rng: Random) -> list[Asset]:
    places = rng.sample(PATCHES, rng.randint(0, 2))
    return [GoalPatch(name=f"{color}_patch", color=color, position=(x, y)) for color, x, y in places]
