"""Where one of the blocks of a grid or a plus is, told after it: "the middle one", "the far left one"."""

from __future__ import annotations

from rpg.core.diagnostics import Span
from rpg.ir import goal as g
from rpg.ir import structures as s
from rpg.ir.order import Order, Pattern
from rpg.ir.walk import transform
from rpg.language.meaning import At, Meaning
from rpg.passes.schema.resolve.things.world import Ref, Scene, refuse

CELLS = {"back left": (0, 0), "back right": (0, 1), "front left": (1, 0), "front right": (1, 1)}
"""Corners by row and column: the far row is the first, and is told from left to right."""


def in_grid(goal: g.Goal, node: s.Grid | s.Figure, item: tuple[Ref, Meaning, Span], scene: Scene) -> g.Goal:
    """The goal with the one block in its cell."""
    ref, at_, span = item
    before = _cells_before(node, at_.side) if isinstance(at_, At) and node.pattern is None else None
    if before is None:
        raise refuse("misplaced", "the structure has no such part", span, "name its blocks one by one")
    rest = [n for n in node.blocks if n not in ref.names]
    ranks = tuple(r for r in (tuple(rest[:before]), ref.names, tuple(rest[before:])) if r)
    looks = {n: (scene.things[n].color, scene.things[n].label) for n in node.blocks}
    unlike = {looks[n] for n in rest}.isdisjoint(looks[n] for n in ref.names)
    laid = Pattern(kind="reading", order=Order(by="given", ranks=ranks, match="look" if unlike else "single"))
    return transform(goal, lambda x: node.model_copy(update={"pattern": laid}) if x == node else x)


def _cells_before(node: s.Grid | s.Figure, side: str) -> int | None:
    """How many cells are read before the one at a side; None where the structure has no such cell."""
    if isinstance(node, s.Figure):
        return len(node.blocks) // 2 if has_centre(node) and side == "middle" else None
    last = (node.rows - 1, node.columns - 1)
    if node.layers > 1 or (side == "middle" and any(n % 2 for n in last)):
        return None
    down, across = CELLS.get(side, (0.5, 0.5))
    return int(down * last[0]) * node.columns + int(across * last[1])


def has_centre(node: g.Goal) -> bool:
    """Whether a figure has one block in its middle, with as many read before as behind it."""
    return isinstance(node, s.Figure) and node.shape in ("plus", "X") and len(node.blocks) % 2 == 1
