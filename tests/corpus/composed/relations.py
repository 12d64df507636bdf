"""Where blocks stand to each other and to patches, alone and composed."""

from __future__ import annotations

from random import Random

from tests.corpus.composed import Composed

COLORS = ("red", "orange", "yellow", "green", "cyan", "blue", "purple", "pink", "brown", "black", "gray", "white")
BLOCK = ("block", "cube", "one", "brick")
_FRAMES = (
    "put {a} on {b}",
    "{a} has to be on {b}",
    "I want {a} on top of {b}",
)


def composed(rng: Random) -> Composed:
    """One block on another."""
    a, b = rng.sample(COLORS, 2)
    frame = rng.choice(_FRAMES)
    text = frame.format(a=f"the {a} {rng.choice(BLOCK[:2])}", b=f"the {b} {rng.choice(BLOCK)}")
    return Composed(frame, text, {"assets": {a: 1, b: 1}, "hold": [f"{b}^{a}"], "miss": [f"{a}^{b}", f"{a} {b}"]})
