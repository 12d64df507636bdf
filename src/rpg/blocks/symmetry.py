"""Blocks that look alike are interchangeable: which of them a goal tells apart, and the renamings that make up for it.

A goal holds when it holds under some renaming of look-alikes. Renamings that the goal cannot tell apart are left out:
"two red blocks on the patch" has none, "a red block on the blue one, the other red one beside it" has two.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from itertools import combinations
from typing import Any

from pydantic import BaseModel

from rpg.blocks.state import BlockState, World
from rpg.core.diagnostics import Diagnostic, Refusal
from rpg.ir import goal as g
from rpg.ir.node import Highest, Lowest
from rpg.ir.order import Order, Pattern
from rpg.ir.relations import Ranged
from rpg.ir.walk import atoms, names, transform

Cells = tuple[tuple[tuple[str, ...], ...], ...]
"""Per class of look-alikes that the goal tells apart, its cells; the goal uses the members of one cell alike."""

MAX_NAMINGS = 5000
SYMMETRIC = frozenset({"beside", "adjacent", "touching", "near", "apart", "distance", "approached", "receded"})
"""Relations whose `a` and `b` may change places."""


def interchangeable(goal: g.Goal, world: World, *, jointly: bool = True) -> Cells:
    """The cells of every class of look-alikes that `goal` tells apart; empty when it is symmetric already.

    `jointly`: where "a blue block is on each red one" the reds need not change places, as it comes to the same when the
    blues do. Two names are in one cell, too, where an exchange of names in later classes makes up for theirs: these
    commute, so that namings that deal only the later ones find all that the goal can say.
    """
    classes = _classes(world)
    mentioned = set(names(goal)) if classes else set()
    classes = [members for members in classes if not mentioned.isdisjoint(members)]
    if not classes:
        return ()
    canonical = Canonical(world)
    original = canonical(goal, {})
    partners = _Partners(goal, world) if jointly and len(classes) > 1 else None
    found = []
    for number, members in enumerate(classes):
        later = {name for others in classes[number + 1 :] for name in others}
        cells: list[list[str]] = []
        for name in members:
            for cell in cells:
                swap = {cell[0]: name, name: cell[0]}
                along = partners.of(swap, later) if partners is not None and later else None
                if canonical(goal, swap) == original or (along and canonical(goal, along) == original):
                    cell.append(name)
                    break
            else:
                cells.append([name])
        if len(cells) > 1:
            found.append(tuple(tuple(cell) for cell in cells))
    return tuple(found)


class _Partners:
    """Guesses which further names have to change places along with two, from the atoms that speak of each of them."""

    def __init__(self, goal: g.Goal, world: World) -> None:
        self._look = world.look
        self._about: dict[str, list[tuple[str, tuple[str, ...]]]] = {}
        for atom in atoms(goal):
            mentioned = names(atom)
            for name in mentioned:
                self._about.setdefault(name, []).append((atom.kind, mentioned))

    def of(self, swap: dict[str, str], free: set[str]) -> dict[str, str] | None:
        """`swap` with exchanges of names among those `free`; None where there is nothing to exchange."""
        along, waiting = dict(swap), [next(iter(swap.items()))]
        while waiting:
            one, other = waiting.pop()
            for kind, mentioned in self._about.get(one, ()):
                if other in mentioned:
                    continue
                for another, counterparts in self._about.get(other, ()):
                    if kind == another and len(mentioned) == len(counterparts) and one not in counterparts:
                        pairs = [(a, b) for a, b in zip(mentioned, counterparts, strict=True) if along.get(a, a) != b]
                        if all(self._may_change(a, b, along, free) for a, b in pairs):
                            along |= dict(pairs) | {b: a for a, b in pairs}
                            waiting += pairs
                            break
        return along if len(along) > len(swap) else None

    def _may_change(self, a: str, b: str, along: dict[str, str], free: set[str]) -> bool:
        unbound = a not in along and b not in along and a in free and b in free
        return unbound and self._look.get(a) == self._look.get(b)


def namings(cells: Cells) -> tuple[dict[str, str], ...]:
    """Every distinct assignment of look-alikes to cells, as a map from name in the goal to block; identity first."""
    total = math.prod(assignments(group) for group in cells)
    if total > MAX_NAMINGS:
        raise Refusal([_too_many(cells, total)])
    maps: list[dict[str, str]] = [{}]
    for group in cells:
        members = tuple(name for cell in group for name in cell)
        maps = [{**before, **new} for before in maps for new in _deal(group, members)]
    return tuple({a: b for a, b in naming.items() if a != b} for naming in maps)


def rename_state(state: BlockState, naming: dict[str, str]) -> BlockState:
    """`state` as a goal sees it whose names stand for other blocks of the same look."""
    if not naming:
        return state
    back = {block: name for name, block in naming.items()}
    return BlockState(
        world=state.world,
        position={name: state.position[naming.get(name, name)] for name in state.position},
        orientation={name: state.orientation[naming.get(name, name)] for name in state.orientation},
        moving=frozenset(back.get(name, name) for name in state.moving),
        held=frozenset(back.get(name, name) for name in state.held),
        start=None if state.start is None else rename_state(state.start, naming),
    )


def link(goal: g.Goal, world: World) -> g.Goal:
    """`goal` with given orders compared by name where another atom tells apart blocks that look alike in them."""
    parts = list(atoms(goal))

    def change(node: g.Goal) -> g.Goal:
        pattern = getattr(node, "pattern", None)
        order = pattern.order if isinstance(pattern, Pattern) else getattr(node, "order", None)
        if not isinstance(order, Order) or order.by != "given" or order.match != "look":
            return node
        doubled = _doubled(order, world)
        others = g.All(goals=tuple(part for part in parts if part is not node)) if doubled else None
        cells = interchangeable(others, world, jointly=False) if others is not None else ()
        if not any(doubled.intersection(cell) for group in cells for cell in group):
            return node
        linked = order.model_copy(update={"match": "single" if _of_singles(order, cells) else "name"})
        if isinstance(pattern, Pattern):
            return node.model_copy(update={"pattern": pattern.model_copy(update={"order": linked})})
        return node.model_copy(update={"order": linked})

    return transform(goal, change)


def _of_singles(order: Order, cells: Cells) -> bool:
    """Does it tell all apart that is to be told apart if only the ranks of one block are compared by name?"""
    several = {name for rank in order.ranks if len(rank) > 1 for name in rank}
    if not several:
        return False
    return all(sum(not several.isdisjoint(cell) for cell in group) < 2 for group in cells)


def _doubled(order: Order, world: World) -> set[str]:
    """Blocks of an order with a look-alike at another rank."""
    ranked = [(name, rank) for rank, entry in enumerate(order.ranks) for name in entry]
    return {a for a, i in ranked for b, j in ranked if i != j and world.look[a] == world.look[b]}


def _classes(world: World) -> list[list[str]]:
    """Blocks that look alike, in classes of at least two."""
    classes: dict[tuple[str, ...], list[str]] = {}
    for name, look in world.look.items():
        classes.setdefault(look, []).append(name)
    return [members for members in classes.values() if len(members) > 1]


def assignments(group: tuple[tuple[str, ...], ...]) -> int:
    """In how many ways the members of a class of look-alikes can be dealt to its cells."""
    sizes = [len(cell) for cell in group]
    return math.factorial(sum(sizes)) // math.prod(math.factorial(size) for size in sizes)


def _deal(group: tuple[tuple[str, ...], ...], members: tuple[str, ...]) -> Iterator[dict[str, str]]:
    """Deal `members` to the cells in every distinct way; the way in which they stand comes first."""
    if not group:
        yield {}
        return
    for chosen in combinations(members, len(group[0])):
        rest = tuple(name for name in members if name not in chosen)
        for others in _deal(group[1:], rest):
            yield {**dict(zip(group[0], chosen, strict=True)), **others}


def _too_many(cells: Cells, total: int) -> Diagnostic:
    sizes = [sum(len(cell) for cell in group) for group in cells]
    return Diagnostic(
        code="too-many-namings",
        message=f"the goal gives {max(sizes)} blocks that look alike different duties, in {total:,} ways",
        hint="give some of these blocks colours or labels of their own",
        facts={"namings": total, "namings_max": MAX_NAMINGS},
        origin="symmetry",
    )


def _mutual(atom: g.Atom) -> bool:
    """Whether a distance between every two of the same blocks has changed, or that of just two."""
    return isinstance(atom, Ranged) and (atom.a == atom.b or len({*names(atom)}) == 2)


class Canonical:
    """A goal as nested tuples that are equal exactly when two goals say the same of the same names."""

    def __init__(self, world: World) -> None:
        self.world = world

    def __call__(self, goal: g.Goal, mapping: dict[str, str]) -> Any:
        match goal:
            case g.All() | g.Any():
                parts = {repr(part): part for part in (self(part, mapping) for part in goal.goals)}
                if len(parts) == 1:
                    return next(iter(parts.values()))
                return goal.kind, [parts[text] for text in sorted(parts)]
            case g.Not() | g.Always():
                return goal.kind, self(goal.goal, mapping)
            case g.Count():
                over = sorted(mapping.get(n, n) for n in goal.over)
                return goal.kind, over, goal.at_least, goal.at_most, self(goal.goal, mapping)
            case g.Sequence():
                return goal.kind, [(self(stage.goal, mapping), stage.undone) for stage in goal.stages]
            case _:
                return self._atom(goal, mapping)

    def _atom(self, atom: g.Atom, mapping: dict[str, str]) -> Any:
        fields = {field: self._value(getattr(atom, field), mapping) for field in type(atom).model_fields}
        del fields["span"]
        if _mutual(atom):
            fields["a"], fields["b"] = sorted({mapping.get(n, n) for n in names(atom)}), ()
        elif atom.kind in SYMMETRIC:
            fields["a"], fields["b"] = sorted((fields["a"], fields["b"]), key=repr)
        elif atom.kind == "row" and atom.order.first is None and atom.order.by == "given":
            rest, ranks = fields["order"]
            fields["order"] = rest, min(ranks, ranks[::-1])
        elif atom.kind == "between":
            fields["b"], fields["c"] = sorted((fields["b"], fields["c"]), key=repr)
        elif atom.kind == "equidistant" and isinstance(atom.b, tuple) and isinstance(atom.c, tuple):
            fields["b"], fields["c"] = sorted(mapping.get(n, n) for n in (*atom.b, *atom.c)), ()
        elif atom.kind == "equidistant":
            fields["b"], fields["c"] = sorted((fields["b"], fields["c"]), key=repr)
        elif atom.kind == "group_by":
            fields["groups"] = sorted(fields["groups"])
        elif atom.kind == "took_place":
            fields["a"] = sorted((mapping.get(a, a), mapping.get(b, b)) for a, b in zip(atom.a, atom.b, strict=False))
            fields["b"] = ()
        elif atom.kind == "swapped":
            pairs = zip(atom.a, atom.b, strict=False)
            fields["a"] = sorted(sorted(mapping.get(n, n) for n in pair) for pair in pairs)
            fields["b"] = (len(atom.a), len(atom.b))
        return sorted(fields.items())

    def _value(self, value: Any, mapping: dict[str, str]) -> Any:
        match value:
            case str():
                return mapping.get(value, value)
            case Lowest():
                return "lowest", self._value(value.lowest, mapping)
            case Highest():
                return "highest", self._value(value.highest, mapping)
            case Order():
                return self._order(value, mapping)
            case BaseModel():
                return [(field, self._value(getattr(value, field), mapping)) for field in type(value).model_fields]
            case tuple() if value and all(isinstance(item, str) for item in value):
                return sorted(mapping.get(item, item) for item in value)
            case tuple():
                return [self._value(item, mapping) for item in value]
            case _:
                return value

    def _order(self, order: Order, mapping: dict[str, str]) -> Any:
        """Ranks compared by look say the same of every block of that look."""
        rest = order.by, order.attribute, order.descending, order.first, order.match
        if order.match == "name":
            return rest, [self._value(entry, mapping) for entry in order.ranks]
        look = self.world.look
        ranks = []
        for entry in order.ranks:
            by_name = order.match == "single" and len(entry) == 1
            ranks.append([(mapping.get(n, n),) if by_name else look.get(n, (n,)) for n in entry])
        return rest, [sorted(entry) for entry in ranks]
