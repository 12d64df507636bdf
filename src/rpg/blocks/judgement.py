"""What is known about an episode after a control step."""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

from rpg.blocks.verdict import Verdict

Conditions = tuple[tuple[str, Verdict], ...]
"""Pieces of a goal in words, each with its verdict."""


class Judgement(NamedTuple):
    """`success` now; `failed`: the episode is lost for good; `stage`: stages met so far, of all sequences together;
    `told` says what the goal asks for, which is put into words only where somebody reads it."""

    success: Verdict
    failed: bool
    stage: int
    told: Callable[[], Conditions]

    @property
    def conditions(self) -> Conditions:
        """What the goal asks for, piece by piece, under the naming of look-alikes that comes closest."""
        return self.told()
