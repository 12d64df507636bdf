"""Gaps that are asked of a structure: "a 2x2 grid with gaps of 2 cm", "spell CAT, the letters touching each other"."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from rpg.blocks.predicates.common import TOUCH
from rpg.ir import goal as g
from rpg.ir import relations as r
from rpg.ir import structures as s
from rpg.ir.assets import EDGE
from rpg.ir.node import members
from rpg.ir.order import Order
from rpg.ir.walk import transform
from rpg.passes.schema.resolve.clauses.spec import Spec

Structure = s.Grid | s.Pyramid | s.Staircase | s.Figure | s.Spells | s.Equation | s.Row


def gaps_of(goals: list[g.Goal], spec: Spec) -> list[g.Goal]:
    """ "Touching", "evenly spaced" of a figure or a text: said of its blocks as of a line's, for `spaced` to tell."""
    asked, wholes = spec.spacings, [part for part in goals if isinstance(part, s.Cells | s.Spells | s.Equation)]
    if not asked or len(wholes) != 1:
        return []
    spec.spacings = []
    how: dict[str, Any] = {"evenly" if spacing.kind == "even" else "touching": True for spacing in asked}
    return [s.Row(blocks=wholes[0].blocks, span=asked[0].span, **how)]


def spaced(goal: g.Goal, sizes: Mapping[str, float]) -> g.Goal:
    """`goal` with the gaps of a structure told by the structure itself; `sizes`: the edge (m) of every block."""

    def change(node: g.Goal) -> g.Goal:
        if not isinstance(node, g.All):
            return node
        goals = list(node.goals)
        for said in [part for part in goals if _is_spacing(part)]:
            for other in goals:
                if other is not said and isinstance(other, Structure) and _same_blocks(other, said):
                    told = _told(other, said, sizes)
                    goals = [x for part in goals if part is not said for x in (told if part is other else [part])]
                    break
        goals = _sorted_rows(_as_far_as_told(goals, sizes))
        return goals[0] if len(goals) == 1 else node.model_copy(update={"goals": tuple(goals)})

    return transform(goal, change)


def _as_far_as_told(goals: list[g.Goal], sizes: Mapping[str, float]) -> list[g.Goal]:
    """ "Next to it with a gap of 6 cm": as far off as is told, and not as near as "next to" alone asks."""
    gaps = {(x.a, x.b): x.maximum for x in goals if isinstance(x, r.Distance) and x.measure == "faces" and x.maximum}
    found: list[g.Goal] = []
    for part in goals:
        wide = gaps.get((part.a, part.b)) if isinstance(part, r.Beside) else None
        if isinstance(part, r.Beside) and wide is not None:
            edge = max(sizes.get(name, EDGE) for name in (*members(part.a), *members(part.b)))
            part = part.model_copy(update={"gap_edges": max(part.gap_edges, round(wide / edge, 3))})
        found.append(part)
    return found


def _is_spacing(part: g.Goal) -> bool:
    """Does it say of several blocks nothing but how far apart neighbours are?"""
    if isinstance(part, s.GroupBy):
        return len(part.groups) == 1 and part.by is None and part.inner_edges == s.TOUCHING_EDGES
    return isinstance(part, s.Row) and part.axis is None and part.order == Order() and not part.readable


def _same_blocks(one: g.Goal, other: g.Goal) -> bool:
    return set(_blocks(one)) == set(_blocks(other))


def _blocks(part: g.Goal) -> tuple[str, ...]:
    if isinstance(part, s.GroupBy):
        return tuple(name for group in part.groups for name in group)
    return part.blocks if isinstance(part, Structure) else ()


def _told(structure: Structure, said: g.Goal, sizes: Mapping[str, float]) -> list[g.Goal]:
    """The structure with its spacing; of a text, a line with that spacing beside it."""
    line = said if isinstance(said, s.Row) else s.Row(blocks=structure.blocks, touching=True, span=said.span)
    edge = max(sizes[name] for name in structure.blocks)
    gap, tolerance = _gap(line, edge)
    if isinstance(structure, s.Cells):
        if line == s.Row(blocks=line.blocks, evenly=True, span=line.span):
            return [structure]  # a figure is even by itself
        return [structure.model_copy(update={"gap": round(gap, 6), "tolerance": round(tolerance, 6)})]
    if isinstance(structure, s.Row):
        fields = ("touching", "evenly", "spacing", "gap", "tolerance", "gap_edges")
        return [structure.model_copy(update={field: getattr(line, field) for field in fields})]
    if structure.along == "stack":
        return [structure, said]
    widest = round((gap + tolerance) / edge, 6)
    return [structure.model_copy(update={"gap_edges": max(structure.gap_edges, widest)}), line]


def _gap(line: s.Row, edge: float) -> tuple[float, float]:
    """The gap (m) between the faces of neighbours in a line, and how much more or less it may be."""
    if line.touching:
        return 0.0, TOUCH
    if line.spacing is not None:
        return max(0.0, line.spacing - edge), line.tolerance
    if line.gap is not None:
        return line.gap, line.tolerance
    return line.gap_edges * edge / 2, line.gap_edges * edge / 2


def _sorted_rows(goals: list[g.Goal]) -> list[g.Goal]:
    """A row whose blocks are sorted has those that are alike next to each other: groups apart would be no row."""
    for row in [part for part in goals if isinstance(part, s.Row) and part.order == Order()]:
        for sort in [part for part in goals if isinstance(part, s.GroupBy) and not part.outliers]:
            if sort.by is not None and _same_blocks(row, sort):
                order = Order(by="together", attribute=sort.by)
                goals = [row.model_copy(update={"order": order}) if part is row else part for part in goals]
                goals.remove(sort)
                return goals
    return goals
