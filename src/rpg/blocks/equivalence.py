"""Whether two tasks ask for the same, whatever their blocks are called and wherever their words stand."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping
from itertools import product
from typing import Any

from rpg.blocks.state import World, look_of
from rpg.blocks.symmetry import Canonical, interchangeable, namings
from rpg.ir import goal as g
from rpg.ir.assets import Asset, GoalPatch
from rpg.ir.node import Highest, Lowest, members
from rpg.ir.order import Order
from rpg.ir.relations import Apart, Clear, Closer, Distance, On, Swapped, TookPlace
from rpg.ir.schema import TaskSchema
from rpg.ir.structures import Row, Stack, Towers
from rpg.ir.walk import instances, rename, transform

EACH_FOR_ITSELF = frozenset({"on_patch", "on_table", "in_region", "clear", "stayed", "moved", "shifted", "equidistant"})
"""Atoms that say the same of each of their blocks."""


def equivalent(a: TaskSchema, b: TaskSchema) -> bool:
    """The same objects by look, starting alike, under the same goal, up to a renaming of the objects."""
    names = _counterparts(b, a)
    if names is None or _heaps(a) != _heaps(b):
        return False
    world = World(a.assets)
    canonical = Canonical(world)
    wanted, other = _whole(a), rename(_whole(b), names)
    target = canonical(wanted, {})
    return any(canonical(other, naming) == target for naming in namings(interchangeable(other, world)))


def normal(goal: g.Goal) -> g.Goal:
    """`goal` without nesting that says nothing, atoms about several blocks split where they speak of each alone."""
    return transform(goal, _normal)


def _whole(schema: TaskSchema) -> g.Goal:
    """Start and goal as one expression, so that look-alikes keep their identity over both."""
    start = g.Stage(goal=normal(g.All(goals=schema.init.arranged)))
    blocks = tuple(block.name for block in schema.blocks)
    colors = {block.name: block.color for block in schema.blocks}
    goal = transform(schema.goal, lambda node: _by_color(_covered(node, blocks), colors))
    return g.Sequence(stages=(start, g.Stage(goal=normal(goal))))


def _covered(node: g.Goal, blocks: tuple[str, ...]) -> g.Goal:
    """A block that is not clear has one of the others on it."""
    if not isinstance(node, g.Not) or not isinstance(node.goal, Clear) or not isinstance(node.goal.a, tuple):
        return node
    a = node.goal.a
    return g.Any(goals=tuple(On(a=(n,), b=(under,)) for under in a for n in blocks if n != under))


def _by_color(node: g.Goal, colors: Mapping[str, str]) -> g.Goal:
    """Towers, each of a colour of its own, are a stack of just the blocks of each colour."""
    if not isinstance(node, Towers) or node.each != "color" or not node.separate or node.matching:
        return node
    lots: dict[str, list[str]] = {}
    for name in node.blocks:
        lots.setdefault(colors[name], []).append(name)
    many = [len(lot) for lot in lots.values()]
    agreed = node.count in (None, len(lots)) and (node.heights is None or sorted(node.heights) == sorted(many))
    if not agreed or min(many) < _LOWEST_TOWER or (node.equal and len(set(many)) > 1):
        return node
    return _flat(g.All(goals=tuple(Stack(blocks=tuple(lot), exact=True) for lot in lots.values())))


_LOWEST_TOWER = 2
"""A lone block is no tower."""


def _normal(node: g.Goal) -> g.Goal:
    match node:
        case g.All() | g.Any():
            return _flat(node)
        case g.Not():
            return _denied(node.goal)
        case g.Count():
            return _counted(node)
        case Stack(order=Order(first=None, by="given" | "label" | "number" | "size")):
            return node.model_copy(update={"order": node.order.model_copy(update={"first": "bottom"})})
        case Row(readable=False) | Stack(readable=False) if node.excused:
            return _normal(node.model_copy(update={"excused": ()}))  # of what is to be read
        case Row(order=Order(by="given", first="right" | "back")) | Stack(order=Order(by="given", first="top")):
            begin = {"right": "left", "back": "front"}.get(node.order.first or "", "bottom")
            turned = node.order.model_copy(update={"ranks": node.order.ranks[::-1], "first": begin})
            return node.model_copy(update={"order": turned})
        case Row(order=Order(first=None, descending=True)) | Stack(order=Order(first=None, by="rainbow")):
            return node.model_copy(update={"order": node.order.model_copy(update={"descending": False})})
        case Apart():
            return _pairwise_apart(node)
        case Swapped():
            return g.All(goals=(_took(node.a, node.b, node), _took(node.b, node.a, node)))
        case Closer():
            return _one_by_one(node)
        case Distance(minimum=float(), maximum=float()):  # at least, and at most
            return g.All(goals=(node.model_copy(update={"maximum": None}), node.model_copy(update={"minimum": None})))
    if node.kind in EACH_FOR_ITSELF:
        operand: Any = node.a  # type: ignore[union-attr]
        if not isinstance(operand, Lowest | Highest) and len(operand) > 1:
            return g.All(goals=tuple(node.model_copy(update={"a": (name,)}) for name in operand))
    return node


def _took(a: tuple[str, ...], b: tuple[str, ...], swapped: Swapped) -> g.Goal:
    """Half of an exchange: these are where the others were."""
    return TookPlace(a=a, b=b, tolerance=swapped.tolerance, span=swapped.span)


def _pairwise_apart(node: Apart) -> g.Goal:
    """The nearest members of two groups are apart when every two are."""
    if isinstance(node.a, Lowest | Highest) or isinstance(node.b, Lowest | Highest):
        return node
    pairs = (node.model_copy(update={"a": (a,), "b": (b,)}) for a in node.a for b in node.b)
    return _flat(g.All(goals=tuple(pairs)))


def _one_by_one(node: Closer) -> g.Goal:
    """Each of some is closer to each of some others than to any of a third lot when each three of them are so."""
    operands = (node.a, node.b, node.c)
    if any(isinstance(operand, Lowest | Highest) for operand in operands):
        return node
    triples = product(*(members(operand) for operand in operands))
    return _flat(g.All(goals=tuple(node.model_copy(update={"a": (a,), "b": (b,), "c": (c,)}) for a, b, c in triples)))


def _denied(goal: g.Goal) -> g.Goal:
    """The opposite of a goal in normal form, with "not" before atoms alone."""
    match goal:
        case g.Not():
            return goal.goal
        case g.All():
            return _flat(g.Any(goals=tuple(_denied(part) for part in goal.goals)))
        case g.Any():
            return _flat(g.All(goals=tuple(_denied(part) for part in goal.goals)))
    return g.Not(goal=goal)


def _counted(count: g.Count) -> g.Goal:
    """Counts that say "all", "any" or "none" as what they say."""
    parts = instances(count)
    if count.at_least == len(parts):
        return transform(g.All(goals=parts), _normal)
    if count.at_least == 1 and (count.at_most is None or count.at_most >= len(parts)):
        return transform(g.Any(goals=parts), _normal)
    if count.at_least == 0 and count.at_most == 0:
        return transform(g.All(goals=tuple(g.Not(goal=part) for part in parts)), _normal)
    return count


def _flat(node: g.All | g.Any) -> g.Goal:
    parts: list[g.Goal] = []
    for part in node.goals:
        parts += part.goals if isinstance(part, type(node)) else (part,)
    unique = list({part.model_copy(update={"span": None}).model_dump_json(): part for part in parts}.values())
    return unique[0] if len(unique) == 1 else node.model_copy(update={"goals": tuple(unique)})


def _counterparts(source: TaskSchema, target: TaskSchema) -> dict[str, str] | None:
    """Names of `source` to names of `target` with equal looks; None where the looks differ."""
    free: dict[tuple[str, ...], list[str]] = {}
    for asset in target.assets:
        free.setdefault(_look(asset), []).append(asset.name)
    found: dict[str, str] = {}
    for asset in source.assets:
        names = free.get(_look(asset))
        if not names:
            return None
        found[asset.name] = names.pop(0)
    return found if len(found) == len(target.assets) else None


def _look(asset: Asset) -> tuple[str, ...]:
    if isinstance(asset, GoalPatch):
        long = max(asset.size) >= 2 * min(asset.size)
        return ("patch", asset.color, asset.shape, str(long))
    return look_of(asset)


def _heaps(schema: TaskSchema) -> Counter[tuple[tuple[str, ...], ...]]:
    looks = {asset.name: _look(asset) for asset in schema.assets}
    return Counter(tuple(sorted(looks[name] for name in heap)) for heap in schema.init.heaps)
