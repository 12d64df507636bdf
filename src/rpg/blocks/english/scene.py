"""The objects of a task and its initial states in words."""

from __future__ import annotations

import math
from collections.abc import Iterator

from rpg.blocks.english.goals import spoken
from rpg.blocks.english.speaker import Speaker
from rpg.blocks.nouns import join
from rpg.ir.assets import PATCH_SIDE, GoalPatch
from rpg.ir.relations import Stayed
from rpg.ir.schema import TaskSchema
from rpg.ir.walk import names

MOST = 6
"""Kinds of objects in one sentence."""


def objects(schema: TaskSchema, say: Speaker) -> list[str]:
    """ "There are two red blocks and a blue block", "There is a long green patch", "There is also a distractor"."""
    told = {say.noun(name) for name in _spoken_of(schema)}
    known = [block.name for block in schema.blocks if say.noun(block.name) in told]
    extra = [block.name for block in schema.blocks if say.noun(block.name) not in told]
    found = []
    parts = say.some(known)
    for at in range(0, len(parts), MOST):
        found.append(_there(parts[at : at + MOST], " also" if at else ""))
    found += [_there([_patch(patch) for patch in schema.patches])] if schema.patches else []
    if extra:
        as_what = "as distractors" if len(extra) > 1 else "as a distractor"
        found.append(f"{_there(say.some(extra), ' also')} {as_what}")
    return found


def told_by_goal(schema: TaskSchema) -> bool:
    """Whether what a task asks for tells what there is: no distractors, no patches of unusual sizes or shapes."""
    told = set(_spoken_of(schema))
    plain = all(_patch(patch) in (f"a {patch.color} patch", f"an {patch.color} patch") for patch in schema.patches)
    return plain and all(asset.name in told for asset in schema.assets)


def _there(parts: list[str], also: str = "") -> str:
    verb = "is" if len(parts) == 1 and parts[0].startswith(("a ", "an ")) else "are"
    return f"There {verb}{also} {join(parts)}"


def _spoken_of(schema: TaskSchema) -> Iterator[str]:
    """What the goal or the start names."""
    for goal in (schema.goal, *schema.init.arranged):
        yield from names(goal)
    for heap in schema.init.heaps:
        yield from heap
    yield from (pose.block for pose in schema.init.poses)


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
    with say.speaking(""), say.strictly():
        for goal in (part for part in schema.init.arranged if not isinstance(part, Stayed)):
            found.append(f"At the start, {spoken(goal, say)}")
        for heap in schema.init.heaps:
            found.append(f"At the start, {say.the(heap)} lie in a heap")
        for pose in schema.init.poses:
            x, y = pose.position
            found.append(f"At the start, {say.the(pose.block)} is at x = {x:g} m, y = {y:g} m")
    return found
