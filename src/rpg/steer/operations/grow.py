"""More or fewer look-alikes: in what no structure holds together, and of every look in what one does."""

from __future__ import annotations

from collections.abc import Sequence

from rpg.core.diagnostics import Span
from rpg.ir import goal as g
from rpg.ir.edits import AddAsset, RemoveAsset, SetGoal
from rpg.ir.order import Order
from rpg.ir.structures import Cells, Equation, GroupBy, Row, Spells, Stack
from rpg.ir.walk import transform
from rpg.steer.draft import Draft
from rpg.steer.operations.lines import insert
from rpg.steer.operations.make import named
from rpg.steer.requests import requests as r


def of_each_look(draft: Draft, request: r.Recount) -> None:
    """So many of every look: "two of each colour"."""
    assert request.amount is not None
    line, figure = draft.view.main_line(), draft.view.main_figure()
    members = line.members if line else figure.members if figure else draft.view.busy
    looks = _looks(draft, members)
    if len(looks) < 2 or (line and isinstance(line.node, Spells | Equation)) or (figure and _cells(figure.node)):
        told, hint = "the blocks here do not come in several looks", "say how many blocks there should be"
        raise draft.refusal("edit-unclear", told, request.span, hint)
    if all(len(alike) == request.amount for alike in looks):
        raise draft.refusal("nothing-to-do", f"there are {request.amount} of each already", request.span)
    for alike in looks:
        grow(draft, alike, request.amount, request.span)


def _cells(node: g.Goal) -> bool:
    return isinstance(node, Cells)


def _looks(draft: Draft, members: Sequence[str]) -> list[list[str]]:
    """Members by their look."""
    found: dict[object, list[str]] = {}
    for name in members:
        found.setdefault(draft.view.world.look[name], []).append(name)
    return list(found.values())


def grow(draft: Draft, alike: Sequence[str], wanted: int, span: Span) -> None:
    """Make it so many blocks like `alike`: a new one has the part in the goal that they all have."""
    for name in reversed(alike[wanted:]):
        draft.do(RemoveAsset(name=name), span)
    for _ in range(wanted - len(alike)):
        model = draft.view.world.blocks[alike[-1]]
        (asset,) = named(draft, [model.model_copy(update={"origin": None})])
        draft.do(AddAsset(asset=asset), span)
        line = draft.view.line_of(alike)
        if line is not None and isinstance(line.node, Stack | Row) and line.ordered:
            insert(draft, line, line.members.index(alike[-1]) + 1, asset.name, span)
        else:
            _share(draft, alike, asset.name, span)
        alike = (*alike, asset.name)


def _share(draft: Draft, alike: Sequence[str], name: str, span: Span) -> None:
    """Give the new block a place wherever the goal speaks of all the others as a set."""
    before = draft.schema.goal
    goal = transform(before, lambda node: _with(node, tuple(alike), name))
    if goal == before:
        told = "the goal asks something else of each of these blocks"
        raise draft.refusal("edit-unclear", told, span, "say where the new block goes")
    draft.do(SetGoal(goal=goal), span)


def _with(node: g.Goal, alike: tuple[str, ...], name: str) -> g.Goal:
    """A node with the new block in every set that has all of `alike`."""
    update: dict[str, object] = {}
    for field in ("a", "b", "blocks", "over"):
        value = getattr(node, field, None)
        if isinstance(value, tuple) and set(alike) <= set(value):
            update[field] = _after(value, alike, name)
    if isinstance(node, GroupBy):
        update["groups"] = tuple(_after(each, alike, name) if set(alike) <= set(each) else each for each in node.groups)
    order = getattr(node, "order", None)
    if isinstance(order, Order) and order.ranks:
        ranks = tuple(_after(rank, alike, name) if set(alike) <= set(rank) else rank for rank in order.ranks)
        update["order"] = order.model_copy(update={"ranks": ranks})
    return node.model_copy(update=update) if update else node


def _after(names: Sequence[str], alike: Sequence[str], name: str) -> tuple[str, ...]:
    at = max(index for index, each in enumerate(names) if each in alike) + 1
    return (*names[:at], name, *names[at:])
