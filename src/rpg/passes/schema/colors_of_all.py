"""Colours told of all, and yet not said of some: "a tower of three blocks and one of two blocks, both blue"."""

from __future__ import annotations

import re
from collections.abc import Sequence

from rpg.ir.schema import COLORS_UNSAID, TaskSchema
from rpg.language.grammar.rows.vocabulary import COLOR, CUBE, PATCH, PATCHES
from rpg.language.tokens import Token
from rpg.passes.schema.resolve.things.world import refuse

_OF_ALL = re.compile(
    r"(?:^|, |[.;] )(?:both|all|each|everything|every one|all blocks|all the blocks)(?: of (?:them|these|it))?"
    rf"(?: (?:in|are|is|should be|must be))? {COLOR}(?= ?[.;!?]|$)"
)

_WITH_PATCH = re.compile(
    f"\\b(?:{CUBE}s? and \\w+ (?:{PATCH}|{PATCHES})|(?:{PATCH}|{PATCHES}) and \\w+ {CUBE}s?) , (?:both|all|each) "
    f"(?:of them )?(?:in )?{COLOR}\\b"
)
"""Blocks and patches that are listed together: "three blocks and a mat, all blue"."""


def check_colors_of_all(tokens: Sequence[Token], task: TaskSchema) -> None:
    """Refuse a task with blocks of colours that are not said, where it is told of all what colour they have.

    Raises:
        Refusal: "ambiguous", where the colour was taken for that of some.
    """
    unsaid = any(note.startswith((COLORS_UNSAID, "the colours are not said")) for note in task.assumptions)
    patch = task.assumed("the colour of the patch is not said")
    text = " ".join(token.word for token in tokens) if unsaid or patch else ""
    if (unsaid and _OF_ALL.search(text)) or (patch and _WITH_PATCH.search(text)):
        raise refuse("ambiguous", "it is not clear of which blocks this colour is told",
                     (tokens[0].span[0], tokens[-1].span[1]), "name the colour with each of them")  # fmt: skip
