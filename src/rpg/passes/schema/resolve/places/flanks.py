"""Blocks on two sides of another one."""

from __future__ import annotations

from rpg.core.diagnostics import Span
from rpg.ir import goal as g
from rpg.ir import relations as r
from rpg.language.meaning import Loc
from rpg.passes.schema.resolve.goals.logic import conj, disj
from rpg.passes.schema.resolve.places.lots import one_lot_each
from rpg.passes.schema.resolve.places.patches import indefinite
from rpg.passes.schema.resolve.things.operands import foot
from rpg.passes.schema.resolve.things.things import alike
from rpg.passes.schema.resolve.things.world import Ref, Scene, refuse

_LINES = ("row", "line", "word", "equation")
"""Their sides are their two ends."""
_OPPOSITE = {"across": (r.LeftOf, r.RightOf), "deep": (r.InFrontOf, r.Behind)}


def flanked(theme: Ref, mark: Ref, loc: Loc, scene: Scene, span: Span) -> g.Goal:
    """ "a white block on either side of the red one": two of them, with the red one between; "on its left and right":
    one on each of these."""
    names = theme.names
    if loc.negated or scene.denying or theme.quant is not None or theme.op != "and" or theme.built or theme.patch:
        raise refuse("ambiguous", "it is not clear on which side this is", loc.span, "say it of each side")
    several = len(mark.names) > 1 and not mark.built
    if mark.quant is not None or mark.op != "and" or several or set(names) & {*mark.names}:
        raise refuse("ambiguous", "it is not clear of what these are the sides", loc.span, "name one block")
    named = len(names) == 2 and not alike([scene.things[name] for name in names])  # "C and D"
    told = "one" in loc.mods or len(theme.parts) == len(names) or named
    in_line = bool(mark.built) and all(built.kind in _LINES for built in mark.built)
    if "each" in loc.mods and not told and not in_line:
        raise refuse("ambiguous", "two opposite sides, or all four?", loc.span,
                     "say 'on its left and right', or 'on all four sides'")  # fmt: skip
    fresh = indefinite(theme) and (theme.det == "a" or not _OPPOSITE.keys() & set(loc.mods))
    single = len(names) == 1 and fresh and scene.things[names[0]].label is None
    if single and "one" not in loc.mods:
        names = tuple(n for lot in one_lot_each(theme, 2, scene) for n in lot)
    elif len(names) != 2 or not (told or theme.det == "the"):
        raise refuse("ambiguous", "it is not clear how many blocks are on which side", loc.span,
                     "say 'one on either side'")  # fmt: skip
    one, other = ((name,) for name in names)
    hub = foot(mark)
    if not (way := next((_OPPOSITE[mod] for mod in loc.mods if mod in _OPPOSITE), None)):
        return r.Between(a=hub, b=one, c=other, span=span)
    if len(theme.names) == 1:
        return conj([way[0](a=one, b=hub, span=span), way[1](a=other, b=hub, span=span)], span)
    return conj([disj([side(a=a, b=hub, span=span) for a in (one, other)], span) for side in way], span)
