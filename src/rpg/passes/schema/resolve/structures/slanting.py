"""Rows that lie diagonally: along which of the two diagonals, and from which end."""

from __future__ import annotations

from collections.abc import Sequence

from rpg.core.diagnostics import Span
from rpg.ir import structures as s
from rpg.ir.node import SLOPES, Slope
from rpg.ir.order import Order
from rpg.language.meaning import At, Toward, replace
from rpg.passes.schema.resolve.clauses.spec import Spec
from rpg.passes.schema.resolve.things.world import refuse

_ENDS = {"rising": {"front": "left", "back": "right"}, "falling": {"front": "right", "back": "left"}}
"""The left and the right end of each, by whether it is the near or the far one."""
_SAY = "say 'a diagonal line from the near left to the far right'"
_LINES = ("row", "line", "column", "gradient")


def check_slanting(toward: Sequence[Toward], kind: str) -> None:
    """Raise Refusal where something is told to lie diagonally that is no line."""
    told = next((way for way in toward if way.axis in SLOPES), None)
    if told and kind not in _LINES:
        raise refuse("unsupported-structure", "only a line of blocks lies diagonally", told.span, _SAY)


def slope_of(spec: Spec, kind: str, span: Span) -> Slope | None:
    """The diagonal that a row lies along; what is told of its near or its far end is that of its left or its right one.

    Raises:
        Refusal: it is a column, or lies along both.
    """
    told: list[Slope] = [slope for slope in SLOPES if any(way.axis == slope for way in spec.toward)]
    one = told[:-1] if len(told) > 1 and told[-1] == "diagonal" else told
    if len(one) > 1 or (one and kind == "column"):
        raise refuse("contradiction", "a line lies along one diagonal, and a column along none", span, _SAY)
    sides = _ENDS.get(one[0], {}) if one else {}

    def across(at: At) -> At:
        return replace(at, side=sides.get(at.side, at.side))

    spec.ats = [across(at) for at in spec.ats]
    spec.absolutes = [
        replace(said, adjuncts=tuple(across(x) if isinstance(x, At) else x for x in said.adjuncts))
        for said in spec.absolutes
    ]
    return one[0] if one else None


def slanting(row: s.Row, slope: Slope | None, order: Order) -> s.Row:
    """The row in an order, along a diagonal if it is told to lie so; its symbols need not be read there.

    Raises:
        Refusal: it begins at the near or the far end, and may lie along either diagonal.
    """
    if slope is None:
        return row.model_copy(update={"order": order})
    first = _ENDS.get(slope, {}).get(order.first or "", order.first)
    if first in ("front", "back"):
        raise refuse("ambiguous", "it is not said which diagonal this is", row.span or (0, 0), _SAY)
    ordered = order.model_copy(update={"first": first})
    return row.model_copy(update={"axis": slope, "order": ordered, "readable": False})
