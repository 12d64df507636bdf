"""The objects of a task and its initial states in words."""

from __future__ import annotations

import math

from rpg.blocks.english.goals import spoken
from rpg.blocks.english.speaker import Speaker
from rpg.blocks.nouns import join
from rpg.ir.assets import PATCH_SIDE, GoalPatch
from rpg.ir.relations import Stayed
from rpg.ir.schema import TaskSchema


def objects(schema: TaskSchema, say: Speaker) -> list[str]:
    """ "There are two red blocks and a blue block", "There is a long green patch"."""
    listed = (say.some(b.name for b in schema.blocks), [_patch(p) for p in schema.patches])
    counts = (len(schema.blocks), len(schema.patches))
    return [f"There {'are' if n > 1 else 'is'} {join(parts)}" for n, parts in zip(counts, listed, strict=True) if parts]


def _patch(patch: GoalPatch) -> str:
    long, short = max(patch.size), min(patch.size)
    if long >= 2 * short:
        size = "long "
    elif math.isclose(long, short) and not math.isclose(long, PATCH_SIDE):
        size = f"{round(long * 100, 1):g} cm "
    else:
        size = ""
    shape = {"square": "", "rectangle": "" if size == "long " else "rectangular ", "circle": "circular "}[patch.shape]
    article = "an" if (size or shape or patch.color)[0] in "aeio8" else "a"
    return f"{article} {size}{shape}{patch.color} patch"


def starts(schema: TaskSchema, say: Speaker) -> list[str]:
    """Sentences on the initial state, without their full stops; a scattered start goes without saying."""
    found = []
    with say.speaking(""):
        for goal in (part for part in schema.init.arranged if not isinstance(part, Stayed)):
            found.append(f"At the start, {spoken(goal, say)}")
        for heap in schema.init.heaps:
            found.append(f"At the start, {say.the(heap)} lie in a heap")
        for pose in schema.init.poses:
            x, y = pose.position
            found.append(f"At the start, {say.the(pose.block)} is at x = {x:g} m, y = {y:g} m")
    return found
