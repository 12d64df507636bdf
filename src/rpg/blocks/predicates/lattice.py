"""Cells of a square lattice that blocks fill, wherever it lies and however it is turned.

Places are complex numbers, x + iy, so that a lattice is given by one of its points and one step along it.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from functools import cache
from itertools import permutations
from typing import NamedTuple

from rpg.blocks.figures import Ideal

Cells = tuple[tuple[int, int], ...]
EXACT = 1e-6


class Filled(NamedTuple):
    """The cells, in the first of their eight turned and mirrored forms, and the worst distance of a block from its."""

    cells: Cells
    deviation: float


def filled(points: Sequence[complex], pitches: tuple[float, float], limit: float) -> Filled | None:
    """The lattice whose cells are nearest to the points, with neighbours `pitches` apart; None beyond `limit`."""
    best: Filled | None = None
    for here, there in permutations(points, 2):
        step = there - here
        if not pitches[0] - EXACT <= abs(step) <= pitches[1] + EXACT:
            continue
        places = [(point - here) / step for point in points]
        cells = [complex(round(place.real), round(place.imag)) for place in places]
        deviation = abs(step) * max(abs(place - cell) for place, cell in zip(places, cells, strict=True))
        nearer = deviation <= limit and (best is None or deviation < best.deviation - EXACT)
        if nearer and len(set(cells)) == len(cells):
            best = Filled(_canonical(cells), deviation)
    return best


@cache
def cells_of(ideal: Ideal) -> Cells | None:
    """The cells of an ideal figure, where it lies on a lattice."""
    found = filled([complex(cell.x, cell.y) for cell in ideal.cells], (0.0, math.inf), EXACT)
    return found.cells if found is not None else None


def _canonical(cells: Iterable[complex]) -> Cells:
    there = list(cells)
    mirrored = [cell.conjugate() for cell in there]
    return min(_shifted([cell * turn for cell in side]) for side in (there, mirrored) for turn in (1, 1j, -1, -1j))


def _shifted(cells: list[complex]) -> Cells:
    whole = [(round(cell.real), round(cell.imag)) for cell in cells]
    left, low = min(x for x, _ in whole), min(y for _, y in whole)
    return tuple(sorted((x - left, y - low) for x, y in whole))
