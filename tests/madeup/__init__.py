"""Sentences made up by chance, each with states that it must and must not admit: `python -m tests.madeup SEED COUNT`.

A scene is drawn first, and told in one of many ways; its near misses have one thing in another place. What is read
wrong is a silent misreading; what is refused is none.
"""

from __future__ import annotations

from collections.abc import Iterator
from random import Random

from tests.madeup.chance import Chance
from tests.madeup.kinds import KINDS
from tests.madeup.quantities import QUANTITIES
from tests.madeup.relations import related
from tests.madeup.scenes import MadeUp

__all__ = ["made_up"]


def made_up(seed: int, count: int) -> Iterator[MadeUp]:
    """So many sentences: most place things to each other, the others are of one kind each."""
    rng = Random(seed)
    made = 0
    while made < count:
        chance = Chance(rng)
        sentence = related(chance) if chance.often(0.6) else chance.of(*KINDS, *QUANTITIES)(chance)
        if sentence is not None:
            made += 1
            yield sentence
