"""Blocks in each of the four corners of the table."""

from __future__ import annotations

from rpg.core.diagnostics import Span
from rpg.ir import relations as r
from rpg.language.meaning import In
from rpg.passes.schema.resolve.logic import Atoms
from rpg.passes.schema.resolve.patches import indefinite, one_lot_each
from rpg.passes.schema.resolve.things import alike
from rpg.passes.schema.resolve.world import Ref, Scene, refuse

CORNERS = ("far_left_corner", "far_right_corner", "near_left_corner", "near_right_corner")


def corners(theme: Ref, meaning: In, scene: Scene, span: Span) -> Atoms:
    """ "a red block in each corner": as many again for every corner; "four blocks in the four corners": one in each."""
    names = theme.names
    if theme.quant is not None or theme.op != "and" or theme.built or theme.patch or meaning.negated or not names:
        raise refuse("ambiguous", "it is not clear which blocks go into the corners", span, "say what each corner gets")
    if meaning.region.endswith("?") and (scene.built or any(t.patch for t in scene.things.values())):
        raise refuse("ambiguous", "it is not clear of what these are the corners", meaning.span, "say 'of the table'")
    if len(names) == len(CORNERS):
        things = [scene.things[n] for n in names]
        if all(t.color is None and t.label is None and t.kind is None for t in things):
            for thing in things:
                thing.scheme = thing.scheme or "same"
        elif not alike(things):
            raise refuse("ambiguous", "it is not said which block goes into which corner", span, "name each corner")
        lots: list[tuple[str, ...]] = [(n,) for n in names]
    elif indefinite(theme):
        lots = one_lot_each(theme, len(CORNERS), scene)
    else:
        raise refuse("count-mismatch", f"{len(names)} blocks cannot be in each of four corners", span,
                     "name four blocks, or say 'a red block in each corner'")  # fmt: skip
    return [r.InRegion(a=lot, region=where, span=span) for lot, where in zip(lots, CORNERS, strict=True)]  # type: ignore[arg-type]
