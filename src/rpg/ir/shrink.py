"""Goals without some of their objects: what is left of a goal when a block or a patch leaves the task."""

from __future__ import annotations

from collections.abc import Collection
from typing import Any as AnyType

from rpg.ir import goal as g
from rpg.ir.base import Names
from rpg.ir.node import Highest, Lowest
from rpg.ir.order import Order
from rpg.ir.relations import On
from rpg.ir.structures import Cells, Figure, GroupBy, Row, Stack, Towers
from rpg.ir.walk import atoms, children, transform

OPERANDS = ("a", "b", "c", "block", "patch")


class TooSmall(Exception):
    """A structure cannot do without a block that is to leave it; `goal` is the structure."""

    def __init__(self, goal: g.Goal) -> None:
        self.goal = goal
        super().__init__(f"a {goal.kind.replace('_', ' ')} of {_count(goal)} blocks has no place for fewer")


def close(goal: g.Goal, gone: str) -> g.Goal:
    """`goal` with `gone` taken out of towers that are written as "a on b": what was on it is on what it was on."""
    below = [atom.b for atom in atoms(goal) if isinstance(atom, On) and atom.a == (gone,)]
    if len(below) != 1:
        return goal

    def lower(node: g.Goal) -> g.Goal:
        return node.model_copy(update={"b": below[0]}) if isinstance(node, On) and node.b == (gone,) else node

    return transform(goal, lower)


def without(goal: g.Goal, gone: Collection[str]) -> g.Goal | None:
    """`goal` without the objects of `gone`: None where nothing is left to ask for, TooSmall where a figure breaks."""
    match goal:
        case g.All() | g.Any():
            kept = tuple(part for part in (without(part, gone) for part in goal.goals) if part is not None)
            if len(kept) == 1 and len(goal.goals) > 1:
                return kept[0]
            return goal.model_copy(update={"goals": kept}) if kept else None
        case g.Sequence():
            stages = tuple(
                stage.model_copy(update={"goal": part})
                for stage, part in ((stage, without(stage.goal, gone)) for stage in goal.stages)
                if part is not None
            )
            return goal.model_copy(update={"stages": stages}) if stages else None
        case g.Not() | g.Always():
            part = without(goal.goal, gone)
            return None if part is None else goal.model_copy(update={"goal": part})
        case g.Count():
            return _fewer_counted(goal, gone)
        case _:
            return _smaller(goal, gone)


def _fewer_counted(goal: g.Count, gone: Collection[str]) -> g.Goal | None:
    over = _kept(goal.over, gone)
    part = without(goal.goal, gone)
    if part is None or not over:
        return None
    if len(over) < goal.at_least:
        raise TooSmall(goal)
    return goal.model_copy(update={"over": over, "goal": part})


def _smaller(atom: g.Goal, gone: Collection[str]) -> g.Goal | None:
    """An atom without some of its objects."""
    update: dict[str, AnyType] = {}
    for field in OPERANDS:
        value = getattr(atom, field, None)
        if value is None:
            continue
        kept = _kept_operand(value, gone)
        if kept is None and not (field == "patch" and isinstance(atom, Stack)):
            return None
        if kept != value:
            update[field] = kept
    if isinstance(atom, GroupBy):
        groups = tuple(group for group in (_kept(group, gone) for group in atom.groups) if group)
        return atom.model_copy(update={"groups": groups}) if len(groups) > 1 else None
    blocks = getattr(atom, "blocks", None)
    if blocks is not None and any(name in gone for name in blocks):
        return _shorter(atom, _kept(blocks, gone), gone)
    return atom.model_copy(update=update) if update else atom


def _shorter(atom: g.Goal, blocks: Names, gone: Collection[str]) -> g.Goal | None:
    """A structure of fewer blocks: lines and loose figures shrink, figures of a fixed number of cells do not."""
    if len(blocks) < 2:
        return None
    match atom:
        case Stack() | Row():
            return atom.model_copy(update={"blocks": blocks, "order": _order(atom.order, gone)})
        case Towers():
            if atom.heights is not None:
                raise TooSmall(atom)
            return atom.model_copy(update={"blocks": blocks})
        case Figure() if atom.sides is None and not atom.filled:
            return atom.model_copy(update={"blocks": blocks})
        case _:
            raise TooSmall(atom)


def _order(order: Order, gone: Collection[str]) -> Order:
    ranks = tuple(rank for rank in (_kept(rank, gone) for rank in order.ranks) if rank)
    return order.model_copy(update={"ranks": ranks}) if order.ranks else order


def _kept(names: Names, gone: Collection[str]) -> Names:
    return tuple(name for name in names if name not in gone)


def _kept_operand(value: AnyType, gone: Collection[str]) -> AnyType:
    match value:
        case str():
            return None if value in gone else value
        case Lowest():
            kept = _kept(value.lowest, gone)
            return Lowest(lowest=kept) if kept else None
        case Highest():
            kept = _kept(value.highest, gone)
            return Highest(highest=kept) if kept else None
        case _:
            return _kept(value, gone) or None


def _count(goal: g.Goal) -> int:
    """How many blocks a structure or a count is about."""
    if isinstance(goal, g.Count):
        return len(goal.over)
    if isinstance(goal, Cells | Towers):
        return len(goal.blocks)
    return len(getattr(goal, "blocks", ())) or len(children(goal))
