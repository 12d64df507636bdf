""" "The red row is in front", "the taller tower is on the left": of two structures that were told, beside the other."""

from __future__ import annotations

from rpg.ir import goal as g
from rpg.language.meaning import Clause, Structure
from rpg.passes.schema.resolve.clauses.spec import Spec
from rpg.passes.schema.resolve.orders.among_places import wholes
from rpg.passes.schema.resolve.places.utmost import BEYOND
from rpg.passes.schema.resolve.things.operands import foot
from rpg.passes.schema.resolve.things.world import Ref, Scene, Scope

_LINES = ("row", "line", "column")


def sided(spec: Spec) -> bool:
    """ "A tower of two on the left": a side of the table, or of what else is there, and no place in the tower."""
    plain = [at for at in spec.ats if at.index is None and not at.whole and not at.own]
    return len(spec.ats) == len(plain) == 1 and plain[0].side in BEYOND


def side_of_two(ref: Ref, clause: Clause, spec: Spec, scene: Scene, scope: Scope) -> list[g.Goal]:
    """Where one of the only two structures of a kind is said to be on a side, it is on that side of the other one."""
    known = isinstance(clause.theme, Structure) and clause.theme.det == "the" and not clause.theme.members
    known = known and clause.verb != "spell"  # a word that is only made here
    if not known or scope.start or clause.negated or len(ref.built) != 1 or not sided(spec):
        return []
    here = ref.built[0]
    kinds = _LINES if here.kind in _LINES else (here.kind,)
    others = [b for b in wholes(scene) if b.kind in kinds and b != here]
    if len(others) != 1 or {*others[0].members} & {*here.members} or len(wholes(scene)) > len(others) + 1:
        return []
    at, spec.ats = spec.ats[0], []
    other = Ref(names=others[0].members, built=(others[0],))
    return [BEYOND[at.side](a=foot(ref), b=foot(other), span=clause.span)]
