"""Between what of two blocks a distance is measured: "their centers", "the faces of the blocks"."""

from __future__ import annotations

from rpg.language.grammar.core import Parser, Results, choice
from rpg.language.grammar.talk.slots import Patterns

_THEIRS_ARE = {"faces": "faces", "sides": "faces", "centers": "centres", "middles": "centres"}
_OF_THEM = Patterns(
    "of the|both two? blocks|cubes|boxes|bricks?", "that|which look|point at|towards|toward each_other|one_another",
    "that|which face|meet each_other|one_another", "facing|looking_at each_other|one_another",
)  # fmt: skip
_THEIRS = {f"{whose}{ends}": measure for whose in ("", "the ", "their ") for ends, measure in _THEIRS_ARE.items()}


@choice
def their_ends(p: Parser, i: int) -> Results[str]:
    """ "their centers", "the faces of the blocks": between what a distance is measured, as the subject of a clause."""
    for phrase, j in p.standing(i, _THEIRS):
        yield _THEIRS[phrase], max(_OF_THEM.matches(p, j), default=j)
