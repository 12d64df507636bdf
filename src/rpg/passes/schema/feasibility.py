"""Feasibility of a task before anything runs: what is required, what cannot be, what would mend it.

Only what follows from numbers and names is decided here. How many blocks and symbols a task may have is checked where
its assets are counted, in `resolve.finish`; whether blocks can be arranged so is the arrangement solver's.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from itertools import combinations
from typing import Literal

from rpg.blocks.constants import WORKSPACE_X, WORKSPACE_Y
from rpg.blocks.figures import ring_width
from rpg.blocks.predicates.common import BORDER
from rpg.core.diagnostics import Diagnostic
from rpg.ir import goal as g
from rpg.ir import relations as r
from rpg.ir import structures as s
from rpg.ir.node import members
from rpg.ir.schema import MAX_BLOCKS, MAX_DIGITS, MAX_LETTERS, TaskSchema
from rpg.passes.schema.resolve.conflicts import required

RepairKind = Literal["REDUCE_LABELS_PRESERVE_GEOMETRY", "SWITCH_ORDERING_PATTERN", "SWITCH_TO_SPATIAL_ONLY"]
WIDTH = WORKSPACE_Y[1] - WORKSPACE_Y[0]
DEPTH = WORKSPACE_X[1] - WORKSPACE_X[0]
DIAGONAL = math.hypot(WIDTH, DEPTH)


@dataclass(frozen=True)
class Repair:
    """A change that would make a task feasible, and what it keeps."""

    kind: RepairKind
    text: str


@dataclass(frozen=True)
class Requirement:
    """Requirement extraction: the room that one atom takes along an axis, in metres."""

    atom: g.Goal
    axis: Literal["x", "y", "any"]
    extent_m: float
    fits: int


def requirements(schema: TaskSchema) -> tuple[Requirement, ...]:
    """What room the structures take that must hold at the end."""
    edge = {b.name: b.size for b in schema.blocks}
    found: list[Requirement] = []
    for atom in required(schema.goal):
        if isinstance(atom, s.Row):
            found.append(_row(atom, edge))
        elif isinstance(atom, s.Grid):
            widest = max(edge[n] for n in atom.blocks)
            found.append(Requirement(atom, "y", atom.columns * widest, int(WIDTH / widest)))
            found.append(Requirement(atom, "x", atom.rows * widest, int(DEPTH / widest)))
        elif isinstance(atom, s.Figure) and atom.shape == "circle" and not atom.filled:
            widest = max(edge[n] for n in atom.blocks)
            across = ring_width(len(atom.blocks), widest) + 2 * BORDER
            fits = next(n for n in range(MAX_BLOCKS, 1, -1) if ring_width(n, widest) + 2 * BORDER <= DEPTH)
            found.append(Requirement(atom, "x", across, fits))
        elif isinstance(atom, s.Spells) and atom.along == "row":
            widest = max(edge[n] for n in atom.blocks)
            found.append(Requirement(atom, "y", len(atom.word) * widest, int(WIDTH / widest)))
    return tuple(found)


def _row(row: s.Row, edge: dict[str, float]) -> Requirement:
    sizes = [edge[n] for n in row.blocks]
    widest = max(sizes)
    room = DEPTH if row.axis == "x" else WIDTH
    pitch = row.spacing or (widest + row.gap if row.gap else widest)
    extent = (len(sizes) - 1) * pitch + widest if row.spacing or row.gap else sum(sizes)
    return Requirement(row, row.axis or "any", extent, 1 + int((room - widest) / pitch + 1e-9))


def check(schema: TaskSchema) -> tuple[Diagnostic, ...]:
    """What cannot be, with the number that breaks it and what would fit."""
    problems = [_too_long(need) for need in requirements(schema) if _exceeds(need)]
    problems += _distances(schema)
    return tuple(problems)


def _exceeds(need: Requirement) -> bool:
    return need.extent_m > (DEPTH if need.axis == "x" else WIDTH) + 1e-9


def _too_long(need: Requirement) -> Diagnostic:
    room = DEPTH if need.axis == "x" else WIDTH
    count = len(getattr(need.atom, "blocks", ()))
    return Diagnostic(
        code="does-not-fit",
        message=f"{count} blocks take {need.extent_m * 100:.0f} cm here, but there are {room * 100:.0f} cm of room",
        span=need.atom.span, hint=f"at most {need.fits} fit",
        facts={"extent_m": round(need.extent_m, 4), "room_m": round(room, 4), "blocks": count, "fits": need.fits},
        origin="schema",
    )  # fmt: skip


def _distances(schema: TaskSchema) -> list[Diagnostic]:
    """Distances that are greater than the table, or that contradict each other for the same two blocks."""
    edge = {b.name: b.size for b in schema.blocks}
    found: list[Diagnostic] = []
    ranges: list[tuple[frozenset[str], float, float, g.Goal]] = []
    for atom in required(schema.goal):
        low, high = _range(atom, edge)
        if low > DIAGONAL:
            found.append(
                Diagnostic(
                    code="does-not-fit", message=f"{low * 100:.0f} cm apart is farther than the table is wide",
                    span=atom.span,
                    hint=f"at most {DIAGONAL * 100:.0f} cm fit",
                    facts={"distance_m": low, "room_m": round(DIAGONAL, 4)}, origin="schema",
                )
            )  # fmt: skip
        a, b = getattr(atom, "a", None), getattr(atom, "b", None)
        if isinstance(a, tuple) and isinstance(b, tuple) and len(a) == len(b) == 1:
            ranges.append((frozenset((*members(a), *members(b))), low, high, atom))
    for one, two in combinations(ranges, 2):
        if one[0] == two[0] and (one[1] > two[2] + 1e-9 or two[1] > one[2] + 1e-9):
            found.append(
                Diagnostic(
                    code="contradiction", message="these two distances contradict each other", span=two[3].span,
                    hint="leave one of them out", origin="schema",
                )
            )  # fmt: skip
    return found


def _range(atom: g.Goal, edge: dict[str, float]) -> tuple[float, float]:
    """The least and greatest distance of centres that an atom allows."""
    a, b = getattr(atom, "a", None), getattr(atom, "b", None)
    if not (isinstance(a, tuple) and isinstance(b, tuple) and len(a) == len(b) == 1):
        return 0.0, math.inf
    half = (edge.get(a[0], 0.0) + edge.get(b[0], 0.0)) / 2
    diagonal = math.sqrt(2.0)
    match atom:
        case r.Distance():
            plus = half if atom.measure == "faces" else 0.0
            return (atom.minimum or 0.0) + plus, math.inf if atom.maximum is None else (atom.maximum + plus) * (
                diagonal if plus else 1.0
            )
        case r.Beside() | r.Adjacent():
            return 0.0, (half * 2 + atom.gap_edges * 2 * half) * diagonal
        case r.Near():
            return 0.0, atom.distance
        case r.Apart():
            return atom.distance, math.inf
        case r.On():
            return 0.0, half * 2
        case _:
            return 0.0, math.inf


REPAIRS: dict[str, Repair] = {
    "too-many-labels": Repair(
        "REDUCE_LABELS_PRESERVE_GEOMETRY", f"keep the shape, with at most {MAX_LETTERS} letters and {MAX_DIGITS} digits"
    ),
    "order-misfit": Repair("SWITCH_ORDERING_PATTERN", "order by what the blocks show: letters, numbers or colours"),
    "order-conflict": Repair("SWITCH_ORDERING_PATTERN", "keep one of the orders"),
    "missing-symbol": Repair("SWITCH_TO_SPATIAL_ONLY", "keep where the blocks stand and ask nothing of their symbols"),
}
"""The structured repair for each kind of infeasibility that has one. It changes as little as possible."""


def with_repairs(diagnostics: tuple[Diagnostic, ...]) -> tuple[Diagnostic, ...]:
    """The diagnostics with the structured repair that would mend each, as facts `repair` and `keeps`."""
    return tuple(
        problem.model_copy(update={"facts": {**problem.facts, "repair": repair.kind, "keeps": repair.text}})
        if (repair := REPAIRS.get(problem.code))
        else problem
        for problem in diagnostics
    )
