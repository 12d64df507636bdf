"""Blocks that are not to be part of what is built: "the two red ones must not be in the row"."""

from __future__ import annotations

from rpg.ir import goal as g
from rpg.ir import structures as s
from rpg.language.meaning import Clause, Structure
from rpg.passes.schema.resolve.clauses.spec import Spec
from rpg.passes.schema.resolve.things.refer import refer
from rpg.passes.schema.resolve.things.world import Scene, Scope

_LINES = ("row", "line", "column", "stack")


def out_of_line(clause: Clause, spec: Spec, scene: Scene, scope: Scope) -> list[g.Goal] | None:
    """That each of the blocks goes on with the line that was built, which the clause denies; None where it does not
    speak of that line."""
    shape = spec.intos[0].structure if len(spec.intos) == 1 else None
    if not clause.negated or clause.theme is None or isinstance(clause.theme, Structure):
        return None
    if not isinstance(shape, Structure) or shape.det != "the" or shape.members is not None:
        return None
    lines = [built for built in scene.built if built.kind == shape.kind in _LINES]
    theme = refer(clause.theme, scene, scope) if len(lines) == 1 else None
    if theme is None or not theme.names or theme.quant is not None or {*theme.names} & {*lines[0].members}:
        return None
    spec.intos = []
    members, line = lines[0].members, s.Stack if shape.kind == "stack" else s.Row
    return [line(blocks=(*members, name), span=clause.span) for name in theme.names]
