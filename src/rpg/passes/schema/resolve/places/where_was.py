""" "Put green where red was": a block takes the place that another had when the episode began."""

from __future__ import annotations

from rpg.core.diagnostics import Span
from rpg.ir import goal as g
from rpg.ir import relations as r
from rpg.language.meaning import Loc
from rpg.passes.schema.resolve.things.refer import refer
from rpg.passes.schema.resolve.things.world import Ref, Scene, Scope, refuse


def took_place(theme: Ref, loc: Loc, scene: Scene, scope: Scope, span: Span) -> list[g.Goal]:
    """The goal that says so; as many must move as there were."""
    mark = refer(loc.landmark, scene, Scope(role="landmark", rel=loc.rel)) if loc.landmark else Ref()
    plain = theme.quant is None and mark.quant is None and "and" == theme.op == mark.op and not mark.table
    if not plain or scope.start or scene.denying or loc.negated:
        raise refuse("misplaced", "this place is told by where a block was at the start, and fits here no block",
                     loc.span, "say it as in 'put the green block where the red block was'")  # fmt: skip
    if len(theme.names) != len(mark.names) or not theme.names:
        raise refuse("count-mismatch", "there are not as many blocks as places", loc.span, "name as many of both")
    if set(theme.names) & set(mark.names):
        raise refuse("self-reference", "a block takes the place of another one", loc.span, "name another block")
    return [r.TookPlace(a=theme.names, b=mark.names, span=span)]
