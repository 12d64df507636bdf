"""The order of a sequence of blocks: does it hold, and which sequences make it hold."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import pairwise
from random import Random

from rpg.blocks.state import World
from rpg.blocks.traits import GRADIENT, Trait, Traits
from rpg.blocks.verdict import FALSE, TRUE, Verdict
from rpg.ir.order import Order

SORTED = ("label", "number", "rainbow", "size")
Keys = dict[str, Trait | None]
"""By name, what a sequence is sorted by; None where a block has no place in it."""
SHUFFLES = 24
"""How many further sequences are offered where the order leaves a choice."""


def ordered(order: Order, sequence: Sequence[str], traits: Traits, either: bool) -> Verdict:
    """Does `sequence`, read from the side that comes first (or from `either` end), follow `order`?"""
    if agrees(order, sequence, traits) or (either and agrees(order, sequence[::-1], traits)):
        return TRUE
    return FALSE


def agrees(order: Order, sequence: Sequence[str], traits: Traits) -> bool:
    """Does `sequence` follow `order`, read from its beginning?"""
    if order.by == "any":
        return True
    if order.by == "given":
        return _follows_ranks(order, sequence, traits.world)
    if order.by in SORTED:
        keys = [sort_key(order, name, traits) for name in sequence]
        if None in keys:
            return False
        ahead = keys[::-1] if order.descending else keys
        return all(a <= b for a, b in pairwise(ahead))  # type: ignore[operator]
    values = [traits.of(name, order.attribute) for name in sequence]
    if order.by == "alternating":
        return all(a != b for a, b in pairwise(values))
    if order.by == "mirrored":
        return values == values[::-1]
    changes = sum(a != b for a, b in pairwise(values))
    return changes == len(set(values)) - 1


def sort_key(order: Order, name: str, traits: Traits) -> Trait | None:
    """What a sorted order compares; None where the block has no place in it."""
    if order.by == "size":
        return traits.world.edge[name]
    if order.by == "rainbow":
        color = traits.world.blocks[name].color
        return float(GRADIENT.index(color)) if color in GRADIENT else None
    symbol = traits.symbol(name)
    if order.by == "number":
        return float(symbol) if symbol.isdigit() else None
    return symbol or None


def _follows_ranks(order: Order, sequence: Sequence[str], world: World) -> bool:
    """Are the ranks' members met rank by rank? Blocks that no rank mentions may stand anywhere."""
    rank_of = {name: k for k, rank in enumerate(order.ranks) for name in rank}
    present = [name for name in sequence if name in rank_of]
    met = [rank_of[name] for name in present]
    ranks = sorted(met)
    if met == ranks or order.match == "name":
        return met == ranks
    alone = {rank[0] for rank in order.ranks if len(rank) == 1} if order.match == "single" else set()
    look = {name: (name,) if name in alone else world.look[name] for name in present}
    expected: list[list[tuple[str, ...]]] = [[] for _ in order.ranks]
    found: list[list[tuple[str, ...]]] = [[] for _ in order.ranks]
    for name, rank in zip(present, ranks, strict=True):
        expected[rank_of[name]].append(look[name])
        found[rank].append(look[name])
    return all(sorted(a) == sorted(b) for a, b in zip(expected, found, strict=True))


def sequences(order: Order, names: Sequence[str], traits: Traits, rng: Random) -> Iterator[list[str]]:
    """Sequences of `names` that follow `order`, from its beginning; the most natural first, no one twice."""
    seen = set()
    keys = _keys(order, names, traits)
    for attempt in range(SHUFFLES + 1):
        pool = list(names)
        if attempt:
            rng.shuffle(pool)
        sequence = _sequence(order, pool, traits, keys)
        if sequence is not None and tuple(sequence) not in seen and agrees(order, sequence, traits):
            seen.add(tuple(sequence))
            yield sequence


def _keys(order: Order, names: Sequence[str], traits: Traits) -> Keys:
    """What names are sorted by, where the order sorts them."""
    if order.by == "given":
        rank_of = {name: k for k, rank in enumerate(order.ranks) for name in rank}
        return {name: rank_of.get(name, len(order.ranks)) for name in names}
    return {name: sort_key(order, name, traits) for name in names} if order.by in SORTED else {}


def _sequence(order: Order, pool: list[str], traits: Traits, keys: Keys) -> list[str] | None:
    """`pool` put in order, keeping its own order where there is a choice."""
    if order.by == "any":
        return pool
    if order.by == "given" or order.by in SORTED:
        descending = order.descending and order.by in SORTED
        return None if None in keys.values() else sorted(pool, key=keys.__getitem__, reverse=descending)  # type: ignore[arg-type]
    groups = list(traits.by_value(tuple(pool), order.attribute).values())
    if order.by == "alternating":
        return _alternating(groups)
    if order.by == "mirrored":
        return _mirrored(groups)
    return [name for group in groups for name in group]


def _alternating(groups: list[list[str]]) -> list[str] | None:
    """Members of the groups with no two of one group side by side: always from the largest that may come next."""
    left = [list(group) for group in groups]
    chosen: list[str] = []
    last = -1
    for _ in range(sum(len(group) for group in groups)):
        open_groups = [k for k in range(len(left)) if left[k] and k != last]
        if not open_groups:
            return None
        last = max(open_groups, key=lambda k: (len(left[k]), -k))
        chosen.append(left[last].pop(0))
    return chosen


def _mirrored(groups: list[list[str]]) -> list[str] | None:
    """A palindrome of the groups, or None where more than one of them is odd."""
    odd = [group for group in groups if len(group) % 2]
    if len(odd) > 1:
        return None
    front = [name for group in groups for name in group[: len(group) // 2]]
    back = [name for group in groups for name in group[len(group) // 2 : 2 * (len(group) // 2)]]
    return front + [group[-1] for group in odd] + back[::-1]


def fixed_edges(order: Order, names: Sequence[str], traits: Traits) -> list[str] | None:
    """The one sequence of `names` that follows `order`, where there is just one by name."""
    if order.by == "given":
        if any(len(rank) > 1 for rank in order.ranks) or len(order.ranks) != len(names):
            return None
        return _sequence(order, list(names), traits, _keys(order, names, traits))
    if order.by not in SORTED or (order.by == "rainbow" and order.first is None):
        return None
    keys = _keys(order, names, traits)
    if None in keys.values() or len(set(keys.values())) < len(keys):
        return None
    return _sequence(order, list(names), traits, keys)


def swaps(order: Order, sequence: Sequence[str], traits: Traits, either: bool) -> Iterator[tuple[str, str]]:
    """Pairs of blocks whose exchange breaks the order: neighbours first, then the ends."""
    if order.by == "any":
        return
    pairs = [(k, k + 1) for k in range(len(sequence) - 1)] + [(0, len(sequence) - 1)]
    for i, j in pairs:
        changed = list(sequence)
        changed[i], changed[j] = changed[j], changed[i]
        if not agrees(order, changed, traits) and not (either and agrees(order, changed[::-1], traits)):
            yield sequence[i], sequence[j]
