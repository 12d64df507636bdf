"""Rows, columns and towers told by their order, by what they spell or compute, and cubes that are turned."""

from __future__ import annotations

from random import Random

from tests.corpus.composed import Composed
from tests.corpus.composed.ordering import listed, patterned, ranked, spelled, turned
from tests.corpus.composed.ordering.phrased import said

DRAWN = (
    listed.lists, listed.lists, listed.lists,
    patterned.alternating, patterned.mirrored, patterned.placed, patterned.placed, patterned.spaced,
    ranked.numbers, ranked.numbers, ranked.letters, ranked.kinds, ranked.colors, ranked.sizes,
    spelled.words, spelled.words, spelled.reversed_words, spelled.towers,
    spelled.two_words, spelled.grids, spelled.sums, spelled.sums,
    turned.turns, turned.turns, turned.words,
)  # fmt: skip


def composed(rng: Random) -> Composed:
    """One of them."""
    frame, gaps, meaning = rng.choice(DRAWN)(rng)
    return Composed(frame, said(rng, frame, gaps), meaning)
