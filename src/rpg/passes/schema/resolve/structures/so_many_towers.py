"""So many towers, or more or fewer, and how high they may be: "at least two towers of six blocks", "two or three
towers", "two towers of at most four each"."""

from __future__ import annotations

from collections.abc import Iterator

from rpg.core.diagnostics import Span
from rpg.ir import goal as g
from rpg.ir import structures as s
from rpg.language.meaning import Amount, Size, Structure, replace
from rpg.passes.schema.resolve.things.world import Ref, Scene, refuse

FEWEST = 2
"""Blocks of the smallest tower."""
MOST_WAYS = 12
"""In so many ways, at most, blocks may be shared among towers whose height is bounded."""


def so_high(theme: Ref, size: Size, scene: Scene, span: Span) -> Structure:
    """ "Stack six red blocks two high": what stacking makes of them, towers of that height where one does not do."""
    many = size.amount if size.what == "high" else None
    more = many is not None and many.low == many.high and FEWEST <= many.low < len(theme.names)
    if not more or any(scene.things[name].elastic for name in theme.names):
        return Structure(kind="stack", span=span)
    return Structure(kind="stack", det="bare", plural=True, span=span)


def bounded(shape: Structure) -> tuple[Structure, Amount | None]:
    """The structure without the bounds that are told of the height of each tower, and these."""
    amount = getattr(shape.members, "amount", None) if shape.each_size else shape.size
    _one_height(shape, amount)
    if amount is None or amount.low == amount.high or (amount.high is None and amount.low <= FEWEST):
        return shape, None
    if shape.each_size:
        members = replace(shape.members, amount=None) if shape.members is not None else None
        return replace(shape, members=members, each_size=False), amount
    return replace(shape, sizes=tuple(z for z in shape.sizes if z.amount != amount)), amount


def _one_height(shape: Structure, each: Amount | None) -> None:
    """Refuse "two towers of three blocks, each at most two high"."""
    for told in (z.amount for z in shape.sizes if z.what in ("high", "layers") and z.amount is not None):
        if shape.each_size and each is not None and not _overlap(each, told):
            raise refuse("count-mismatch", "so many blocks in each of them do not agree with how high they are to be",
                         shape.span, "say one of the two")  # fmt: skip


def _overlap(one: Amount, other: Amount) -> bool:
    return (one.high is None or other.low <= one.high) and (other.high is None or one.low <= other.high)


def within(node: s.Towers, bounds: Amount, shape: Structure) -> g.Goal:
    """Towers of which none is higher or lower than it may be."""
    blocks = len(node.blocks)
    shares = _shares(blocks, max(FEWEST, bounds.low), min(blocks, bounds.high or blocks), blocks)
    counts = {len(node.matching or ())} if node.matching else {node.count} - {None}
    ways = [share for share in shares if not counts or len(share) in counts]
    if not ways or node.each is not None:
        raise refuse("count-mismatch", f"{blocks} blocks do not make such towers", shape.span,
                     "say how high each tower is", blocks=blocks)  # fmt: skip
    if len(ways) > MOST_WAYS:
        raise refuse("ambiguous", "the height of the towers is left open", shape.span, "say one number")
    found = [node.model_copy(update={"count": len(way), "heights": way}) for way in ways]
    return found[0] if len(found) == 1 else g.Any(goals=tuple(found), span=node.span)


def _shares(blocks: int, low: int, high: int, most: int) -> Iterator[tuple[int, ...]]:
    """Ways to share blocks among towers from `low` to `high` blocks high, the highest first."""
    if not blocks:
        yield ()
    for first in range(min(high, most, blocks), low - 1, -1):
        for rest in _shares(blocks - first, low, high, first):
            yield (first, *rest)


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
    if node.equal and node.count and len(node.blocks) % node.count:
        raise refuse("count-mismatch", f"{len(node.blocks)} blocks do not make {node.count} equal towers", shape.span,
                     "use as many for each tower", blocks=len(node.blocks), towers=node.count)  # fmt: skip
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
