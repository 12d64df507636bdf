"""Random worlds, states and goals that are true in them, for properties that must hold of every goal."""

from __future__ import annotations

from random import Random
from typing import Any

from rpg.blocks.constants import TABLE_Z
from rpg.blocks.evaluate import evaluate
from rpg.blocks.state import IDENTITY, BlockState, World
from rpg.blocks.symmetry import link
from rpg.ir import goal as g
from rpg.ir.assets import Asset, ColoredCube, GoalPatch

COLORS = ("red", "blue", "green", "yellow", "purple")
PATCHES = (("red", 0.55, 0.15), ("blue", 0.55, -0.15), ("green", 0.5, 0.0))
DIRECTIONS = ("left_of", "right_of", "in_front_of", "behind")
REGIONS = ("left_half", "right_half", "near_half", "far_half", "middle", "corner", "edge", "near_left_corner")
PAIRS = ("on", "above", "touching", "beside", "adjacent", "near", "apart")
KINDS = (*DIRECTIONS, *PAIRS, *PAIRS, "on_table", "clear", "in_region", "on_patch", "empty", "between", "stack", "row")


def random_world(rng: Random) -> World:
    """Two to eight blocks, some of which look alike, and up to two patches."""
    assets: list[Asset] = []
    for _ in range(rng.randint(2, 8)):
        color = rng.choice(COLORS)
        number = sum(asset.color == color for asset in assets) + 1
        assets.append(ColoredCube(name=f"{color}_block_{number}", color=color))
    for color, x, y in rng.sample(PATCHES, rng.randint(0, 2)):
        assets.append(GoalPatch(name=f"{color}_patch", color=color, position=(x, y)))
    return World(assets)


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
    if kind in DIRECTIONS:
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
    elif kind in ("between", "row"):
        some = rng.sample(blocks, min(3, len(blocks)))
        if len(some) < 3:
            return random_atom(world, rng)
        fields = (
            {"kind": kind, "blocks": some}
            if kind == "row"
            else {"kind": kind, "a": some[0], "b": some[1], "c": some[2]}
        )
    return random_atom(world, rng) if "none" in fields.values() else g.GOAL.validate_python(fields)


def true_condition(world: World, state: BlockState, rng: Random) -> g.Goal | None:
    """A condition that holds in `state` with some margin, now and then one with "not" or "or" in it."""
    for _ in range(60):
        atom = random_atom(world, rng)
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
    found = [true_condition(world, state, rng) for _ in range(rng.randint(1, 5))]
    goal = g.All(goals=tuple(condition for condition in found if condition is not None))
    return link(goal, world), world, state
