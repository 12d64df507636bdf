"""What each atom of the goal language means: `PREDICATES` maps its kind to its predicate.

Each file defines a family and exposes it as `TABLE`.
"""

from __future__ import annotations

from typing import Any

from rpg.blocks.predicate import Predicate
from rpg.blocks.predicates import (
    between,
    cells,
    change,
    compared,
    direction,
    facing,
    group,
    patches,
    proximity,
    region,
    row,
    shifted,
    stack,
    towers,
    vertical,
    words,
)

FAMILIES = (
    vertical,
    direction,
    proximity,
    between,
    compared,
    patches,
    region,
    facing,
    change,
    shifted,
    stack,
    towers,
    row,
    words,
    cells,
    group,
)

PREDICATES: dict[str, Predicate[Any]] = {kind: p for family in FAMILIES for kind, p in family.TABLE.items()}
