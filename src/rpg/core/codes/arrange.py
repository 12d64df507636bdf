"""Codes reported when no arrangement of the blocks satisfies a goal."""

from __future__ import annotations

from rpg.core.codes.base import Code

CODES: tuple[Code, ...] = (
    Code(
        id="goal-contradiction",
        title="conditions that cannot hold together",
        explanation="No arrangement satisfies these conditions, though one does without any single one of them. "
        "Directions that run in a ring are proved to clash; other clashes are found by a bounded search.",
        example="put the red block next to the blue block and more than 20 cm away from the blue block",
        remedy="put the red block next to the blue block and more than 8 cm away from the blue block",
    ),
    Code(
        id="support-cycle",
        title="blocks that rest on each other in a ring",
        explanation="Each of these blocks must rest on the next, and the last one on the first, so that none of them "
        "reaches the table.",
        example="put the red block on the blue block and the blue block on the red block",
        remedy="put the red block on the blue block and the blue block on the green block",
    ),
    Code(
        id="does-not-fit",
        title="more than the workspace has room for",
        explanation="Centres of blocks stay within 30 cm from front to back and 50 cm from left to right. What is "
        "asked for is longer than that even with blocks close together; the lengths are given.",
        example="put thirteen red blocks in a row from left to right",
        remedy="put ten red blocks in a row from left to right",
    ),
    Code(
        id="patches-no-room",
        title="more patches than the table has room for",
        explanation="Patches lie side by side, at least 2 cm apart, and grow with what must lie on them; these have no "
        "room within the workspace.",
        example="put a red block on each of twelve patches",
        remedy="put a red block on each of three patches",
    ),
    Code(
        id="too-many-namings",
        title="too many look-alike blocks with different duties",
        explanation="A goal holds if it does for some choice of which of several blocks that look alike is which. "
        "More than 5,000 such choices are not searched.",
        example="put a red block on each of the letters A, B, C, D, E, F, G and H",
        remedy="put a red block on each of the letters A, B and C",
    ),
)
