"""Third step, the check: which requirements the assets, the table or each other do not meet, with the numbers."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass
from itertools import combinations

from rpg.blocks.constants import HAND
from rpg.core.diagnostics import Diagnostic
from rpg.ir.relations import Above, On, Shifted
from rpg.ir.schema import TaskSchema
from rpg.ir.structures import Grid, Stack, Towers
from rpg.ir.walk import names
from rpg.passes.schema.feasibility.inventory import Excess, Inventory
from rpg.passes.schema.feasibility.requirements import (
    Grip,
    Ordering,
    Reach,
    Requirement,
    Room,
    Sight,
    Symbols,
)
from rpg.passes.schema.resolve.goals.conflicts import required


@dataclass(frozen=True)
class Conflict:
    """What cannot be: a limit that is passed, or a requirement that is not met."""

    need: Requirement | Excess
    diagnostic: Diagnostic


def conflicts(task: TaskSchema, stock: Inventory, needs: tuple[Requirement, ...]) -> tuple[Conflict, ...]:
    """Everything independent that makes a task impossible."""
    found = [Conflict(excess, _too_many(excess, task, needs)) for excess in stock.excesses]
    if found:
        return tuple(found)
    for need in needs:
        found += [Conflict(need, diagnostic) for diagnostic in _wrong(need, stock)]
    reaches = [need for need in needs if isinstance(need, Reach)]
    piles = [{*names(x)} for x in required(task.goal) if isinstance(x, On | Above | Stack | Towers)]
    near = [need for need in reaches if need.high < need.least - 1e-9 and not any(need.pair <= x for x in piles)]
    found += [Conflict(need, _too_close(need)) for need in near]
    return (*found, *(Conflict(b, _opposed(b)) for a, b in combinations(reaches, 2) if _apart(a, b)))


def _wrong(need: Requirement, stock: Inventory) -> Iterator[Diagnostic]:
    match need:
        case Room() if need.extent_m > need.room_m + 1e-9:
            yield _too_long(need)
        case Reach() if need.low > need.room:
            yield _too_far(need)
        case Symbols():
            yield from _missing(need, stock)
        case Ordering() if any(stock.sorts(name) != {need.wants} for name in need.among):
            yield _misfit(need)
        case Sight():
            yield from _hidden(need)
        case Grip() if need.edge_m > HAND + 1e-9:
            yield _too_wide(need)


def _too_many(excess: Excess, task: TaskSchema, needs: tuple[Requirement, ...]) -> Diagnostic:
    count, limit = len(excess.names), excess.limit
    atom = next((atom for atom in required(task.goal) if set(excess.names) & set(names(atom))), None)
    rooms = (need for need in needs if isinstance(need, Room) and need.atom is atom)
    fits = min([limit, *(room.fits for room in rooms if _counts(room))])
    plural = "blocks" if excess.what == "block" else f"{excess.what} cubes"
    return Diagnostic(
        code="too-many-blocks" if excess.what == "block" else "too-many-labels",
        message=f"this takes {count} {plural}; a task has at most {limit}",
        span=getattr(atom, "span", None),
        hint=f"use at most {fits} {plural}",
        facts={"blocks" if excess.what == "block" else "cubes": count, "limit": limit, "fits": fits},
        origin="schema",
    )


def _counts(need: Room) -> bool:
    """Do so many blocks fit in all, and not only in each row?"""
    return not isinstance(need.atom, Grid)


def _too_long(need: Room) -> Diagnostic:
    count, extent, room = len(getattr(need.atom, "blocks", ())), need.extent_m, need.room_m
    return Diagnostic(
        code="does-not-fit",
        message=f"{count} blocks take {extent * 100:.0f} cm here, but there are {room * 100:.0f} cm of room",
        span=need.atom.span,
        hint=f"at most {need.fits} fit",
        facts={"extent_m": round(extent, 4), "room_m": round(room, 4), "blocks": count, "fits": need.fits},
        origin="schema",
    )


def _too_far(need: Reach) -> Diagnostic:
    limit = "than a block can go that way" if isinstance(need.atom, Shifted) else "than the table is wide"
    return Diagnostic(
        code="does-not-fit",
        message=f"{need.low * 100:.0f} cm is farther {limit}",
        span=need.atom.span,
        hint=f"at most {need.room * 100:.0f} cm fit",
        facts={"distance_m": need.low, "room_m": round(need.room, 4)},
        origin="schema",
    )


def _too_close(need: Reach) -> Diagnostic:
    return Diagnostic(
        code="does-not-fit",
        message=f"the centres of blocks side by side are at least {need.least * 100:g} cm apart",
        span=need.atom.span,
        hint="say 'a gap of ...' of what is left between them",
        facts={"distance_m": need.high, "least_m": need.least},
        origin="schema",
    )


def _apart(a: Reach, b: Reach) -> bool:
    """Two distances of the same two blocks that exclude each other."""
    return a.pair == b.pair and (a.low > b.high + 1e-9 or b.low > a.high + 1e-9)


def _opposed(need: Reach) -> Diagnostic:
    return Diagnostic(
        code="contradiction",
        message="these two distances contradict each other",
        span=need.atom.span,
        hint="leave one of them out",
        origin="schema",
    )


def _missing(need: Symbols, stock: Inventory) -> Iterator[Diagnostic]:
    """A symbol for which there is no cube left, each cube showing the same on all its faces."""
    there = Counter(next(iter(shown)) for name in need.among if len(shown := stock.shows.get(name, frozenset())) == 1)
    several = sum(1 for name in need.among if len(stock.shows.get(name, ())) > 1)
    lacking = Counter(need.text) - there
    if lacking.total() > several:
        symbol = min(lacking, key=need.text.index)
        yield Diagnostic(
            code="missing-symbol",
            message=f"{need.text} needs a further {symbol} than the blocks named show",
            span=need.atom.span,
            hint=f"add a block {symbol}",
            facts={"symbol": symbol, "lacking": "".join(sorted(lacking.elements()))},
            origin="schema",
        )


def _misfit(need: Ordering) -> Diagnostic:
    return Diagnostic(
        code="order-misfit",
        message=f"this order is for {'letters' if need.wants == 'letter' else 'numbers'}, but some blocks show none",
        span=need.atom.span,
        hint="use blocks that show them",
        origin="schema",
    )


def _hidden(need: Sight) -> Iterator[Diagnostic]:
    """Faces that something lies on: they cannot be seen, so nothing can be asked of what they show."""
    asked = [atom.block for atom in need.atoms]
    covered = [name for name in asked if name in need.covered]
    if not covered and not any(len(set(stack) & set(asked)) > 1 for stack in need.loose):
        return
    first = covered[0] if covered else asked[0]
    yield Diagnostic(
        code="covered-face",
        message="a face that is to be seen from above has a block on it",
        span=need.atoms[0].span,
        hint="ask it of the block on top alone",
        facts={"block": first, **({"under": need.covered[first]} if covered else {})},
        origin="schema",
    )


def _too_wide(need: Grip) -> Diagnostic:
    return Diagnostic(
        code="too-wide",
        message=f"a block of {need.edge_m * 100:g} cm is wider than the hand opens, so it cannot be lifted",
        span=need.atom.span,
        hint=f"blocks that are lifted have edges of at most {HAND * 100:g} cm",
        facts={"edge_m": need.edge_m, "opening_m": HAND, "block": need.block},
        origin="schema",
    )
