"""Several towers that stand in a row: a row of their lowest blocks."""

from __future__ import annotations

from typing import TYPE_CHECKING

from rpg.core.diagnostics import Span
from rpg.ir import goal as g
from rpg.ir import structures as s
from rpg.ir.order import Order
from rpg.language.later import later
from rpg.language.meaning import Clause, Coord, Into, Meaning, Noun, Structure, Traits, replace
from rpg.passes.schema.resolve.clauses.spec import Spec
from rpg.passes.schema.resolve.things.refer import refer
from rpg.passes.schema.resolve.things.world import Built, Scene, Scope, refuse

if TYPE_CHECKING:
    from rpg.passes.schema.resolve.structures.structures import make
else:
    (make,) = later(__name__, "rpg.passes.schema.resolve.structures.structures", "make")

Goals = list[g.Goal]


def lined_up(shape: Structure, spec: Spec) -> Structure:
    """ "four towers of two, arranged in a row": what is said of the row is said of the towers in it."""
    said = [*spec.intos, *(a for a in shape.details if isinstance(a, Into))]
    into = said[0] if len(said) == 1 else None
    line = into.structure if into is not None else None
    if shape.kind != "stack" or not shape.plural:
        return shape
    if not isinstance(line, Structure) or line.kind not in ("row", "line") or line.plural or line.det not in _NEW:
        return shape
    if line.members or line.traits != Traits() or (shape.sizes and line.sizes):
        return shape
    if heights := next((z for z in shape.sizes if z.what == "heights"), None):
        raise refuse("ambiguous", "it is not said which of the towers in the row has which height", heights.span,
                     "say of which blocks each tower is, one by one")  # fmt: skip
    spec.intos = []
    spec.lined = True
    own = tuple(a for a in shape.details if not isinstance(a, Into))
    return replace(shape, sizes=shape.sizes or line.sizes, details=(*own, *line.details))


_NEW = ("a", "bare")


def mixed_line(clause: Clause, spec: Spec, scene: Scene, scope: Scope) -> Goals | None:
    """ "from left to right a red block, a tower of two blue ones, a green block": a row of these and of its foot."""
    items = clause.theme.items if isinstance(clause.theme, Coord) and clause.theme.op == "and" else ()
    way = spec.toward[0] if len(spec.toward) == 1 else None
    if way is None or way.first not in ("left", "right", "front", "back") or not all(map(_stands, items)):
        return None
    lines = [i.structure for i in spec.intos if isinstance(i.structure, Structure)]
    plain = all(x.kind in ("row", "line", "column") and not (x.members or x.plural or x.details) for x in lines)
    told = spec.places or spec.orders or spec.absolutes or spec.ats or spec.usings or spec.thats or spec.patterns
    if clause.negated or scope.start or told or not plain or len(lines) < len(spec.intos):
        return None
    if not any(isinstance(x, Structure) for x in items):
        return None
    goals: Goals = []
    ranks: list[tuple[str, ...]] = []
    for item in items:
        if isinstance(item, Structure):
            built, more = make(item, Spec(), None, scene, scope)
            goals += more
            ranks.append((_foot(built[0], scene, item.span),))
        else:
            found = refer(item, scene, replace(scope, role="theme"))
            if found.quant is not None or found.op != "and" or not found.names:
                raise refuse("ambiguous", "it is not clear which block is meant", item.span, "name one block")
            ranks.append(found.names)
    spec.toward, spec.intos = [], []
    feet = tuple(name for rank in ranks for name in rank)
    order = Order.model_validate({"by": "given", "ranks": tuple(ranks), "first": way.first})
    across = way.first in ("left", "right")
    return [*goals, s.Row(blocks=feet, axis="y" if across else "x", order=order, span=clause.span)]


def _stands(item: Meaning) -> bool:
    """A tower that is built, or blocks of one look."""
    if isinstance(item, Structure):
        return item.kind == "stack" and not item.plural and item.det in _NEW
    one = isinstance(item, Noun) and item.head != "patch" and item.part_of is None and not item.conditions
    return one and isinstance(item, Noun) and len(item.traits.colors + item.traits.labels) == 1


def _foot(tower: Built, scene: Scene, span: Span) -> str:
    """The lowest block of a tower, where it is known which this is, or all its blocks look alike."""
    looks = {(t.color, t.label, t.kind, t.size, t.edge) for t in (scene.things[n] for n in tower.members)}
    if tower.kind != "stack" or not (tower.ordered or len(looks) == 1):
        raise refuse("ambiguous", "it is not said which blocks of the towers are the lowest ones", span,
                     "say of which blocks each tower is, from the bottom up")  # fmt: skip
    return tower.members[0]


def line_of(built: list[Built], spec: Spec, scene: Scene, span: Span) -> g.Goal:
    """The lowest blocks of the towers, where it is known which these are, or all blocks of a tower look alike."""
    feet = tuple(_foot(tower, scene, span) for tower in built)
    kinds = {spacing.kind for spacing in spec.spacings if spacing.low is None}
    spec.spacings = [spacing for spacing in spec.spacings if spacing.low is not None]
    return s.Row(blocks=feet, axis="y", evenly="even" in kinds, touching="touching" in kinds, span=span)
