"""Blocks that are each in another corner of the table, whichever corners these are."""

from __future__ import annotations

from itertools import permutations

from rpg.core.diagnostics import Span
from rpg.ir import goal as g
from rpg.ir import relations as r
from rpg.ir.node import EACH
from rpg.language.meaning import In
from rpg.passes.schema.resolve.goals.logic import Atoms, conj, disj
from rpg.passes.schema.resolve.things.world import Ref, Scene, refuse

CORNERS: tuple[r.Region, ...] = ("far_left_corner", "far_right_corner", "near_left_corner", "near_right_corner")


def different_corners(theme: Ref, meaning: In, scene: Scene, span: Span) -> Atoms:
    """ "Red and blue in different corners": no two in one; of two lots, each of them together in one."""
    units = [part.names for part in theme.parts] or [(name,) for name in theme.names]
    plain = theme.quant is None and theme.op == "and" and not (meaning.negated or scene.denying or theme.built)
    if meaning.region == "different_corner":  # of one it is: than which? of two: of which two corners?
        plain = plain and theme.each and len(units) > 2
    single = all(len(unit) == 1 for unit in units)
    if not plain or not 1 < len(units) <= (len(CORNERS) if single else 2):
        raise refuse("ambiguous", "it is not clear which blocks are in which corner", span, "say what each corner has")
    if single:
        names = tuple(name for (name,) in units)
        return [r.InRegion(a=names, region="corner", span=span), *(_one_at_most(names, at, span) for at in CORNERS)]
    ways = [
        conj([r.InRegion(a=unit, region=at, span=span) for unit, at in zip(units, there, strict=True)], span)
        for there in permutations(CORNERS, len(units))
    ]
    return [disj(ways, span)]


def _one_at_most(names: tuple[str, ...], where: r.Region, span: Span) -> g.Goal:
    there = r.InRegion(a=(EACH,), region=where, span=span)
    return g.Count(over=names, at_least=0, at_most=1, goal=there, span=span)
