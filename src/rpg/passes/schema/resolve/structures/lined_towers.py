"""Several structures in order along the table: towers and single blocks are a row of their lowest blocks, others are
beside each other."""

from __future__ import annotations

from itertools import pairwise
from typing import TYPE_CHECKING

from rpg.core.diagnostics import Span
from rpg.ir import goal as g
from rpg.ir import relations as r
from rpg.ir import structures as s
from rpg.ir.order import Order
from rpg.language.later import later
from rpg.language.meaning import (
    Amount,
    Chain,
    Clause,
    Coord,
    Into,
    Meaning,
    Noun,
    Pronoun,
    Structure,
    Toward,
    Traits,
    replace,
)
from rpg.passes.schema.resolve.clauses.spec import Spec
from rpg.passes.schema.resolve.things.operands import foot
from rpg.passes.schema.resolve.things.refer import refer
from rpg.passes.schema.resolve.things.world import Built, Ref, Scene, Scope, refuse, which_one

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
    heights = next((z for z in shape.sizes if z.what == "heights"), None)
    if heights is not None and spec.first("left", "right") is None:
        raise which_one("it is not said which of the towers in the row has which height", heights.span,
                        "say how high each is 'from left to right', or of which blocks each tower is")  # fmt: skip
    spec.intos = []
    spec.lined = True
    own = tuple(a for a in shape.details if not isinstance(a, Into))
    return replace(shape, sizes=shape.sizes or line.sizes, details=(*own, *line.details))


_NEW = ("a", "bare", "another")


def mixed_line(clause: Clause, spec: Spec, scene: Scene, scope: Scope) -> Goals | None:
    """ "from left to right a red block, a tower of two blue ones, a green block": a row of these and of its foot.
    "From left to right: a tower, a row of two, a tower": each beside the next."""
    items = _each_a_tower(clause.theme.items) if isinstance(clause.theme, Coord) and clause.theme.op == "and" else ()
    way = spec.toward[0] if len(spec.toward) == 1 else None
    if way is None or way.first not in ("left", "right", "front", "back") or clause.negated or scope.start:
        return None
    lines = [i.structure for i in spec.intos if isinstance(i.structure, Structure)]
    plain = all(x.kind in ("row", "line", "column") and not (x.members or x.plural or x.details) for x in lines)
    told = spec.places or spec.absolutes or spec.ats or spec.usings or spec.thats or spec.patterns
    if told or not plain or len(lines) < len(spec.intos) or not any(isinstance(x, Structure) for x in items):
        return None
    stands = all(map(_stands, items))
    if not (stands and not spec.orders) and (lines or not all(_stands(x) or _lies(x) for x in items)):
        return None
    ahead = clause.theme is not None and way.span[0] < clause.theme.span[0]
    if not stands and not (ahead or _in_this_order(spec) or all(map(_of_one_look, items))):
        return None
    goals: Goals = []
    ranks: list[tuple[str, ...]] = []
    parts: list[Ref] = []
    for item in items:
        if isinstance(item, Structure):
            _own_order(item, stands)
            built, more = make(item, Spec(), None, scene, scope)
            goals += more
            parts.append(Ref(names=built[0].members, built=tuple(built), span=item.span))
            ranks.append((_foot(built[0], scene, item.span),) if stands else ())
        else:
            found = refer(item, scene, replace(scope, role="theme"))
            if found.quant is not None or found.op != "and" or not found.names:
                raise refuse("ambiguous", "it is not clear which block is meant", item.span, "name one block")
            parts.append(found)
            ranks.append(found.names)
    spec.toward, spec.intos, spec.orders = [], [], []
    if not stands or (not lines and all(isinstance(x, Structure) for x in items)):
        return [*goals, *_one_beside_the_next(parts, way.first, clause.span)]
    feet = tuple(name for rank in ranks for name in rank)
    order = Order.model_validate({"by": "given", "ranks": tuple(ranks), "first": way.first})
    across = way.first in ("left", "right")
    return [*goals, s.Row(blocks=feet, axis="y" if across else "x", order=order, span=clause.span)]


def _each_a_tower(items: tuple[Meaning, ...]) -> tuple[Meaning, ...]:
    """ "towers of two red, three yellow and four blue blocks": a tower of each."""
    towers, *more = items
    if not isinstance(towers, Structure) or not (towers.plural and towers.each_size) or towers.amount is not None:
        return items
    lots = (towers.members, *more)
    if towers.details or not all(isinstance(x, Noun) and x.amount is not None and x.traits.colors for x in lots):
        return items
    one = replace(towers, det="a", amount=Amount(1, 1), plural=False, each_size=False)
    return tuple(replace(one, members=x, span=x.span) for x in lots if isinstance(x, Noun))


def of_all_that_follows(chain: Chain) -> None:
    """Refuse "from far to near: a row of black ones, a row of white ones" where the direction would be of the first
    alone."""
    first, *later = chain.clauses
    way = next((a for a in first.adjuncts if isinstance(a, Toward)), None) if isinstance(first, Clause) else None
    if way is None or not isinstance(first, Clause) or first.mode != "goal" or way.span[0] > first.span[0]:
        return
    for clause in later:
        if not isinstance(clause, Clause) or clause.mode != "goal" or isinstance(clause.theme, Pronoun):
            continue
        lined = clause.verb in ("build", "arrange") or any(isinstance(a, Into) for a in clause.adjuncts)
        if lined and not any(isinstance(a, Toward) for a in clause.adjuncts):
            raise refuse("misplaced", "this direction could be of the first, or of all that follows", way.span,
                         "say it where it belongs, as in 'a row of two red blocks from left to right'")  # fmt: skip


_BESIDE: dict[str, type[r.LeftOf | r.RightOf | r.InFrontOf | r.Behind]] = {
    "left": r.LeftOf, "right": r.RightOf, "front": r.InFrontOf, "back": r.Behind,
}  # fmt: skip


def _one_beside_the_next(parts: list[Ref], first: str, span: Span) -> Goals:
    return [_BESIDE[first](a=foot(a), b=foot(b), span=span) for a, b in pairwise(parts)]


def _in_this_order(spec: Spec) -> bool:
    """ "in this order (from left to right)", of which it is not said what it is an order of."""
    return len(spec.orders) == 1 and spec.orders[0].by == "given" and not spec.orders[0].items


def _own_order(item: Structure, stands: bool) -> None:
    """Refuse a line of several looks whose own order is not told: it may be what the direction is said of."""
    if not stands and item.kind in _LYING and not _of_one_look(item) and not item.details:
        raise refuse("ambiguous", "this may be the order of the structures, or of the blocks in each", item.span,
                     "say the order of each by itself, as in 'a row of red, blue from left to right'")  # fmt: skip


_LYING = ("row", "line", "column")


def _lies(item: Meaning) -> bool:
    """A structure of another kind, which is built."""
    return isinstance(item, Structure) and not item.plural and item.det in _NEW


def _of_one_look(item: Meaning) -> bool:
    """Whether blocks look alike, so that no order of them can be meant."""
    members = item.members if isinstance(item, Structure) else item
    return isinstance(members, Noun) and len(members.traits.colors) < 2 and len(members.traits.labels) < 2


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
