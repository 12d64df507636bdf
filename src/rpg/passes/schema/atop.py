"""On top of what: blocks lie on top of blocks, though "on top of it" may be said of a mat where nothing else lies."""

from __future__ import annotations

from collections.abc import Sequence

from rpg.ir.relations import OnPatch
from rpg.ir.schema import TaskSchema
from rpg.ir.walk import atoms
from rpg.language.tokens import Token
from rpg.passes.schema.resolve.things.world import refuse

_THEM = frozenset({"it", "them", "both", "either", "neither", "each", "one", "any", "that", "those", "these"})


def check_atop(words: Sequence[Token], task: TaskSchema) -> None:
    """Refuse "A on the red mat, B on the blue mat, and C on top of one of them" as somewhere on one of the mats."""
    for top, of, what in zip(words, words[1:], words[2:], strict=False):
        if top.word != "top" or of.word != "of" or what.word not in _THEM:
            continue
        here: set[str] = set()
        ahead: set[str] = set()
        for atom in atoms(task.goal):
            if isinstance(atom, OnPatch) and atom.span is not None:
                (here if atom.span[1] >= what.span[1] else ahead).add(atom.patch)
        if here & ahead:
            raise refuse("ambiguous", "on the patch, or on a block that is there?", what.span, "name it")
