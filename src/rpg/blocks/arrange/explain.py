"""Why a goal cannot be arranged: the smallest set of its conditions that clash, as a diagnostic."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import islice
from random import Random

from rpg.blocks.arrange.alternatives import alternatives
from rpg.blocks.arrange.bounds import Contradiction
from rpg.blocks.arrange.fit import most_that_fit, oversize
from rpg.blocks.arrange.solve import Solver
from rpg.blocks.constants import WORKSPACE_X, WORKSPACE_Y
from rpg.blocks.english import clause
from rpg.blocks.nouns import bare, number
from rpg.blocks.predicates import PREDICATES
from rpg.blocks.state import BlockState, World
from rpg.core.diagnostics import Diagnostic, Label, Refusal
from rpg.ir import goal as g
from rpg.ir.structures import Row
from rpg.ir.walk import atoms, children

MOST_CHECKS = 40
"""Subsets of the conditions that are tried."""
SMALL = 1500
"""Candidate places judged for each subset of the conditions."""
ELBOW = 0.01
"""Room left between blocks that stand side by side, in metres."""
DENSEST = 0.7
"""The share of the table that blocks put anywhere on it can take."""
AXES = ("from front to back", "from left to right")


class Impossible(Refusal):
    """No arrangement satisfies the goal; its diagnostics name the smallest set of conditions that clash."""


def explain(goal: g.Goal, world: World, start: BlockState | None) -> tuple[Diagnostic, ...]:
    """What clashes in a goal for which no arrangement was found."""
    parts = _clashing(list(conditions(goal)), world, start)
    return (_diagnostic(parts, world, start),)


def conditions(goal: g.Goal) -> Iterator[g.Goal]:
    """The goals that must all hold."""
    match goal:
        case g.All():
            for part in goal.goals:
                yield from conditions(part)
        case g.Sequence():
            for stage in goal.stages:
                if not stage.undone:
                    yield from conditions(stage.goal)
        case g.Always():
            yield from conditions(goal.goal)
        case _:
            yield goal


def _clashing(parts: list[g.Goal], world: World, start: BlockState | None) -> list[g.Goal]:
    """A subset that cannot be arranged, though it can without any one of its conditions: halves are dropped first.

    Where there are too many conditions to try them all, some that do not matter may be left in it.
    """
    kept, checks = list(parts), MOST_CHECKS
    size = max(len(parts) // 2, 1)
    while True:
        at = 0
        while at < len(kept) and checks > 0:
            rest = kept[:at] + kept[at + size :]
            checks -= 1
            if rest and _solver(rest, world, start).solve(Random(0)) is None:
                kept = rest
            else:
                at += size
        if size == 1 or checks <= 0:
            return kept
        size = max(size // 2, 1)


def _solver(parts: list[g.Goal], world: World, start: BlockState | None) -> Solver:
    return Solver(g.All(goals=tuple(parts)), world, start, SMALL)


def _diagnostic(parts: list[g.Goal], world: World, start: BlockState | None) -> Diagnostic:
    solver = _solver(parts, world, start)
    solver.solve(Random(0))
    reason = next((r for r in solver.reasons if r.needed is not None), None) or _oversize(parts, world)
    spans = [span for span in map(span_of, parts) if span is not None]
    texts = [clause(part, world) for part in parts]
    labels = tuple(Label(span=s, text=t) for part, t in zip(parts, texts, strict=True) if (s := span_of(part)))[1:]
    cycle = support_cycle(parts, world)
    span = spans[0] if spans else None
    if cycle:
        return Diagnostic(
            code="support-cycle",
            message=f"{_ring_in_words(cycle, world)}: nothing in this ring reaches the table",
            span=span,
            labels=labels,
            hint="let one of these blocks stand on the table",
            facts={"cycle": cycle},
            origin="arrange",
        )
    if reason is not None:
        return _does_not_fit(reason, texts, span, labels, world)
    if len(parts) < 2 and (crowd := _crowd(world)) is not None:
        return crowd
    return Diagnostic(
        code="goal-contradiction",
        message=_contradiction(texts),
        span=span,
        labels=labels,
        hint="drop or change one of these conditions" if len(parts) > 1 else "ask for something else of these blocks",
        facts={"conditions": texts},
        origin="arrange",
    )


def _crowd(world: World) -> Diagnostic | None:
    """Blocks that leave no room for each other on the table, whatever is asked of them."""
    edges = [block.size for block in world.blocks.values()]
    deep, wide = (high - low + max(edges) for low, high in (WORKSPACE_X, WORKSPACE_Y))
    needed, room = sum((edge + ELBOW) ** 2 for edge in edges), deep * wide
    if needed < DENSEST * room:
        return None
    taken, free = round(needed * 1e4), round(room * 1e4)
    return Diagnostic(
        code="start-no-room",
        message=f"{number(len(edges))} blocks of this size take {taken} cm² of the table, and it has {free}",
        hint=f"use at most {int(len(edges) * DENSEST * room / needed)} such blocks, or smaller ones",
        facts={"blocks": len(edges), "needed_cm2": taken, "available_cm2": free},
        origin="arrange",
    )


def _oversize(parts: list[g.Goal], world: World) -> Contradiction | None:
    """The first structure that is too large for the workspace."""
    for part in parts:
        for atom in atoms(part):
            reason = oversize(atom, world)
            if reason is not None:
                return reason
    return None


def _contradiction(texts: list[str]) -> str:
    if len(texts) == 1:
        return f"there is no way to arrange the blocks so that {texts[0]}"
    return f"{', and '.join(texts)}: these cannot hold together"


def _what_fits(reason: Contradiction, world: World) -> str:
    """How many blocks of a row would fit; for other structures, what to change."""
    rows = [atom for atom in reason.atoms if isinstance(atom, Row)]
    count = most_that_fit(rows[0], world) if len(rows) == len(reason.atoms) == 1 else 0
    if count < 2:
        return "use fewer or smaller blocks, or closer spacing"
    return f"a row of {number(count)} such blocks fits"


def _does_not_fit(
    reason: Contradiction, texts: list[str], span: tuple[int, int] | None, labels: tuple[Label, ...], world: World
) -> Diagnostic:
    needed, available = round(reason.needed or 0.0, 3), round(reason.available, 3)
    what = f"this takes {needed * 100:g} cm {AXES[reason.axis]}, and the workspace has {available * 100:g} cm"
    return Diagnostic(
        code="does-not-fit",
        message=f"{what}: {'; '.join(texts)}" if texts else what,
        span=span,
        labels=labels,
        hint=_what_fits(reason, world),
        facts={"needed_m": needed, "available_m": available, "axis": "xy"[reason.axis]},
        origin="arrange",
    )


def support_cycle(parts: list[g.Goal], world: World) -> list[str]:
    """Blocks each of which must rest on the next, the last on the first; empty where there is no such ring."""
    goal = g.All(goals=tuple(parts))
    for literals in islice(alternatives(goal, world), 1):
        edges: dict[str, list[str]] = {}
        for atom, holds, _ in literals:
            if holds:
                for upper, lower in PREDICATES[atom.kind].supports(atom, world):
                    edges.setdefault(upper, []).append(lower)
        for block in edges:
            ring = _ring(block, edges)
            if ring:
                return ring
    return []


def _ring_in_words(cycle: list[str], world: World) -> str:
    first, *rest = (f"the {bare(name, world)}" if name in world.assets else f"the {name}" for name in cycle)
    return f"{first} would rest on {', that on '.join(rest)}"


def _ring(first: str, edges: dict[str, list[str]]) -> list[str]:
    paths = [[first]]
    seen = set()
    while paths:
        path = paths.pop()
        for below in edges.get(path[-1], []):
            if below == first:
                return [*path, first]
            if below not in seen:
                seen.add(below)
                paths.append([*path, below])
    return []


def span_of(goal: g.Goal) -> tuple[int, int] | None:
    """The place of a goal in the instruction: its own, or that of what is in it."""
    if goal.span is not None:
        return goal.span
    inner = [span for span in map(span_of, children(goal)) if span is not None]
    return (min(s for s, _ in inner), max(e for _, e in inner)) if inner else None
