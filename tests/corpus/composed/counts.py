"""How many and which: stocks told in every form, quantities on patches and in towers, groups, halves, distractors."""

from __future__ import annotations

from random import Random

from tests.corpus.composed import Composed
from tests.corpus.composed.counting import grouped, patched, towered
from tests.corpus.composed.counting.phrasing import sentence, written

KINDS = (*patched.KINDS, *towered.KINDS, *grouped.KINDS)


def composed(rng: Random) -> Composed:
    """A wish of some kind, in one of its forms."""
    wish = rng.choice(KINDS)(rng)
    frame, text = sentence(rng, wish)
    return Composed(frame, written(rng, text), wish.meaning)
