"""Blocks between two others: somewhere on the line, halfway, sandwiched in a tower."""

from __future__ import annotations

from collections.abc import Callable

from rpg.core.diagnostics import Span
from rpg.ir import goal as g
from rpg.ir import relations as r
from rpg.ir import structures as s
from rpg.ir.node import Highest, Lowest
from rpg.ir.order import Order
from rpg.language.meaning import Clause, Loc, Toward, Traits, replace
from rpg.passes.schema.resolve.clauses.spec import Spec
from rpg.passes.schema.resolve.goals.logic import conj
from rpg.passes.schema.resolve.places.ends import two_ends
from rpg.passes.schema.resolve.places.stacking import sandwich
from rpg.passes.schema.resolve.things.operands import foot, spread
from rpg.passes.schema.resolve.things.world import Exclusive, Ref, Scene, refuse

HALFWAY_GAP = 10.0
"""How far apart two blocks with one halfway between them, or on the line through them, may be, in edges: as far as the
workspace allows."""


_APART = ("distance", "apart", "left", "right", "front", "behind")
"""What blocks with nothing else between them may be to each other, not close."""


def only_between(theme: Ref, mark: Ref, loc: Loc, scene: Scene) -> Ref:
    """ "only the green block is between the two red ones": it is, and no other block of the task."""
    if loc.rel != "between" or loc.negated or theme.quant is not None:
        raise refuse("misplaced", "'only' does not fit this", theme.span, "say what the other blocks should not do")
    there: Callable[[str], g.Goal] = lambda n: between(Ref(names=(n,)), mark, loc, scene, loc.span)  # noqa: E731
    scene.exclusive.append(Exclusive((*theme.names, *mark.names), there, loc.span, Traits()))
    return replace(theme, op="and")


def between(theme: Ref, mark: Ref, loc: Loc, scene: Scene, span: Span) -> g.Goal:
    """One or several blocks between two ends."""
    if mark.quant is not None:
        raise refuse("between-two", "'between' wants two ends", loc.span,
                     "say 'between the red block and the blue block'")  # fmt: skip
    ends = two_ends(mark, loc, scene)
    b, c = (foot(e) for e in ends)
    if theme.everything and theme.quant is not None and theme.quant.high == 0:  # nothing else than the ends
        others = tuple(n for n in theme.names if n not in mark.names)
        apart = any(m.clause == scene.clause and m.rel in _APART for m in scene.mentions)
        if not others and not apart:
            raise refuse("ambiguous", "no other block, or no gap?", loc.span, "say 'touching' if there is to be no gap")
        scene.surveyed.append((Traits(), tuple({*theme.names, *mark.names}), span))
        return conj([g.Not(goal=r.Between(a=(n,), b=b, c=c, span=span), span=span) for n in others], span)
    if {*theme.names} & {*mark.names} and theme.quant is None:
        raise refuse("self-reference", "a block is not between itself and another one", loc.span, "name other blocks")
    if loc.rel == "sandwiched":
        if len(theme.names) != 1 or any(len(e.names) != 1 for e in ends):
            raise refuse("misplaced", "one block is sandwiched between two", loc.span)
        return sandwich(ends[0].names[0], theme.names[0], ends[1].names[0], scene, span)
    blocks = [*theme.names, *mark.names]
    piled = mark.patch or any(built.kind == "stack" and {*built.members} & {*blocks} for built in scene.built)
    lined = "collinear" in loc.mods
    if lined or "halfway" in loc.mods or ("middle" in loc.mods and len(blocks) == 3 and not piled):
        if (
            isinstance(b, Lowest | Highest)
            or isinstance(c, Lowest | Highest)
            or len(theme.names) * len(b) * len(c) != 1
            or (lined and piled)
        ):
            told = "on the line through them" if lined else "halfway"
            raise refuse("misplaced", f"only one block between two can be {told}", loc.span, "say 'between'")
        if mark.patch:
            inside = r.Between(a=theme.names, b=b, c=c, span=span)
            return conj([inside, r.Equidistant(a=theme.names, b=b, c=c, span=span)], span)
        order = Order(by="given", ranks=(b, theme.names, c))
        return s.Row(blocks=(*b, *theme.names, *c), order=order, evenly=not lined, gap_edges=HALFWAY_GAP, span=span)
    return spread(theme, lambda a: r.Between(a=a, b=b, c=c, span=span), span)


def by_sandwiching(clause: Clause, spec: Spec) -> None:
    """ "sandwich it between ...": one below it and one above."""
    if clause.lemma == "sandwich":
        spec.places = [
            replace(p, rel="sandwiched") if isinstance(p, Loc) and p.rel == "between" else p for p in spec.places
        ]
        spec.toward = [way for way in spec.toward if way != Toward(axis="z", span=way.span)]
