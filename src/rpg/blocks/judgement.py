"""What is known about an episode after a control step."""

from __future__ import annotations

from typing import NamedTuple

from rpg.blocks.verdict import Verdict


class Judgement(NamedTuple):
    """`success` now; `failed`: the episode is lost for good; `stage`: stages met so far, of all sequences together.

    `conditions`: what the goal asks for, piece by piece, under the naming of look-alikes that comes closest.
    """

    success: Verdict
    failed: bool
    stage: int
    conditions: tuple[tuple[str, Verdict], ...]
