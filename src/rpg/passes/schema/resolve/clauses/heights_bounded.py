"""How high blocks may be stacked: with so many on any of them, no stack is higher."""

from __future__ import annotations

from rpg.ir import goal as g
from rpg.ir import relations as r
from rpg.ir.node import EACH
from rpg.language.meaning import Clause, Traits
from rpg.passes.schema.resolve.clauses.spec import Spec
from rpg.passes.schema.resolve.things.refer import refer
from rpg.passes.schema.resolve.things.world import Scene, Scope, refuse


def bounded_heights(clause: Clause, spec: Spec, scene: Scene, scope: Scope) -> list[g.Goal]:
    """At most so many of the others are above each of the blocks."""
    (most,), spec.sizes = [*spec.sizes], []
    assert clause.theme is not None and most.amount is not None and most.amount.high is not None
    blocks, high = refer(clause.theme, scene, scope), most.amount.high
    if blocks.patch or clause.negated or scope.start or scene.built:
        raise refuse("misplaced", "this is said of loose blocks alone", clause.span, "say how high each tower is to be")
    if len(blocks.names) <= high:
        raise refuse("misplaced", "there are no more blocks than that", clause.span, "leave it out, or say how many "
                     "blocks there are")  # fmt: skip
    if getattr(clause.theme, "word", "") == "everything":
        scene.surveyed.append((Traits(), blocks.names, clause.span))
    if high == 1:
        return [r.OnTable(a=blocks.names, span=clause.span)]
    goals: list[g.Goal] = []
    for name in blocks.names:
        others = tuple(other for other in blocks.names if other != name)
        above = r.Above(a=(EACH,), b=(name,), span=clause.span)
        goals.append(g.Count(over=others, at_most=high - 1, goal=above, span=clause.span))
    return goals
