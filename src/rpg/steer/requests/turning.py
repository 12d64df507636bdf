"""A block that is to be turned another way, "the A upright again": how it was to be turned so far gives way."""

from __future__ import annotations

import re
from collections.abc import Callable

from rpg.blocks.english import describe
from rpg.blocks.english.scene import objects
from rpg.blocks.english.speaker import Speaker
from rpg.core.diagnostics import Diagnostic
from rpg.ir import goal as g
from rpg.ir.edits import SetGoal
from rpg.ir.relations import Facing, Turned
from rpg.ir.schema import TaskSchema
from rpg.ir.walk import conjuncts, rename
from rpg.steer.draft import Draft
from rpg.steer.requests.afresh import by_itself, counterparts

_TURNS = re.compile(r"\b(?:upright|upside|turn\w*|rotat\w*|way up|fac(?:e|es|ing)|head|flip\w*)\b", re.IGNORECASE)


def turned_otherwise(
    draft: Draft, request: str, read: Callable[[str], tuple[TaskSchema | None, tuple[Diagnostic, ...]]]
) -> bool:
    """Whether a request says only how one block, of which the goal says that, is to be turned; if so it is done."""
    parts = conjuncts(draft.schema.goal)
    for part in parts if _TURNS.search(request) else ():
        if not isinstance(part, Facing | Turned):
            continue
        rest = tuple(each for each in parts if each != part)
        known = ". ".join(objects(draft.schema, Speaker(draft.view.world))) + "."
        if rest:
            known = describe(draft.schema.model_copy(update={"goal": g.All(goals=rest) if rest[1:] else rest[0]}))
        schema, _ = read(f"{known} {request[:1].upper()}{by_itself(request)[1:]}")
        names = None if schema is None else counterparts(draft.schema, schema)
        if schema is None or names is None or len(schema.assets) != len(draft.schema.assets):
            continue
        new = [rename(each, names) for each in conjuncts(schema.goal)][len(rest) :]
        if new and all(_turn_of(each, part.block) for each in new):
            goals = (*rest, *new)
            draft.aim("MODIFY")
            draft.do(SetGoal(goal=g.All(goals=goals) if goals[1:] else goals[0]), (0, len(request)))
            draft.note("clause", new[0].kind)
            draft.look_at((part.block,))
            return True
    return False


def _turn_of(part: g.Goal, block: str) -> bool:
    """Whether a condition says of a block how it is turned, or how it must not be."""
    part = part.goal if isinstance(part, g.Not) else part
    return isinstance(part, Facing | Turned) and part.block == block
