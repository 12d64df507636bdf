"""So many towers, or more or fewer: "at least two towers of six blocks", "two or three towers"."""

from __future__ import annotations

from rpg.ir import goal as g
from rpg.ir import structures as s
from rpg.language.meaning import Structure, replace
from rpg.passes.schema.resolve.things.world import refuse

FEWEST = 2
"""Blocks of the smallest tower."""


def without_range(shape: Structure, per: int | None, blocks: int | None) -> Structure:
    """The structure with one number of towers, where it follows from how many blocks there are and each takes."""
    amount = shape.amount
    if amount is None or amount.low == amount.high or per is None or blocks is None or blocks % per:
        return shape
    count = blocks // per
    fits = amount.low <= count and (amount.high is None or count <= amount.high)
    return replace(shape, amount=amount._replace(low=count, high=count)) if fits else shape


def each_number(node: s.Towers, shape: Structure, by_color: bool) -> g.Goal:
    """The towers, or as many of them as may be."""
    amount = shape.amount
    if amount is None or amount.low == amount.high or by_color:
        return node
    if node.heights is not None:
        raise refuse("ambiguous", "how many towers of this height these are is left open", shape.span,
                     "say one number of towers")  # fmt: skip
    blocks = len(node.blocks)
    most = blocks // FEWEST
    counts = range(max(1, amount.low), min(most, amount.high or most) + 1)
    ways = [_so_many(node, n) for n in counts if not node.equal or blocks % n == 0]
    if not ways:
        raise refuse("count-mismatch", f"{blocks} blocks do not make so many towers", shape.span,
                     "use more blocks", blocks=blocks)  # fmt: skip
    return ways[0] if len(ways) == 1 else g.Any(goals=tuple(ways), span=node.span)


def _so_many(node: s.Towers, count: int) -> g.Goal:
    if count == 1:
        return s.Stack(blocks=node.blocks, exact=True, span=node.span)
    return node.model_copy(update={"count": count})
