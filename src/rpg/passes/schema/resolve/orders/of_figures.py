"""Parts that letters, triangles and staircases have of their own, however they lie; halves of grids."""

from __future__ import annotations

from collections.abc import Sequence

from rpg.blocks.figure_parts import own_parts
from rpg.blocks.figures import Cell
from rpg.blocks.layers import layer_sizes
from rpg.ir.structures import Cells, Figure, Grid, Staircase
from rpg.language.meaning import At, Meaning, Places, replace

_NAMES = {
    ("L", "corners"): "the corner", ("V", "point"): "the point", ("T", "bar"): "the bar", ("T", "stem"): "the stem",
    ("U", "corners"): "the two corners", ("U", "bottom"): "the base", ("U", "ends"): "the two ends",
    ("V", "ends"): "the two ends", ("triangle", "corners"): "the three corners",
}  # fmt: skip
"""Parts by the shape and by what is said of it."""


def of_figure(place: At | Places, node: Cells, count: int) -> list[list[int]]:
    """The places of a part, unit by unit, in the order in which the figure is drawn; none where it has no such part."""
    found = own_parts(node, count)
    if isinstance(node, Staircase):
        return _steps(place, node.steps, list(found.values()))
    shape = node.shape if isinstance(node, Figure) else ""
    tip = shape == "V" and isinstance(place, At) and place.tip
    places = found.get(_NAMES.get((shape, "point" if tip else place.side), ""), ())
    if getattr(place, "several", None) not in (None, len(places)):
        return []
    return [list(places)] if place.side in ("bar", "stem", "bottom") and places else [[k] for k in places]


def _steps(place: At | Places, total: int, lines: list[tuple[int, ...]]) -> list[list[int]]:
    """ "The highest step", "the second step": its blocks from the table up."""
    from rpg.passes.schema.resolve.orders.parts import chosen

    if isinstance(place, At):
        return [list(lines[-1])] if place.side == "top" else []
    if (place.unit, place.side) == ("cell", "top"):
        return [list(lines[-1])]
    if place.unit != "step":
        return []
    steps = chosen(place.side, place.index, place.several, total, ("bottom", "top"))
    return [list(lines[k]) for k in steps]


def as_lines(place: At | Places, told: Sequence[Meaning], node: Cells) -> At | Places:
    """The row, column, step or layer that is meant by "the bottom row" of a cube, by "the upper four", and by "the
    middle one" where other rows are told of."""
    levels = layer_sizes(node)
    unit = getattr(place, "unit", "block")
    if place.side == "middle" and place.index is None and unit == "block" and getattr(place, "several", None) is None:
        parts = [part for x in told for part in getattr(x, "adjuncts", ()) if isinstance(part, Places)]
        units = {part.unit for part in parts if part.side != "rest"}
        if len(units) == 1 and units <= {"row", "column", "step"}:
            return Places(side="middle", unit=units.pop(), span=place.span)
    if (
        not isinstance(place, Places)
        or place.side not in ("top", "bottom")
        or len(levels) < 2
        or place.index is not None
    ):
        return place
    many = levels[-1 if place.side == "top" else 0]
    cube = isinstance(node, Grid) and node.rows > 1
    as_row = unit == "row" and cube and place.several is None
    as_half = unit == "half" and len(levels) == 2
    counted = unit == "block" and place.several == many and not isinstance(node, Staircase)
    return replace(place, unit="layer", several=None) if as_row or as_half or counted else place


def half(side: str, cells: Sequence[Cell]) -> list[list[int]]:
    """The left, right, far, near, upper or lower half of a figure that can be halved so."""
    height = 1 + max(cell.level for cell in cells)
    if height > 1 and side in ("top", "bottom"):
        places = [height - 1 - cell.level for cell in cells]
    else:
        places = [cell.column if side in ("left", "right") else cell.row for cell in cells]
    total = 1 + max(places)
    side = {"top": "left", "back": "left", "bottom": "right", "front": "right"}.get(side, side)
    if total % 2 or side not in ("left", "right"):
        return []
    return [[k for k, place in enumerate(places) if (2 * place < total) == (side == "left")]]
