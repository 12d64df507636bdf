"""Figures told by their size and their direction, all of one colour."""

from __future__ import annotations

from random import Random

from tests.corpus.composed import Composed
from tests.corpus.composed.building import letters, plain
from tests.corpus.composed.ordering.phrased import said

DRAWN = (
    plain.wall, plain.big_cube, plain.flat_pyramid, plain.squared_pyramid, plain.staircase, plain.grid, plain.square,
    letters.ell, letters.pointed, letters.plus,
)  # fmt: skip


def composed(rng: Random) -> Composed:
    """One of them."""
    frame, gaps, meaning = rng.choice(DRAWN)(rng)
    return Composed(frame, said(rng, frame, gaps), meaning)
