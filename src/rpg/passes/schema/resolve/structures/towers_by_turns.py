"""Several towers in none of which a block lies on one of its own colour: "three towers of two from three red and three
blue blocks, no two of the same color on each other". How many of each colour each has follows."""

from __future__ import annotations

from rpg.ir import goal as g
from rpg.ir import structures as s
from rpg.ir.order import Order
from rpg.language.meaning import Structure
from rpg.passes.schema.resolve.clauses.spec import Spec
from rpg.passes.schema.resolve.things.world import Built, Scene, refuse

Made = tuple[list[Built], list[g.Goal]]
_TWO = 2


def by_turns(
    names: tuple[str, ...], count: int | None, per: int | None, spec: Spec, shape: Structure, scene: Scene
) -> Made | None:
    """The towers, all of one height, each with colours that take turns; None where that is not said of them."""
    turns = [o for o in spec.orders if o.by == "alternating" and not o.items and o.values in ((), ("color",))]
    if len(turns) != 1 or len(spec.orders) > 1:
        return None
    spec.orders = []
    colors = list(dict.fromkeys(scene.things[name].color for name in names))
    lots = [[name for name in names if scene.things[name].color == color] for color in colors]
    if count is None or per is None or None in colors or len(colors) != _TWO or count * per != len(names):
        raise refuse("ambiguous", "it is not said which blocks are in which tower", shape.span,
                     "say of which blocks each tower is, as in 'each of a red and a blue block'")  # fmt: skip
    odd = per % 2
    more = len(lots[0]) - count * (per // 2)  # so many towers have one block more of the first colour
    if not 0 <= more <= count * odd:
        raise refuse("contradiction", "of these numbers of blocks no such towers can be built", shape.span,
                     "use as many blocks of each color")  # fmt: skip
    built: list[Built] = []
    goals: list[g.Goal] = []
    for n in range(count):
        ahead, behind = lots if n < more or not odd else lots[::-1]
        tower = (*_taken(ahead, per - per // 2), *_taken(behind, per // 2))
        order = Order(by="alternating", attribute="color")
        goals.append(s.Stack(blocks=tower, order=order, exact=True, span=shape.span))
        built.append(scene.add_built("stack", tower, False, shape.span))
    return built, goals


def _taken(lot: list[str], count: int) -> list[str]:
    taken, lot[:] = lot[:count], lot[count:]
    return taken
