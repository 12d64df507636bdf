"""Blocks between two others: somewhere on the line, halfway, sandwiched in a tower."""

from __future__ import annotations

from dataclasses import replace

from rpg.core.diagnostics import Span
from rpg.ir import goal as g
from rpg.ir import relations as r
from rpg.ir import structures as s
from rpg.ir.node import Highest, Lowest
from rpg.ir.order import Order
from rpg.language.meaning import Clause, Loc, Toward
from rpg.passes.schema.resolve.clauses.spec import Spec
from rpg.passes.schema.resolve.places.stacking import sandwich
from rpg.passes.schema.resolve.things.operands import foot, spread
from rpg.passes.schema.resolve.things.world import Ref, Scene, refuse

HALFWAY_GAP = 10.0
"""How far apart two blocks with one halfway between them may be, in edges: as far as the workspace allows."""


def between(theme: Ref, mark: Ref, loc: Loc, scene: Scene, span: Span) -> g.Goal:
    """One or several blocks between two ends."""
    ends = mark.parts if len(mark.parts) == 2 else tuple(Ref(names=(n,)) for n in mark.names)
    if len(mark.built) == 2 and len(mark.parts) != 2:
        ends = tuple(Ref(names=b.members, built=(b,)) for b in mark.built)
    elif len(mark.built) == 1 and mark.built[0].kind == "towers":
        ends = _two_towers(mark, scene)
    if mark.op == "or" or len(ends) != 2:
        raise refuse(
            "between-two",
            "'between' wants two ends",
            loc.span,
            "say 'between the red block and the blue block'",
            ends=len(ends),
        )
    b, c = (foot(e) for e in ends)
    if loc.rel == "sandwiched":
        if len(theme.names) != 1 or any(len(e.names) != 1 for e in ends):
            raise refuse("misplaced", "one block is sandwiched between two", loc.span)
        return sandwich(ends[0].names[0], theme.names[0], ends[1].names[0], scene, span)
    if "halfway" in loc.mods:
        if (
            isinstance(b, Lowest | Highest)
            or isinstance(c, Lowest | Highest)
            or len(theme.names) * len(b) * len(c) != 1
        ):
            raise refuse("misplaced", "only one block between two can be halfway", loc.span, "say 'between'")
        order = Order(by="given", ranks=(b, theme.names, c))
        return s.Row(blocks=(*b, *theme.names, *c), order=order, evenly=True, gap_edges=HALFWAY_GAP, span=span)
    return spread(theme, lambda a: r.Between(a=a, b=b, c=c, span=span), span)


def _two_towers(mark: Ref, scene: Scene) -> tuple[Ref, ...]:
    """Two towers of look-alike blocks, told apart by fixing which block is in which."""
    names = mark.names
    looks = {(scene.things[n].color, scene.things[n].label) for n in names}
    if len(looks) > 1 or len(names) % 2 or None in {c for c, _ in looks}:
        return (mark,)
    half = len(names) // 2
    ends = []
    for part in (names[:half], names[half:]):
        built = scene.add_built("stack", part, False, mark.span)
        scene.goals.setdefault(scene.clause, []).append(s.Stack(blocks=part, exact=True, span=mark.span))
        ends.append(Ref(names=part, built=(built,)))
    return tuple(ends)


def by_sandwiching(clause: Clause, spec: Spec) -> None:
    """ "sandwich it between ...": one below it and one above."""
    if clause.lemma == "sandwich":
        spec.places = [
            replace(p, rel="sandwiched") if isinstance(p, Loc) and p.rel == "between" else p for p in spec.places
        ]
        spec.toward = [way for way in spec.toward if way != Toward(axis="z", span=way.span)]
