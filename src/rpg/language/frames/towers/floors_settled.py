"""The blocks of a tower from bottom to top, once all is told that is told of them."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence

from rpg.language.frames.pieces import Unclear
from rpg.language.frames.towers.floor_parts import Item, Run, Tower

_FEWEST_BETWEEN = 3
"""So many blocks at least has a tower whose ends are told as such."""


def settled(tower: Tower) -> list[str]:
    """The looks from bottom to top.

    Raises:
        Unclear: something is told twice, or is left open.
    """
    if tower.alternating:
        return _by_turns(tower)
    if not (tower.runs or tower.ends or tower.rest) and (listed := _both_ways(tower)):
        return listed
    if not (tower.runs or tower.ends) and tower.rest:
        raise Unclear  # "there are six blocks, the rest blue"
    told = Counter(look for run in tower.runs for look in run.looks)
    told.update([tower.ends] * 2 if tower.ends else [])
    stock, fill = _stock(tower, told)
    fill = [*fill, *([tower.rest] if tower.rest else [])]
    slots = _slots(tower, _size(tower, told, stock, fill))
    left = [n for n, look in enumerate(slots) if look is None]
    over = stock - told
    looks = {*over, *(item.look for item in fill)}
    if (stock and told - stock) or len(looks) != (1 if left else 0):
        raise Unclear
    if len(fill) > 1 or any((item.count or (None if item.plural else 1)) not in (None, len(left)) for item in fill):
        raise Unclear
    if tower.inner and (0 in left or len(slots) - 1 in left):
        raise Unclear
    if stock and sum(over.values()) != len(left):
        raise Unclear
    filler = next(iter(looks), "")
    return [look or filler for look in slots]


def _size(tower: Tower, told: Counter[str], stock: Counter[str], fill: Sequence[Item]) -> int:
    """How many blocks there are.

    Raises:
        Unclear: it is not told, or in two ways.
    """
    if stock:
        size = sum(stock.values())
    elif all(item.count or not item.plural for item in fill):
        size = sum(told.values()) + sum(item.count or 1 for item in fill)
    elif tower.total:
        return tower.total
    else:
        raise Unclear
    if tower.total not in (None, size):
        raise Unclear
    return size


def _by_turns(tower: Tower) -> list[str]:
    """Two looks in turn, where what is told of one end tells which is where.

    Raises:
        Unclear: there are not two, or both ways are as it is told.
    """
    looks = sorted({item.look for item in tower.bare} | {look for run in tower.runs for look in run.looks})
    counts = [item.count or 0 for item in tower.bare]
    size = tower.total or (sum(counts) if len(counts) == len(looks) and all(counts) else 0)
    if len(looks) != 2 or size < len(looks) or tower.ends or tower.rest:
        raise Unclear
    found = []
    for first, second in (looks, looks[::-1]):
        order = [first if n % 2 == 0 else second for n in range(size)]
        as_counted = all(item.count in (None, order.count(item.look)) for item in tower.bare)
        told = zip(_slots(tower, size), order, strict=True)
        if as_counted and all(look in (None, here) for look, here in told):
            found.append(order)
    if len(found) != 1:
        raise Unclear
    return found[0]


def _both_ways(tower: Tower) -> list[str]:
    """A list of single blocks that is the same from both ends, of which no direction is told; nothing for another."""
    looks = [item.look for item in tower.bare if item.count == 1 or not item.plural]
    same = len(looks) == len(tower.bare) > 1 and looks == looks[::-1] and len({*looks}) > 1
    return looks if same and len(looks) == (tower.total or len(looks)) else []


def _stock(tower: Tower, told: Counter[str]) -> tuple[Counter[str], list[Item]]:
    """The blocks that are told ahead of their places, or those that fill what is left."""
    looks = {item.look for item in tower.bare}
    if not tower.bare or not looks & {*told}:
        return Counter(), tower.bare
    if not {*told} <= looks or len(looks) < len(tower.bare):
        raise Unclear
    stock: Counter[str] = Counter()
    for item in tower.bare:
        if item.count is None and item.plural:
            raise Unclear
        stock[item.look] = item.count or 1
    return stock, []


def _slots(tower: Tower, size: int) -> list[str | None]:
    """The blocks on their floors; None where it is still left open.

    Raises:
        Unclear: two on one floor, or more than there are floors.
    """
    slots: list[str | None] = [None] * size
    if tower.ends and size >= _FEWEST_BETWEEN:
        slots[0] = slots[-1] = tower.ends
    elif tower.ends:
        raise Unclear
    free: list[Run] = []
    for run in tower.runs:
        many = len(run.looks)
        starts = {run.low} if run.low is not None else set()
        starts |= {size - run.high - many} if run.high is not None else set()
        if run.amid:
            starts.add((size - many) // 2)
            if (size - many) % 2:
                raise Unclear
        if not starts:
            free.append(run)
        elif len(starts) > 1:
            raise Unclear
        else:
            _fill(slots, starts.pop(), run.looks)
    if free:
        gap = [n for n, look in enumerate(slots) if look is None]
        if len(free) > 1 or not gap or gap[-1] - gap[0] + 1 != len(gap) or len(gap) != len(free[0].looks):
            raise Unclear
        _fill(slots, gap[0], free[0].looks)
    return slots


def _fill(slots: list[str | None], start: int, looks: Sequence[str]) -> None:
    if start < 0 or start + len(looks) > len(slots) or any(slots[start : start + len(looks)]):
        raise Unclear
    slots[start : start + len(looks)] = looks
