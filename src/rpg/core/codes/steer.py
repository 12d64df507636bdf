"""Codes reported while a request is turned into an edit of a task."""

from __future__ import annotations

from rpg.core.codes.base import Code

CODES: tuple[Code, ...] = (
    Code(
        "edit-unclear",
        "the request is not understood",
        "No reading of the request gives an edit of this task: it has words that mean nothing here, leaves open which "
        "block or place is meant, or fits neither the task nor an instruction of its own. Nothing has changed.",
        'rpg steer red-on-blue "make it nicer"',
        'rpg steer red-on-blue "make the red block green"',
    ),
    Code(
        "no-such-object",
        "the task has no such block",
        "A request speaks of a block, a patch or a structure that the version does not have. Definite words (the red "
        "one) pick something that is there; to bring in something new, say a red block.",
        'rpg steer red-on-blue "remove the purple one"',
        'rpg steer red-on-blue "remove the red one and add a purple block beside the blue one"',
    ),
    Code(
        "ambiguous-object",
        "several blocks could be meant",
        "A request speaks of one block where the version has several that fit, or of another number of blocks than "
        "there are.",
        'rpg steer three-reds "make the red block green"',
        'rpg steer three-reds "make the top block green"',
    ),
    Code(
        "no-such-version",
        "no version fits the reference",
        "A request goes back to a version that the family does not have: a number that was not given out, more steps "
        "than there are, or a description that none of the versions fits.",
        'rpg steer red-on-blue "go back to version 7"',
        'rpg steer red-on-blue "go back to version 0 and add a green block on top"',
    ),
    Code(
        "nothing-to-do",
        "the request changes nothing",
        "The task is already as the request wants it, or the goal does not tell the blocks apart that are to change "
        "places.",
        'rpg steer red-on-blue "make the red block red"',
        'rpg steer red-on-blue "make the red block green"',
    ),
    Code(
        "breaks-structure",
        "the structure has no place for this",
        "A figure of a fixed number of blocks cannot lose or gain one, and blocks can only form a figure that takes as "
        "many as there are.",
        'rpg steer square "remove one of the red blocks"',
        'rpg steer square "make it 2x2"',
    ),
)
