"""Relations of blocks to each other: "next to each other", "5 cm apart"."""

from __future__ import annotations

from dataclasses import replace
from itertools import combinations
from typing import Any

from rpg.core.diagnostics import Span
from rpg.ir import goal as g
from rpg.ir import relations as r
from rpg.ir import structures as s
from rpg.ir.node import Operand
from rpg.passes.schema.meaning import Loc
from rpg.passes.schema.resolve.logic import Atoms, negation
from rpg.passes.schema.resolve.operands import LEVEL, foot, measure
from rpg.passes.schema.resolve.world import Ref, refuse


def reciprocal(theme: Ref, loc: Loc, span: Span) -> Atoms:
    """ "next to each other", "5 cm apart", "on top of each other"."""
    names = theme.names
    if theme.patch:
        raise refuse("fixed-patch", "patches are marks on the table and cannot be moved", span, "move blocks instead")
    if (
        theme.quant is not None
        and theme.quant.high == 0
        and len(names) > 1
        and loc.rel in ("on", "above", "heaped", "under")
    ):
        return [g.Not(goal=r.Above(a=(a,), b=(b,), span=span), span=span) for a in names for b in names if a != b]
    if theme.quant is not None and theme.quant.high == 0 and len(names) > 1:
        inside = [replace(theme, names=pair, quant=None, built=(), parts=()) for pair in combinations(names, 2)]
        return negation([x for two in inside for x in reciprocal(two, loc, span)], span)
    if len(names) < 2:
        raise refuse("no-referent", "one block alone has no other to relate to", loc.span, "name at least two blocks")
    pairs = list(combinations(names, 2))
    units: list[Operand] = [(n,) for n in names]
    if len(theme.built) > 1:
        units = [foot(Ref(names=b.members, built=(b,))) for b in theme.built]
    elif len(theme.parts) > 1 and any(len(p.names) > 1 for p in theme.parts):
        units = [foot(p) for p in theme.parts]
    two = list(combinations(units, 2))
    match loc.rel:
        case "near" | "apart":
            node = LEVEL[loc.rel]
            return [node(a=a, b=b, span=span) for a, b in two]
        case "distance" if len(units) > 2:
            low, high = loc.low, loc.high
            if high is None:
                return [
                    r.Distance(a=a, b=b, minimum=low, maximum=high, measure=measure(loc), span=span) for a, b in two
                ]
            if low is None:
                return [
                    r.Distance(a=a, b=b, minimum=low, maximum=high, measure=measure(loc), span=span) for a, b in two
                ]
            middle = round((low + high) / 2, 6)
            spaced: dict[str, Any] = {
                "gap" if loc.measure == "faces" else "spacing": middle,
                "tolerance": round((high - low) / 2, 6),
            }
            return [s.Row(blocks=names, span=span, **spaced)]
        case "distance":
            return [
                r.Distance(a=a, b=b, minimum=loc.low, maximum=loc.high, measure=measure(loc), span=span) for a, b in two
            ]
        case "side_by_side" | "beside" if len(units) == 2:
            return [r.Beside(a=two[0][0], b=two[0][1], span=span)]
        case "side_by_side" | "beside":
            return [s.Row(blocks=names, gap_edges=1.0, span=span)]
        case "adjacent" if len(units) == 2:
            return [r.Adjacent(a=two[0][0], b=two[0][1], span=span)]
        case "adjacent":
            return [s.Row(blocks=names, gap_edges=0.5, span=span)]
        case "touching" if len(units) == 2:
            return [r.Touching(a=two[0][0], b=two[0][1], span=span)]
        case "touching":
            return [s.GroupBy(groups=(names,), inner_edges=0.05, span=span)]
        case "together":
            return [s.GroupBy(groups=(names,), span=span)]
        case "one_behind":
            return [s.Row(blocks=names, axis="x", span=span)]
        case "off":
            return [
                g.Not(goal=r.Above(a=(a,), b=(b,), span=span), span=span)
                for a, b in [*pairs, *[(b, a) for a, b in pairs]]
            ]
        case _:
            raise refuse("misplaced", "this relation does not go with 'each other'", loc.span)
