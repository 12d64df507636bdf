""" "Take the yellow one out of the row": it leaves the line that it is part of at the start."""

from __future__ import annotations

from rpg.ir import goal as g
from rpg.ir import relations as r
from rpg.ir import structures as s
from rpg.ir.order import Order
from rpg.language.meaning import Clause, Loc, Pronoun, Structure
from rpg.passes.schema.resolve.clauses.spec import Spec
from rpg.passes.schema.resolve.orders.reordered import FIRST, line_of_the_start, lines_of_the_start
from rpg.passes.schema.resolve.things.refer import refer
from rpg.passes.schema.resolve.things.world import Built, Scene, Scope, refuse

_CLOSED = 0.9
"""A gap is closed if no block fits into it any more."""


def out_of_its_line(clause: Clause, spec: Spec, scene: Scene, scope: Scope) -> list[g.Goal] | None:
    """What becomes of a line and of the block that is taken out of it; None for other clauses."""
    if clause.lemma != "out" or clause.verb != "remove" or clause.theme is None:
        return None
    closed = [x for x in spec.spacings if x.kind == "closed"]
    named = [x.landmark for x in spec.places if isinstance(x, Loc)]
    if not lines_of_the_start(scene):
        what = named[0].kind if named and isinstance(named[0], Structure) else "row"
        raise refuse("no-referent", f"it is not said which blocks the {what} has", clause.span,
                     f"say first 'there is a {what} of red, yellow and blue'")  # fmt: skip
    home = line_of_the_start(scene, clause.span)
    kinds = [x.kind for x in named if isinstance(x, Structure)]
    theme = refer(clause.theme, scene, scope)
    rest = tuple(name for name in home.members if name not in theme.names)
    another = any((kind == "stack") != (home.kind == "stack") for kind in kinds)
    it = [x for x in named if isinstance(x, Pronoun)] and len(scene.built) > 1
    if another or it or theme.quant is not None or not rest or not {*theme.names} < {*home.members}:
        raise refuse("no-referent", "it is not clear out of which line this is", clause.span,
                     "name a block of the row or tower that is there at the start")  # fmt: skip
    spec.spacings = [x for x in spec.spacings if x not in closed]
    spec.places = []
    if home.kind == "stack":
        left: list[g.Goal] = [_in_order(home, rest, clause)] if len(rest) > 1 else []
        return [*left, r.OnTable(a=theme.names, span=clause.span)]
    scene.assume("what is taken out of a row is at least 10 cm from its other blocks")
    away: list[g.Goal] = [r.Apart(a=(one,), b=(two,), span=clause.span) for one in theme.names for two in rest]
    if closed and len(rest) > 1:
        return [_in_order(home, rest, clause).model_copy(update={"gap_edges": _CLOSED}), *away]
    scene.assume("the other blocks of the row stay where they are")
    return [*away, r.Stayed(a=rest, span=clause.span)]


def _in_order(home: Built, names: tuple[str, ...], clause: Clause) -> g.Goal:
    """What is left of a line, in the order that it had."""
    first = home.side or FIRST[home.kind]
    order = Order(by="given", ranks=tuple((name,) for name in names), first=first)  # type: ignore[arg-type]
    if home.kind == "stack":
        return s.Stack(blocks=names, order=order, exact=True, span=clause.span)
    return s.Row(blocks=names, axis="x" if first in ("front", "back") else "y", order=order, span=clause.span)
