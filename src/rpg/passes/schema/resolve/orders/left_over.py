"""What is left of a structure when other parts were told: "the other two", "the other two rows", "all above"."""

from __future__ import annotations

from collections.abc import Sequence

from rpg.blocks.figures import Cell
from rpg.language.meaning import At, Places
from rpg.passes.schema.resolve.things.world import refuse


def all_left(place: At | Places | None, left: Sequence[int], told: Sequence[int]) -> None:
    """ "the other two": so many places have to be left. "everything above it": above all that were told, by levels."""
    several = place.several if isinstance(place, Places) and place.unit in ("", "block", "cell") else None
    if place is not None and several not in (None, len(left)):
        raise refuse("count-mismatch", f"{len(left)} places are left for these, but {several} are told", place.span,
                     f"say {len(left)}", places=len(left), named=several)  # fmt: skip
    way = place.index if isinstance(place, Places) else None
    if place is not None and way and not all(way * (here - there) > 0 for here in left for there in told):
        raise refuse("contradiction", "not all that is left is there", place.span, "say 'everything else'")


def lines_left(place: Places, left: Sequence[Cell], told: Sequence[Cell], stands: bool) -> None:
    """ "the other two rows": so many have to be left, and nothing told of any of them."""
    unit = "layer" if stands and place.unit == "row" else place.unit
    field = {"row": "row", "column": "column", "layer": "level"}.get(unit)
    if field is None:
        return
    here, there = ({getattr(cell, field) for cell in cells} for cells in (left, told))
    if here & there or place.several not in (None, len(here)):
        raise refuse("count-mismatch", f"{len(here - there)} {place.unit}s are left for this", place.span,
                     "say 'everything else'")  # fmt: skip
