"""Codes reported while initial states are sampled."""

from __future__ import annotations

from rpg.core.codes.base import Code

CODES: tuple[Code, ...] = (
    Code(
        id="start-solves-goal",
        title="nearly every start satisfies the goal",
        explanation="Starts are drawn again until the goal does not hold yet and no stage of it is met; where nearly "
        "every start is already past that point, there is nothing left to do in the task. Where an instruction only "
        "says what must not be and nothing of the start, what it denies is so at the start.",
        example="put the red block on the table",
        remedy="put the red block on the blue block",
    ),
    Code(
        id="start-no-room",
        title="the blocks do not fit on the table",
        explanation="The blocks of a start are kept apart from each other and from the patches; these leave no room "
        "for all of them within the workspace.",
        example="put the red block on the blue block. there are 25 distractor blocks of 10 cm",
        remedy="put the red block on the blue block. there are 5 distractor blocks of 5 cm",
    ),
    Code(
        id="start-unstable",
        title="a start does not come to rest",
        explanation="A start settles before the episode begins; this one still moved after five seconds, or left the "
        "workspace, each time it was drawn.",
    ),
)
