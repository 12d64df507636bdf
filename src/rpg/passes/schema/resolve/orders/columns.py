"""The columns of a staircase: "the highest column", "the left column"."""

from __future__ import annotations

from collections.abc import Sequence

from rpg.blocks.figures import Cell
from rpg.ir import structures as s
from rpg.language.meaning import Places
from rpg.passes.schema.resolve.things.world import refuse


def columns_of(part: Places, node: s.Staircase, cells: Sequence[Cell]) -> list[list[int]]:
    """Those of a staircase that goes up to a side; else it may be either end."""
    from rpg.passes.schema.resolve.orders.parts import FIRST, chosen

    if node.up is None:
        raise refuse("ambiguous", "it is not said to which side the staircase goes up", part.span,
                     "say for example 'going up to the right'")  # fmt: skip
    columns = [[k for k, c in enumerate(cells) if c.column == n] for n in range(node.steps)]
    if part.side in ("top", "bottom"):
        columns.sort(key=len, reverse=part.side == "top")
        return columns[: part.several or 1] if part.index is None else []
    across = node.up in ("left", "right") and part.side in ("left", "right", "middle")
    found = chosen(part.side, part.index, part.several, node.steps, FIRST["column"]) if across else []
    return [columns[k] for k in found]
