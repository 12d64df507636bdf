"""A goal as a mirror shows it: left and right change places."""

from __future__ import annotations

from typing import Any

from rpg.ir import goal as g
from rpg.ir.order import Order
from rpg.ir.relations import LeftOf, RightOf
from rpg.ir.structures import Row, Spells
from rpg.ir.walk import transform

SWAP = {"left": "right", "right": "left"}
_SLOPES = {"rising": "falling", "falling": "rising"}


def mirrored(goal: g.Goal) -> g.Goal:
    """`goal` with every left a right: relations, orders, regions, directions. Towers and words stay as they are."""
    return transform(goal, _mirror)


def _mirror(node: g.Goal) -> g.Goal:
    if isinstance(node, LeftOf | RightOf):
        other = RightOf if isinstance(node, LeftOf) else LeftOf
        return other.model_validate(node.model_dump(exclude={"kind"}))
    if isinstance(node, Spells) and node.along == "row":
        return node.model_copy(update={"reverse": not node.reverse})
    update: dict[str, Any] = {}
    for field in ("up", "pointing"):
        if getattr(node, field, None) in SWAP:
            update[field] = SWAP[getattr(node, field)]
    region = getattr(node, "region", "")
    if "left" in region or "right" in region:
        update["region"] = "_".join(SWAP.get(part, part) for part in region.split("_"))
    if isinstance(node, Row) and node.axis in _SLOPES:
        update["axis"] = _SLOPES[node.axis]
    order = getattr(node, "order", None)
    if isinstance(order, Order) and isinstance(node, Row) and node.axis != "x":
        first = order.first or ("left" if order.by == "given" else None)
        if first in SWAP:
            update["order"] = order.model_copy(update={"first": SWAP[first]})
    return node.model_copy(update=update) if update else node
