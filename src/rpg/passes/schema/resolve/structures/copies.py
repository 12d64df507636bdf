"""Several structures that are all the same, whichever order of their blocks it is that they share."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from itertools import permutations

from rpg.ir import goal as g
from rpg.ir import structures as s
from rpg.ir.order import Order
from rpg.language.meaning import Meaning, Noun, OrderBy, Traits
from rpg.passes.schema.resolve.things.world import Scene, refuse

MOST_ORDERS = 24
_FIRST = {"x": "front", "y": "left"}


def equal_share(lot: OrderBy, count: int) -> tuple[Meaning, ...]:
    """ "(two identical towers) from 2 red and 2 blue blocks": what each of them gets."""
    there: Counter[Traits] = Counter()
    share: list[Meaning] = []
    for item in lot.items:
        if isinstance(item, Noun):
            there[item.traits] += 1
            share += [item] if there[item.traits] % count == 0 else []
    uneven = next((many for many in there.values() if many % count), None)
    if uneven is not None:
        fits = uneven + count - uneven % count
        raise refuse("count-mismatch", f"{uneven} blocks of one look cannot be shared equally among {count} that are "
                     "to be the same", lot.span, f"use {fits} of them", blocks=uneven, towers=count)  # fmt: skip
    return tuple(share)


def in_one_order(goals: Sequence[g.Goal], scene: Scene) -> list[g.Goal]:
    """Each of the orders that all of them may have."""
    lines = [x for x in goals if isinstance(x, s.Stack | s.Row)]
    if len(lines) < len(goals) or len({len(x.blocks) for x in lines}) > 1:
        return list(goals)
    looks = [(t.color, t.label, t.kind, t.size, t.edge) for t in (scene.things[n] for n in lines[0].blocks)]
    seen = {tuple(looks[k] for k in way): way for way in permutations(range(len(looks)))} if len(looks) < 7 else {}
    if not 0 < len(seen) <= MOST_ORDERS:
        raise refuse("ambiguous", "it is not said in which order the blocks of each are", lines[0].span,
                     "list them behind a colon, as in 'two identical towers: red, blue, green'")  # fmt: skip
    if len(seen) == 1:
        return list(goals)
    ways = [g.All(goals=tuple(_ordered(line, way) for line in lines), span=lines[0].span) for way in seen.values()]
    return [g.Any(goals=tuple(ways), span=lines[0].span)]


def _ordered(line: s.Stack | s.Row, way: tuple[int, ...]) -> s.Stack | s.Row:
    first = "bottom" if isinstance(line, s.Stack) else _FIRST[line.axis or "y"]
    order = Order.model_validate({"by": "given", "ranks": tuple((line.blocks[k],) for k in way), "first": first})
    return line.model_copy(update={"order": order})
