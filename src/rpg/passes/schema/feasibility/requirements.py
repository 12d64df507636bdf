"""Second step, requirement extraction: what a goal needs of room, distances, symbols, sight and the hand."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from itertools import pairwise
from typing import Literal

from rpg.blocks.constants import WORKSPACE_X, WORKSPACE_Y
from rpg.blocks.figures import ring_width
from rpg.blocks.predicates.common import BORDER, SPANS
from rpg.ir import goal as g
from rpg.ir import relations as r
from rpg.ir import structures as s
from rpg.ir.node import members
from rpg.ir.order import Order
from rpg.ir.schema import MAX_BLOCKS, TaskSchema
from rpg.passes.schema.feasibility.inventory import Inventory
from rpg.passes.schema.resolve.goals.conflicts import required

WIDTH = WORKSPACE_Y[1] - WORKSPACE_Y[0]
DEPTH = WORKSPACE_X[1] - WORKSPACE_X[0]
DIAGONAL = math.hypot(WIDTH, DEPTH)


@dataclass(frozen=True)
class Room:
    """An atom takes `extent_m` along an axis, in metres; so many of its blocks would fit."""

    atom: g.Goal
    axis: Literal["x", "y", "any"]
    extent_m: float
    fits: int

    @property
    def room_m(self) -> float:
        """What there is along the axis."""
        return DEPTH if self.axis == "x" else WIDTH


@dataclass(frozen=True)
class Reach:
    """The centres of two blocks, or one block's places before and after, are to be `low` to `high` metres apart.

    `least`: how far apart the two are side by side, where it is said how far; `room`: how far apart they can be.
    """

    atom: g.Goal
    pair: frozenset[str]
    low: float
    high: float
    least: float = 0.0
    room: float = DIAGONAL


@dataclass(frozen=True)
class Symbols:
    """An atom needs a cube of `among` for each symbol of `text`."""

    atom: s.Spells | s.Equation
    text: str
    among: tuple[str, ...]


@dataclass(frozen=True)
class Ordering:
    """An atom orders `among` by letters or by numbers, which all of them have to show."""

    atom: g.Goal
    order: Order
    among: tuple[str, ...]

    @property
    def wants(self) -> Literal["letter", "digit"]:
        """What each block has to show."""
        return "letter" if self.order.by == "label" else "digit"


@dataclass(frozen=True)
class Sight:
    """One phrase asks for what blocks show upwards; `covered` maps those that something lies on to what lies there.

    `loose`: stacks whose order is open, so that all blocks but one of each are covered, whichever they are.
    """

    atoms: tuple[r.Facing, ...]
    covered: Mapping[str, str]
    loose: tuple[tuple[str, ...], ...]


@dataclass(frozen=True)
class Grip:
    """An atom wants a block lifted that the hand has to reach around."""

    atom: g.Goal
    block: str
    edge_m: float


Requirement = Room | Reach | Symbols | Ordering | Sight | Grip


def requirements(task: TaskSchema, stock: Inventory) -> tuple[Requirement, ...]:
    """What must be so for the task's goal to hold at the end."""
    found: list[Requirement] = []
    must = tuple(required(task.goal))
    for atom in must:
        found += _rooms(atom, stock.edges)
        found += _reaches(atom, stock.edges)
        found += _symbols(atom)
        found += _orderings(atom)
        found += _grips(atom, task, stock)
    return (*found, *_sights(must))


def _rooms(atom: g.Goal, edges: Mapping[str, float]) -> Iterator[Room]:
    widest = max((edges[n] for n in getattr(atom, "blocks", ()) if n in edges), default=0.0)
    match atom:
        case s.Row():
            yield _row(atom, edges)
        case s.Grid():
            yield Room(atom, "y", atom.columns * widest, int(WIDTH / widest))
            yield Room(atom, "x", atom.rows * widest, int(DEPTH / widest))
        case s.Figure(shape="circle", filled=False):
            fits = next(n for n in range(MAX_BLOCKS, 1, -1) if ring_width(n, widest) + 2 * BORDER <= DEPTH)
            yield Room(atom, "x", ring_width(len(atom.blocks), widest) + 2 * BORDER, fits)
        case s.Spells(along="row"):
            yield Room(atom, "y", len(atom.word) * widest, int(WIDTH / widest))


def _row(row: s.Row, edges: Mapping[str, float]) -> Room:
    sizes = [edges[n] for n in row.blocks]
    widest = max(sizes)
    room = DEPTH if row.axis == "x" else WIDTH
    pitch = row.spacing or (widest + row.gap if row.gap else widest)
    extent = (len(sizes) - 1) * pitch + widest if row.spacing or row.gap else sum(sizes)
    axis: Literal["x", "y", "any"] = "x" if row.axis == "x" else "y" if row.axis == "y" else "any"
    return Room(row, axis, extent, 1 + int((room - widest) / pitch + 1e-9))


def _reaches(atom: g.Goal, edges: Mapping[str, float]) -> Iterator[Reach]:
    """The least and greatest distance of centres that a relation of two blocks allows, or a move of one."""
    if isinstance(atom, r.Moved):
        yield Reach(atom, frozenset(members(atom.a)), atom.at_least, math.inf)
    if isinstance(atom, r.Shifted):
        room = SPANS["y" if atom.toward in ("left", "right") else "x"]
        yield Reach(atom, frozenset(members(atom.a)), atom.at_least, math.inf, room=room)
    if isinstance(atom, r.Ranged):
        return
    if isinstance(atom, s.Row) and atom.spacing:
        least = sum(edges[n] for n in atom.blocks) / len(atom.blocks)
        yield Reach(atom, frozenset(atom.blocks), 0.0, atom.spacing, least)
    a, b = getattr(atom, "a", None), getattr(atom, "b", None)
    if not (isinstance(a, tuple) and isinstance(b, tuple) and len(a) == len(b) == 1):
        return
    half = (edges.get(a[0], 0.0) + edges.get(b[0], 0.0)) / 2
    low, high = 0.0, math.inf
    match atom:
        case r.Distance():
            plus = half if atom.measure == "faces" else 0.0
            low = (atom.minimum or 0.0) + plus
            high = math.inf if atom.maximum is None else (atom.maximum + plus) * (math.sqrt(2.0) if plus else 1.0)
            high = high if plus else min(high, _as_told(atom, half))
        case r.Beside() | r.Adjacent():
            high = (half * 2 + atom.gap_edges * 2 * half) * math.sqrt(2.0)
        case r.Near():
            high = atom.distance
        case r.Apart():
            low = atom.distance
        case r.On():
            high = half * 2
        case _:
            return
    told = isinstance(atom, r.Distance) and a[0] in edges and b[0] in edges
    yield Reach(atom, frozenset((a[0], b[0])), low, high, half if told else 0.0)


_EXACT = 0.02
"""So much lies between the least and the most of what is told without a range: 1 cm less or more."""


def _as_told(atom: r.Distance, least: float) -> float:
    """ "3 cm apart", where the tolerance alone would have the blocks touch: no more than was told; else no bound."""
    if atom.minimum is None or atom.maximum is None or atom.maximum - atom.minimum > _EXACT + 1e-9:
        return math.inf
    told = (atom.minimum + atom.maximum) / 2
    return told if told < least - 1e-9 else math.inf


def _symbols(atom: g.Goal) -> Iterator[Symbols]:
    if isinstance(atom, s.Spells):
        yield Symbols(atom, atom.word, atom.blocks)
    elif isinstance(atom, s.Equation) and atom.text is not None:
        yield Symbols(atom, atom.text, atom.blocks)


def _orderings(atom: g.Goal) -> Iterator[Ordering]:
    pattern = getattr(atom, "pattern", None)
    order = pattern.order if pattern is not None and pattern.kind == "reading" else getattr(atom, "order", None)
    if order is not None and order.by in ("label", "number"):
        yield Ordering(atom, order, tuple(getattr(atom, "blocks", ())))


def _grips(atom: g.Goal, task: TaskSchema, stock: Inventory) -> Iterator[Grip]:
    """The blocks that must be lifted: for one on another, the upper; in a stack, all but the foot."""
    if task.init.arranged or task.init.heaps:
        return
    lifted: tuple[str, ...] = ()
    match atom:
        case r.On() if isinstance(atom.a, tuple):
            lifted = atom.a
        case s.Stack():
            order = _upward(atom)
            lifted = order[1:] if order else tuple(sorted(atom.blocks, key=lambda n: (stock.edges[n], n)))[:-1]
    for name in lifted:
        if name in stock.edges:
            yield Grip(atom, name, stock.edges[name])


def _upward(stack: s.Stack) -> tuple[str, ...]:
    """The blocks of a stack from the bottom up, where their order is wholly given; else nothing."""
    order = stack.order
    if order.by != "given" or any(len(rank) != 1 for rank in order.ranks) or order.descending:
        return ()
    named = tuple(rank[0] for rank in order.ranks)
    return named[::-1] if order.first == "top" else named


def _sights(must: tuple[g.Goal, ...]) -> Iterator[Sight]:
    """What phrases ask to be seen from above, and what lies on the blocks they speak of."""
    covered: dict[str, str] = {}
    loose: list[tuple[str, ...]] = []
    for atom in must:
        if isinstance(atom, r.On) and isinstance(atom.a, tuple) and isinstance(atom.b, tuple) and len(atom.b) == 1:
            covered[atom.b[0]] = atom.a[0]
        elif isinstance(atom, s.Stack):
            upward = _upward(atom)
            covered.update(pairwise(upward))
            if not upward:
                loose.append(atom.blocks)
    phrases: dict[tuple[int, int] | None, list[r.Facing]] = {}
    for atom in must:
        if isinstance(atom, r.Facing) and atom.toward == "up":
            phrases.setdefault(atom.span, []).append(atom)
    for asked in phrases.values():
        yield Sight(tuple(asked), covered, tuple(loose))
