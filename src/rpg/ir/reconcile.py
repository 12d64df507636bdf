"""Conditions of one goal that override what a structure of it would ask by itself.

A cube that the goal turns in the plane of its face, or that must stay where it is, need not be upright where it is
read; one that the goal puts a block on may have it there, and a block that it puts beside a text may adjoin it; a stack
that the goal puts on another block need not stand on the table.
"""

from __future__ import annotations

from collections.abc import Iterator

from rpg.ir import goal as g
from rpg.ir.node import members
from rpg.ir.relations import Above, Adjacent, Behind, Beside, Facing, InFrontOf, LeftOf, On, RightOf, Stayed, Touching
from rpg.ir.structures import Cells, Equation, Row, Spells, Stack
from rpg.ir.walk import children, transform

_Beside = LeftOf | RightOf | InFrontOf | Behind | Beside | Adjacent | Touching
_BESIDE = (LeftOf, RightOf, InFrontOf, Behind, Beside, Adjacent, Touching)


def reconcile(goal: g.Goal) -> g.Goal:
    """`goal` with its structures told what its other atoms override; of alternatives, those of the same one."""
    asked = list(_demanded(goal))
    turned = {atom.block for atom in asked if isinstance(atom, Facing) and atom.turn}
    turned |= {name for atom in asked if isinstance(atom, Stayed) for name in members(atom.a)}
    resting = [atom for atom in asked if isinstance(atom, On)]
    lifting = [atom for atom in asked if isinstance(atom, On | Above)]
    beside = [atom for atom in asked if isinstance(atom, _BESIDE)]
    read = {id(atom) for atom in asked if getattr(atom, "readable", isinstance(atom, Equation))}

    def change(node: g.Goal) -> g.Goal:
        readable = id(node) in read
        if isinstance(node, g.Any):
            return node.model_copy(update={"goals": tuple(reconcile(part) for part in node.goals)})
        if turned and isinstance(node, Stack | Row | Cells | Spells | Equation):
            excused = tuple(name for name in node.blocks if name in turned or name in node.excused)
            if excused != node.excused:
                node = node.model_copy(update={"excused": excused})
        if readable and isinstance(node, Row | Cells | Spells | Equation):
            under = {name for on in resting for name in _covered(on, node.blocks)}
            covered = tuple(name for name in node.blocks if name in under or name in node.covered)
            if covered != node.covered:
                node = node.model_copy(update={"covered": covered})
        if isinstance(node, Spells | Equation) and node.along == "row":
            told = {name for atom in beside for name in _others(atom, node.blocks)}
            if told - {*node.beside}:
                node = node.model_copy(update={"beside": tuple(sorted({*node.beside, *told}))})
        if isinstance(node, Stack) and not node.raised and any(_lifts(x, node) for x in lifting):
            node = node.model_copy(update={"raised": True})
        return node

    return transform(goal, change)


def reconciled(goals: tuple[g.Goal, ...]) -> tuple[g.Goal, ...]:
    """Conditions that hold together, as those of a start, told what the others override."""
    whole = reconcile(g.All(goals=goals))
    return whole.goals if isinstance(whole, g.All) else (whole,)


def _demanded(goal: g.Goal) -> Iterator[g.Goal]:
    """The atoms that hold wherever the goal is met, at some stage of it; a turn either way is a turn."""
    if isinstance(goal, g.All | g.Sequence | g.Always):
        for part in children(goal):
            yield from _demanded(part)
    elif isinstance(goal, g.Any) and all(isinstance(x, Facing) and x.turn for x in goal.goals):
        facing = [x for x in goal.goals if isinstance(x, Facing)]
        yield from facing[:1] if len({x.block for x in facing}) == 1 else ()
    else:
        yield goal


def _covered(on: On, read: tuple[str, ...]) -> Iterator[str]:
    """The block among those that are read on which `on` puts another one."""
    if isinstance(on.b, tuple) and set(read).isdisjoint(members(on.a)):
        yield from (name for name in on.b if name in read)


def _others(atom: _Beside, read: tuple[str, ...]) -> Iterator[str]:
    """The blocks that `atom` puts beside some of those that are read."""
    for one, other in ((atom.a, atom.b), (atom.b, atom.a)):
        if not set(read).isdisjoint(members(one)) and set(read).isdisjoint(members(other)):
            yield from members(other)


def _lifts(over: On | Above, stack: Stack) -> bool:
    """Does `over` put a block of the stack on, or somewhere above, a block outside of it?"""
    inside = set(stack.blocks)
    return not inside.isdisjoint(members(over.a)) and inside.isdisjoint(members(over.b))
