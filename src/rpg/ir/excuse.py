"""Explicit turns win: a cube that the goal turns in the plane of its face need not be upright in what is read."""

from __future__ import annotations

from rpg.ir import goal as g
from rpg.ir.relations import Facing
from rpg.ir.structures import Cells, Equation, Row, Spells, Stack
from rpg.ir.walk import atoms, transform


def excuse(goal: g.Goal) -> g.Goal:
    """`goal` with the cubes that an atom of it turns on purpose excused from uprightness in its structures."""
    turned = {atom.block for atom in atoms(goal) if isinstance(atom, Facing) and atom.turn}
    if not turned:
        return goal

    def change(node: g.Goal) -> g.Goal:
        if not isinstance(node, Stack | Row | Cells | Spells | Equation):
            return node
        excused = tuple(name for name in node.blocks if name in turned or name in node.excused)
        return node if excused == node.excused else node.model_copy(update={"excused": excused})

    return transform(goal, change)
