"""Sizes that are named of blocks, "three big red blocks", must be those of some of the task's."""

from __future__ import annotations

from collections.abc import Sequence

from rpg.ir.schema import TaskSchema
from rpg.language import lexicon
from rpg.language.lexicon import MEDIUM_EDGE
from rpg.language.tokens import Token
from rpg.passes.schema.patience import LOST
from rpg.passes.schema.resolve.things.world import refuse

_MOST = 3
"""So many words at most stand between a size and the blocks that have it."""
_BLOCKS = lexicon.BLOCK.keys() - {"letter", "letters", "digit", "digits", "number", "numbers"}


def check_sizes(words: Sequence[Token], task: TaskSchema) -> None:
    """Refuse a task in which no block has a size that is named."""
    edges = {block.size for block in task.blocks}
    for index, token in enumerate(words):
        size = lexicon.SIZE.get(token.word)
        if size in ("big", "small") and _of_blocks(words[index + 1 : index + 2 + _MOST]):
            had = any(edge > MEDIUM_EDGE if size == "big" else edge < MEDIUM_EDGE for edge in edges)
            if not had:
                raise refuse(
                    "misplaced", f"{LOST} of {token.raw!r}", token.span, "say this part in a sentence of its own"
                )


def _of_blocks(behind: Sequence[Token]) -> bool:
    """Whether blocks follow, with nothing but colours, sizes and a comma between."""
    for token in behind:
        if token.word in _BLOCKS:
            return True
        if not (token.word in lexicon.COLOR or token.word in lexicon.SIZE or token.word == ","):
            return False
    return False
