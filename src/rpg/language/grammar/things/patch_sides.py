"""Patches by where they lie beside others: "the left mat", "the far patch", and then "the right one"."""

from __future__ import annotations

from typing import Any

from rpg.language import lexicon
from rpg.language.grammar.core import Parser, Results, choice

_SIDES = {
    "left": "@left", "leftmost": "@left", "right": "@right", "rightmost": "@right", "near": "@front",
    "nearer": "@front", "front": "@front", "far": "@back", "farther": "@back", "back": "@back", "rear": "@back",
    "middle": "@middle", "center": "@middle", "central": "@middle",
}  # fmt: skip
_BEHIND = {
    f"{at} the {side}": f"@{way}"
    for at in ("on", "to", "at", "in")
    for side, way in (("left", "left"), ("right", "right"), ("front", "front"), ("back", "back"), ("middle", "middle"))
}
_NO_SIDE = frozenset({"of", "half", "side", "corner", "edge", "hand", "left", "right", "end"})
"""What follows a part of the table, or a place beside something else."""
_A_BLOCK = frozenset({"one", "block", "cube", "brick"})
"""What is told by a corner of the grid that it is part of."""
_TABLE = frozenset({"of", "on", "in"})


@choice
def patch_side(p: Parser, i: int) -> Results[dict[str, Any]]:
    """What tells a patch from others of the same look; resolution knows which it is."""
    side = p.peek(i, _SIDES)
    if not side:
        return
    if (side in ("@front", "@back")) and p.stands(i + 1, ("left", "right")) and p.stands(i + 2, _A_BLOCK):
        yield {"rank": f"{side[1:]} {p.words[i + 1]}"}, i + 2
    j = p.opt(p.reach(i + 1), "hand")
    named = p.stands(j, lexicon.PATCH) and not (p.stands(j, ("area", "spot")) and p.stands(j + 1, _TABLE))
    if named or (p.stands(j, ("one",)) and not p.words[i].endswith("most")):
        yield {"rank": side}, j


def side_behind(p: Parser, j: int) -> Results[dict[str, Any]]:
    """ "(the mat) on the left"."""
    for phrase, k in p.standing(j, _BEHIND):
        if not p.stands(k, _NO_SIDE):
            yield {"rank": _BEHIND[phrase]}, k
