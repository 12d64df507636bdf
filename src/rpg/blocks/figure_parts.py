"""Parts that a figure has however it lies: the corner of an L, the bar of a T, the steps of a staircase.

A part is told by indices of cells in the order in which the figure is drawn (`Pattern.own`), which no turn changes.
"""

from __future__ import annotations

from collections.abc import Sequence

from rpg.blocks.figures import Cell, ideals
from rpg.ir.structures import Cells, Figure, Staircase

Places = tuple[int, ...]
_SHAPES = frozenset({"L", "T", "V", "U", "triangle"})
_STEPS = ("the lowest step", "the second step", "the third step", "the fourth step", "the fifth step")


def has_own(node: Cells) -> bool:
    """Whether parts of the figure are told by its own cells, and not as a page is read."""
    return isinstance(node, Staircase) or (isinstance(node, Figure) and node.shape in _SHAPES)


def own_parts(node: Cells, count: int) -> dict[str, Places]:
    """The parts by what they are called; without those that other sizes of the figure have elsewhere."""
    if isinstance(node, Staircase):
        return _of_stairs(node.steps)
    forms = ideals(node, count)
    if not forms or not isinstance(node, Figure):
        return {}
    found = [_of_figure(node.shape, node.filled, form.cells) for form in forms]
    return {name: places for name, places in found[0].items() if all(x.get(name) == places for x in found)}


def _of_stairs(steps: int) -> dict[str, Places]:
    """Its steps from the lowest to the highest, and the block on top of all."""
    lines = [tuple(range(k * (k + 1) // 2, (k + 1) * (k + 2) // 2)) for k in range(steps)]
    names = [*_STEPS[: steps - 1], "the highest step"]
    return dict(zip(names, lines, strict=False)) | {"the top block of the highest step": (lines[-1][-1],)}


def _of_figure(shape: str, filled: bool, cells: Sequence[Cell]) -> dict[str, Places]:
    """The parts of a drawn figure: an L and a V begin with the block where their arms meet, a T with its bar,
    a U with its corners."""
    total = len(cells)
    if shape == "L":
        return {"the corner": (0,)}
    if shape == "V":
        return {"the point": (0,), "the two ends": (total - 2, total - 1)}
    if shape == "T":
        bar = _first_line(cells)
        return {"the bar": tuple(range(bar)), "the stem": tuple(range(bar, total))}
    if shape == "U":
        base = _first_line(cells)
        ends = {"the two corners": (0, 1), "the two ends": (total - 2, total - 1)}
        return ends | {"the base": tuple(range(base)), "the arms": tuple(range(base, total))}
    side = next(n for n in range(2, total + 1) if (n * (n + 1) // 2 if filled else 3 * n - 3) == total)
    return {"the three corners": (0, total - side, total - 1)}


def _first_line(cells: Sequence[Cell]) -> int:
    """How many cells from the first on lie in one line with it and the second."""
    dx, dy = cells[1].x - cells[0].x, cells[1].y - cells[0].y
    return next(
        (k for k, c in enumerate(cells) if abs(dx * (c.y - cells[0].y) - dy * (c.x - cells[0].x)) > 1e-6), len(cells)
    )
