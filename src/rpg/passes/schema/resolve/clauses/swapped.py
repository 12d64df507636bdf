""" "Swap the red and the blue block": each stands where the other began."""

from __future__ import annotations

from rpg.ir import goal as g
from rpg.ir import relations as r
from rpg.language.meaning import Clause, Loc, Meaning, Structure, replace
from rpg.passes.schema.resolve.clauses.spec import Spec
from rpg.passes.schema.resolve.things.refer import refer
from rpg.passes.schema.resolve.things.things import Premise
from rpg.passes.schema.resolve.things.world import Ref, Scene, Scope, refuse


def swap(clause: Clause, spec: Spec, scene: Scene, scope: Scope) -> list[g.Goal]:
    """ "swap the red and the blue block", "swap A with B"."""
    told = len(scene.premises)
    theme = refer(clause.theme, scene, scope) if clause.theme else Ref()
    parts: tuple[Ref, ...] = theme.parts
    if spec.usings:
        other = refer(spec.usings.pop(0).members, scene, replace(scope, role="landmark"))
        parts = (theme, other)
    elif len(theme.names) == 2 and not isinstance(clause.theme, Structure):
        parts = tuple(Ref(names=(n,)) for n in theme.names)
    scene.premises[told:] = [_as_it_begins(premise) for premise in scene.premises[told:]]
    spec.manners = [m for m in spec.manners if m.kind != "idle"]
    if len(parts) != 2 or len(parts[0].names) != len(parts[1].names):
        raise refuse(
            "count-mismatch",
            "two blocks are swapped with each other",
            clause.span,
            "say 'swap the red block and the blue block'",
        )
    if any(p.patch for p in parts):
        raise refuse("fixed-patch", "patches are marks on the table and cannot be moved", clause.span, "swap blocks")
    return [r.Swapped(a=parts[0].names, b=parts[1].names, span=clause.span)]


def _as_it_begins(premise: Meaning) -> Meaning:
    """ "swap A, which is on the mat, with B": what changes its place is told of as it begins."""
    if isinstance(premise, Premise) and isinstance(premise.condition, Loc):
        return replace(premise, condition=replace(premise.condition, mods=()))
    return premise
