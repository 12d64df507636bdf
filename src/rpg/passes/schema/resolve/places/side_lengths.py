"""How large an outline is, told by its side or by how wide it is: a distance between neighbours in it."""

from __future__ import annotations

import math

from rpg.ir import structures as s
from rpg.ir.assets import EDGE
from rpg.language.meaning import Loc
from rpg.passes.schema.resolve.things.world import Ref, Scene, refuse

MEASURES = frozenset({"side", "across", "radius"})
_SIDES = {"square": 4, "triangle": 3}


def so_large(theme: Ref, told: Loc, scene: Scene) -> s.Row:
    """The distance between the centres of neighbours, for `spaced` to tell of the figure."""
    kind = theme.built[0].kind if len(theme.built) == 1 else ""
    if kind == "circle":
        raise refuse("misplaced", "how wide a circle is cannot be asked for, only how far neighbors are apart in it",
                     told.span, f"say 'with gaps of {_gap(len(theme.names), told):g} cm'")  # fmt: skip
    sides = _SIDES.get(kind, 0)
    if not sides or told.negated or told.measure == "radius" or (told.measure == "across" and kind != "square"):
        raise refuse("misplaced", "nothing here has a side or a width of that length", told.span,
                     "say how far the blocks are from each other")  # fmt: skip
    if told.low is None or told.high is None or len(theme.names) % sides:
        raise refuse("misplaced", "this does not tell how far the blocks are from each other", told.span,
                     "name one length, as in 'with sides of 20 cm'")  # fmt: skip
    share = sides / len(theme.names)
    scene.assume(f"how large the {kind} is goes by the centres of its blocks")
    middle, slack = (told.low + told.high) / 2, (told.high - told.low) / 2
    return s.Row(blocks=theme.names, spacing=round(share * middle, 6), tolerance=round(max(0.005, share * slack), 6),
                 span=told.span)  # fmt: skip


def _gap(count: int, told: Loc) -> float:
    """The gap (in whole cm) between neighbours in a circle that is so large."""
    width = ((told.low or 0.0) + (told.high or told.low or 0.0)) / 2 * (2 if told.measure == "radius" else 1)
    return max(1.0, round(100 * (width * math.sin(math.pi / count) - EDGE)))
