"""Between what of two blocks a distance is measured: "their centers", "the faces of the blocks"."""

from __future__ import annotations

from rpg.language.grammar.core import Parser, Results, choice

_THEIRS_ARE = {"faces": "faces", "sides": "faces", "centers": "centres", "middles": "centres"}
_THEIRS = {f"{whose}{ends}": measure for whose in ("", "the ", "their ") for ends, measure in _THEIRS_ARE.items()}


@choice
def their_ends(p: Parser, i: int) -> Results[str]:
    """ "their centers", "the faces of the blocks": between what a distance is measured, as the subject of a clause."""
    for phrase, j in p.standing(i, _THEIRS):
        yield _THEIRS[phrase], p.any_of(j, ("of the blocks", "of the two", "of the two blocks", "of the cubes")) or j
