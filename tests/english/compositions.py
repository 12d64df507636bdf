"""Random tasks of several parts: structures with relations that hold beside them, counts, alternatives, stages, starts.

What is drawn is true together in a witness state, and says nothing that no sentence says.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from random import Random
from typing import Any

from rpg.blocks.evaluate import evaluate
from rpg.blocks.state import BlockState, World
from rpg.blocks.symmetry import assignments, interchangeable, link
from rpg.ir import goal as g
from rpg.ir import relations as r
from rpg.ir import structures as s
from rpg.ir.assets import Asset, GoalPatch
from rpg.ir.node import members
from rpg.ir.order import Order
from rpg.ir.schema import InitialState, TaskSchema
from rpg.ir.walk import atoms, names, transform
from tests.blocks.random_goals import random_change_task, random_composition, random_task

SYMBOLIC = ("label", "number")
LEVEL = frozenset(
    {"beside", "adjacent", "near", "apart", "distance", "between", "left_of", "right_of", "in_front_of", "behind"}
)
MOST_DIGITS = 10
NAMINGS = 500
SHARE = 0.25
"""Of the tasks, how many have a start, stages, or a count."""

EARLY = r.Swapped | r.TookPlace | r.Shifted | r.Ranged
"""What is seen from the start is told before anything is moved."""


def composed(seed: int) -> TaskSchema | None:
    """A task of the given number; None where nothing is drawn that can be said."""
    rng = Random(seed)
    make = (random_task, random_composition, random_change_task, random_composition)[seed % 4]
    drawn = make(seed)
    if drawn is None:
        return None
    goal, world, state = drawn
    parts = [
        transform(part, lambda node: sayable(node, world))
        for part in (goal.goals if isinstance(goal, g.All) else (goal,))
    ]
    parts = [part for part in _unlike(parts) if _plain(part, parts)]
    if rng.random() < SHARE and (counted := _count(world, state, rng)) is not None:
        parts.append(counted)
    if not any(name in world.blocks for part in parts for name in names(part)):
        return None
    if all(isinstance(part, r.Stayed) for part in parts):
        return None  # so from the beginning, and nothing to be done
    whole = parts[0] if len(parts) == 1 else g.All(goals=tuple(parts))
    if len(parts) > 1 and rng.random() < SHARE and _one_after_another(parts):
        # Blocks are on the table first: that is no stage. Places are those of the start only before anything moves.
        parts.sort(key=lambda x: (isinstance(x, r.OnTable), not isinstance(x, r.Stayed), not isinstance(x, EARLY)))
        whole = g.Sequence(stages=tuple(g.Stage(goal=part) for part in parts))
    cells = interchangeable(whole, world)
    if math.prod(assignments(group) for group in cells) > NAMINGS:
        return None
    digits = sum(getattr(block, "label", "").isdigit() for block in world.blocks.values())
    return None if digits > MOST_DIGITS else _schema(whole, world, _start(whole, world, rng), rng)


def sayable(node: g.Goal, world: World) -> g.Goal:
    """A goal without what no sentence says: symbols to be read where nothing is spelled, directions of a lying line."""
    update: dict[str, Any] = {}
    if isinstance(node, s.Row):
        update = {"readable": node.order.by in SYMBOLIC, "order": _line_order(node.order, node.blocks, world)}
        if node.spacing is not None:
            update["spacing"] = 0.05
        if node.axis is None and node.order.first is not None:
            update["axis"] = "y" if node.order.first in ("left", "right") else "x"
    elif isinstance(node, s.Stack):
        update = {"readable": node.order.by in SYMBOLIC, "order": _line_order(node.order, node.blocks, world)}
    elif isinstance(node, s.Cells):
        order = node.pattern.order if node.pattern is not None else Order()
        update["readable"] = order.by in SYMBOLIC
        if order.by in ("together", "any") and node.pattern is not None and node.pattern.kind == "reading":
            update |= {"pattern": None, "readable": False}
        lines = node.pattern is not None and node.pattern.kind != "reading"
        if lines and not isinstance(node, s.Grid):
            update["pattern"] = None
        if isinstance(node, s.Grid):
            update["axis"] = None
        kept = update.get("pattern", node.pattern)
        flat = isinstance(node, s.Figure) or (isinstance(node, s.Grid) and node.layers == 1)
        if kept is not None and flat:
            update["pattern"] = kept.model_copy(update={"upward": False})
    elif isinstance(node, s.Spells):
        update["blocks"] = _needed(node, world)
    elif isinstance(node, s.Towers) and node.count is None:
        update["equal"], update["count"] = False, _pairs(node)
    elif node.kind in ("left_of", "right_of", "in_front_of", "behind"):
        immediate = bool(getattr(node, "immediate", False))
        directly = immediate or bool(getattr(node, "directly", False))
        groups = any(len(getattr(node, field)) > 1 for field in "ab")
        somewhere = bool(getattr(node, "somewhere", False)) and not directly
        update = {"directly": directly and not groups, "immediate": immediate and not groups,
                  "somewhere": somewhere and not groups}  # fmt: skip
    return node.model_copy(update=update)


def _plain(part: g.Goal, parts: list[g.Goal]) -> bool:
    """Whether a part can be said beside the others.

    A relation to a block that lies on another is said of the lowest one, a filled rectangle with its sides; of two
    structures of the same blocks one is enough; what lies on a block is named; of a row it is said who is whose
    neighbour.
    """
    for atom in atoms(part):
        if isinstance(atom, s.Figure) and atom.shape in ("square", "rectangle") and atom.filled:
            return False
        if isinstance(atom, g.Clear) and part != atom:
            return False
        operands = {n for field in "abc" for n in members(getattr(atom, field, ()))}
        if atom.kind in LEVEL and operands & _raised(parts):
            return False
        blocks = set(getattr(atom, "blocks", ()))
        rows = [set(x.blocks) for other in parts for x in atoms(other) if isinstance(x, s.Row)]
        if atom.kind in ("beside", "adjacent") and part != atom and any(operands <= row for row in rows):
            return False
        if any(blocks and blocks == set(getattr(other, "blocks", ())) for other in parts if other is not part):
            return False
    return True


def _one_after_another(parts: list[g.Goal]) -> bool:
    """Whether the parts can be stages: what is moved twice has no place of the start any more, and what is on the
    table after it was on a patch is off the patch."""
    said = [{atom.kind for atom in atoms(part)} for part in parts]
    moves = sum(any(isinstance(atom, EARLY) for atom in atoms(part)) for part in parts)
    return moves < 2 and not ("on_table" in set.union(*said) and "on_patch" in set.union(*said))


def _raised(parts: list[g.Goal]) -> set[str]:
    """Blocks that lie on others."""
    said = [atom for part in parts for atom in atoms(part)]
    above = {name for atom in said if isinstance(atom, g.On | g.Above) for name in members(atom.a)}
    return above | {name for atom in said if isinstance(atom, s.Stack) for name in atom.blocks}


def _needed(node: s.Spells, world: World) -> tuple[str, ...]:
    """The cubes that a word takes; letters to spare are not spoken of."""
    found: list[str] = []
    for letter in node.word:
        found.append(next(n for n in node.blocks if world.blocks[n].symbol("top") == letter and n not in found))  # type: ignore[union-attr]
    return tuple(found)


def _pairs(node: s.Towers) -> int:
    """A number of towers that the blocks suffice for."""
    return len(node.blocks) // 2 if len(node.blocks) < 6 else 2


def _line_order(order: Order, blocks: tuple[str, ...], world: World) -> Order:
    """An order of which the beginning is said only where it has one; the compiler finds what is compared by name.

    Blocks that all look alike are in no order.
    """
    if order.by in ("together", "given") and len({world.look[name] for name in blocks}) == 1:
        return Order()
    first = None if order.by in ("any", "together") else order.first
    return order.model_copy(update={"first": first, "match": "look"})


def _unlike(parts: list[g.Goal]) -> Iterator[g.Goal]:
    """Goals that are not all said before."""
    seen: set[str] = set()
    for part in parts:
        if (text := part.model_dump_json()) not in seen:
            seen.add(text)
            yield part


def _count(world: World, state: BlockState, rng: Random) -> g.Goal | None:
    """How many of a class of look-alikes are on the table, if it has several."""
    classes: dict[Any, list[str]] = {}
    for name, look in world.look.items():
        classes.setdefault(look, []).append(name)
    several = [members for members in classes.values() if len(members) > 1]
    if not several:
        return None
    over = tuple(rng.choice(several))
    inner = g.OnTable(a="each")
    true = sum(bool(evaluate(g.OnTable(a=name), state)) for name in over)
    if not 0 < true < len(over):
        return None
    low, high = rng.choice(((true, true), (true, None), (0, true)))
    return g.Count(over=over, at_least=low, at_most=high, goal=inner)


def _start(goal: g.Goal, world: World, rng: Random) -> InitialState:
    """Now and then a stack or a heap of blocks of the goal."""
    blocks = [name for name in names(goal) if name in world.blocks]
    if len(blocks) < 2 or rng.random() > SHARE:
        return InitialState()
    some = tuple(rng.sample(blocks, min(len(blocks), rng.choice((2, 3)))))
    if rng.random() < 0.5:
        return InitialState(heaps=(some,)) if len(some) > 1 else InitialState()
    if any(isinstance(atom, g.On) or atom.kind in LEVEL for atom in atoms(goal)):
        return InitialState(arranged=(g.InRegion(a=some[0], region="left_half"),))
    return InitialState(arranged=(g.On(a=some[0], b=some[1]),))


def _schema(goal: g.Goal, world: World, init: InitialState, rng: Random) -> TaskSchema:
    """The task, with at most one object that it does not speak of."""
    told = {*names(goal), *(n for part in init.arranged for n in names(part)), *(n for h in init.heaps for n in h)}
    extra = [name for name in world.blocks if name not in told]
    kept = {*told, *(extra[:1] if rng.random() < SHARE else ())}
    assets: list[Asset] = []
    for asset in world.assets.values():
        if asset.name in kept:
            assets.append(asset.model_copy(update={"position": None}) if isinstance(asset, GoalPatch) else asset)
    goal = link(goal, World(assets))
    return TaskSchema(name="random", instruction="random", assets=tuple(assets), goal=goal, init=init)
