"""The families of figures that the second reader knows."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from rpg.language.frames.grids import grid as grids
from rpg.language.frames.groups import group, mats
from rpg.language.frames.lines import labels as rowlabels
from rpg.language.frames.lines import row
from rpg.language.frames.pieces import Pattern, Piece
from rpg.language.frames.relations import relations
from rpg.language.frames.shapes import shape, stairs
from rpg.language.frames.symbols import equation, spelled
from rpg.language.frames.towers import heights_told, shares_told, told_floors, tower
from rpg.language.frames.towers import several as towers

Family = tuple[Sequence[Pattern], Callable[[Sequence[Piece]], str]]
"""The patterns of a family, and how it tells its pieces again (or raises Unclear)."""
FAMILIES: tuple[Family, ...] = (
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
"""Those that are asked first."""
LATER: tuple[Family, ...] = ((told_floors.PATTERNS, told_floors.told),)
"""Families that are asked where no other one knows all that is said."""
LAST: tuple[Family, ...] = (
    (heights_told.PATTERNS, heights_told.told),
    (shares_told.PATTERNS, shares_told.told),
)
"""Those that try all ways to build what is told, where no other one knows it."""
