"""The families of figures that the second reader knows."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from rpg.language.frames import (
    equation,
    grids,
    group,
    mats,
    relations,
    row,
    rowlabels,
    shape,
    spelled,
    stairs,
    tower,
    towers,
)
from rpg.language.frames.pieces import Pattern, Piece

FAMILIES: tuple[tuple[Sequence[Pattern], Callable[[Sequence[Piece]], str]], ...] = (
    (tower.PATTERNS, tower.told),
    (grids.PATTERNS, grids.told),
    (shape.PATTERNS, shape.told),
    (stairs.PATTERNS, stairs.told),
    (row.PATTERNS, row.told),
    (rowlabels.PATTERNS, rowlabels.told),
    (equation.PATTERNS, equation.told),
    (group.PATTERNS, group.told),
    (mats.PATTERNS, mats.told),
    (spelled.PATTERNS, spelled.told),
    (towers.PATTERNS, towers.told),
    (relations.PATTERNS, relations.told),
)
"""The patterns of each family, and how it tells its pieces again (or raises Unclear)."""
