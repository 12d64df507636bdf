"""Where one of the blocks of a grid that look alike is, told after the grid: "the middle one", "the far left one"."""

from __future__ import annotations

from rpg.core.diagnostics import Span
from rpg.ir import goal as g
from rpg.ir import structures as s
from rpg.ir.order import Order, Pattern
from rpg.ir.walk import transform
from rpg.language.meaning import At, Meaning
from rpg.passes.schema.resolve.things.world import Ref, refuse

CELLS = {"back left": (0, 0), "back right": (0, 1), "front left": (1, 0), "front right": (1, 1)}
"""Corners by row and column: the far row is the first, and is told from left to right."""


def in_grid(goal: g.Goal, node: s.Grid, item: tuple[Ref, Meaning, Span]) -> g.Goal:
    """The goal with the one block in its cell."""
    ref, at_, span = item
    side, last = getattr(at_, "side", ""), (node.rows - 1, node.columns - 1)
    odd = side == "middle" and any(n % 2 for n in last)
    if not isinstance(at_, At) or node.layers > 1 or node.pattern is not None or odd:
        raise refuse("misplaced", "the structure has no such part", span, "name its blocks one by one")
    down, across = CELLS.get(side, (0.5, 0.5))
    before = int(down * last[0]) * node.columns + int(across * last[1])
    rest = [n for n in node.blocks if n not in ref.names]
    ranks = tuple(r for r in (tuple(rest[:before]), ref.names, tuple(rest[before:])) if r)
    laid = Pattern(kind="reading", order=Order(by="given", ranks=ranks, match="name"))
    return transform(goal, lambda x: node.model_copy(update={"pattern": laid}) if x == node else x)
