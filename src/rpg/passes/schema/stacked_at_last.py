"""What is told of a tower behind several lots: is it of all of them?"""

from __future__ import annotations

import re
from collections.abc import Sequence

from rpg.ir.schema import TaskSchema
from rpg.ir.structures import Stack
from rpg.ir.walk import atoms, names
from rpg.language.tokens import Token
from rpg.passes.schema.resolve.things.world import refuse

_AT_LAST = re.compile(r" , (?P<stacked>stacked(?: up)?|(?:as|in|into|to form|forming) an? (?:tower|stack|pile)) [.;!?]")


def stacked_at_last(words: Sequence[Token], task: TaskSchema) -> None:
    """Refuse "two red on the left and two blue on the right, stacked", "..., as a tower" as the blue ones alone."""
    said = " ".join(["", *(t.word for t in words), "."])
    found = _AT_LAST.search(said)
    at = len(said[: found.start("stacked")].split()) if found else 0
    stacks = [x for x in atoms(task.goal) if isinstance(x, Stack)] if at else []
    placed = {*names(task.goal)} & {block.name for block in task.blocks}
    if len(stacks) == 1 and len(placed) > len(stacks[0].blocks) + 1:
        raise refuse("ambiguous", "are all of these stacked, or those named last?", words[at].span, "use two sentences")
