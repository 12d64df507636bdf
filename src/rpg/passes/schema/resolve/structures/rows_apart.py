"""Several rows: none adjoins another as if they were one, though they may lie close to each other."""

from __future__ import annotations

from itertools import combinations
from math import factorial

from rpg.blocks.symmetry import MAX_NAMINGS
from rpg.core.diagnostics import Span
from rpg.ir import goal as g
from rpg.ir import relations as r
from rpg.ir import structures as s
from rpg.ir.walk import names
from rpg.language.meaning import Places, Structure
from rpg.passes.schema.resolve.goals.logic import conj
from rpg.passes.schema.resolve.things.world import Scene, refuse


def on_the_table(shape: Structure, scene: Scene) -> Span:
    """The words for several lines, unless they are stacked."""
    if shape.kind in ("row", "line") and scene.verbs[scene.clause][2] == "stack":
        raise refuse("ambiguous", "one row on the other, or each of them on the table?", shape.span,
                     "say 'a wall of two layers', or 'put' the blocks in rows")  # fmt: skip
    return shape.span


def not_one_line(rows: list[g.Goal], span: Span) -> list[g.Goal]:
    """ "Two rows of three": they do not form one row of six, nor a wall with one row on the other."""
    lines = [row for row in rows if isinstance(row, s.Row)]
    if len(lines) < len(rows) or len({(row.axis, row.gap, row.spacing) for row in lines}) > 1:
        return []
    blocks = tuple(name for row in lines for name in row.blocks)
    return [
        g.Not(goal=s.Row(blocks=blocks, axis=lines[0].axis, span=span), span=span),
        r.OnTable(a=blocks, span=span),
    ]


def no_two_in_one_line(goal: g.Goal) -> g.Goal:
    """ "A red row and a blue row", of which nothing says where one lies as the other is seen: they are two rows, and
    not red and blue by turns in one."""
    parts = goal.goals if isinstance(goal, g.All) else ()
    rows = [part for part in parts if isinstance(part, s.Row) and len(part.blocks) > 1]
    apart: list[g.Goal] = []
    for one, other in combinations(rows, 2):
        blocks = {*one.blocks}, {*other.blocks}
        related = [x for x in parts if not blocks[0].isdisjoint(names(x)) and not blocks[1].isdisjoint(names(x))]
        if blocks[0].isdisjoint(blocks[1]) and not related:
            apart += not_one_line([one, other], other.span or (0, 0))
    return conj([*parts, *apart], goal.span) if apart else goal


def too_alike(rows: list[g.Goal], scene: Scene, span: Span) -> s.Grid | None:
    """ "Put twelve blocks in three rows of four": a grid, where there would be too many ways to deal blocks that look
    alike out to rows that may lie anywhere."""
    lines = [row for row in rows if isinstance(row, s.Row)]
    blocks = tuple(name for row in lines for name in row.blocks)
    plain = [row.model_copy(update={"blocks": lines[0].blocks}) == lines[0] for row in lines]
    if len(lines) < len(rows) or not all(plain) or len({len(row.blocks) for row in lines}) > 1:
        return None
    first = lines[0]
    if first.order.by != "any" or first.axis is None or first.gap is not None or first.spacing is not None:
        return None
    looks = {(t.color, t.label, t.edge) for t in (scene.things[n] for n in blocks)}
    if len(looks) > 1 or factorial(len(blocks)) // factorial(len(first.blocks)) ** len(lines) <= MAX_NAMINGS:
        return None
    scene.assume("so many rows of blocks that look alike are read as a grid: one beside the other")
    sides = (len(lines), len(first.blocks)) if first.axis == "y" else (len(first.blocks), len(lines))
    return s.Grid(blocks=blocks, rows=sides[0], columns=sides[1], span=span)


def close_by(atom: g.Goal, scene: Scene) -> g.Goal:
    """One of several rows in order of its symbols: named one by one, for the other rows may adjoin it."""
    if not isinstance(atom, s.Row) or atom.order.by not in ("label", "number"):
        return atom
    labels = [scene.things[n].label or "" for n in atom.blocks]
    if not all(labels) or len(set(labels)) < len(labels):
        return atom
    ranked = sorted(atom.blocks, key=lambda n: scene.things[n].label or "", reverse=atom.order.descending)
    order = atom.order.model_copy(update={"by": "given", "ranks": tuple((n,) for n in ranked), "descending": False})
    return atom.model_copy(update={"order": order})


def own_unit(shape: Structure, place: Places) -> None:
    """Refuse "two rows: the far column ..."."""
    if {place.unit, shape.kind} == {"row", "column"}:
        raise refuse("no-referent", f"these are {shape.kind}s, and none of them is a {place.unit}", place.span,
                     f"say '{shape.kind}'")  # fmt: skip
