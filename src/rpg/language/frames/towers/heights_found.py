"""How high towers are, and in which order they stand, as far as that follows from what is told of them."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from itertools import permutations

from rpg.language.frames.pieces import Unclear

FEWEST, HIGHEST = 2, 9
"""How many blocks a tower has."""
MOST = 5
"""So many towers at most."""
MANY = 60
"""So many ways at most are gone through."""

Which = int | tuple[str, int]
"""A tower by its number; ("rank", 1) the highest, ("rank", -1) the lowest, ("place", n) by its place in the order."""
Fact = tuple[str, Which, "Which | None", int]


@dataclass
class Towers:
    """What is told of towers. `looks`: the colour of each, in the order in which they are told; `stock`: how many
    blocks there are of each look; `first`: the side at which their order begins; `rels`: how two of them stand to each
    other; `said`: what must be so."""

    looks: list[str] = field(default_factory=list)
    count: int | None = None
    stock: dict[str, int] = field(default_factory=dict)
    all_used: bool = True
    first: str | None = None
    facts: list[Fact] = field(default_factory=list)
    rels: list[tuple[Which, Which, str]] = field(default_factory=list)
    unequal: bool = False
    listed: tuple[int, ...] = ()
    in_order: bool = False
    bounds: list[tuple[str, int]] = field(default_factory=list)

    def begins(self, side: str) -> None:
        """Their order is told from this side.

        Raises:
            Unclear: it is told from left to right as well as from front to back.
        """
        if self.first not in (None, side):
            raise Unclear
        self.first = side


@dataclass(frozen=True)
class Way:
    """A way to build the towers. `order`: the numbers of the towers from the first side; empty where none is told."""

    heights: tuple[int, ...]
    order: tuple[int, ...] = ()

    def number(self, which: Which) -> int | None:
        """Which tower is meant; None where it is one of several."""
        if isinstance(which, int):
            return which
        kind, n = which
        if kind == "place":
            return self.order[n]
        end = max(self.heights) if n > 0 else min(self.heights)
        found = [k for k, height in enumerate(self.heights) if height == end]
        return found[0] if len(found) == 1 else None

    def holds(self, fact: Fact) -> bool:
        """Whether it is as it is told."""
        kind, one, other, n = fact
        a = self.number(one)
        if a is None:
            return False
        if kind == "at":
            return self.order[n] == a
        if kind == "height":
            return self.heights[a] == n
        if kind == "others":
            return all(height == n for k, height in enumerate(self.heights) if k != a)
        if kind == "rank":
            return self.number(("rank", n)) == a
        b = self.number(other) if other is not None else None
        if b is None or a == b:
            return False
        if kind == "before":
            return self.order.index(a) < self.order.index(b)
        high, than = self.heights[a], self.heights[b]
        return {"by": high == than + n, "times": high == than * n, "more": (high - than) * n > 0}[kind]


def ways(told: Towers) -> list[Way]:
    """Every way to build them as it is told.

    Raises:
        Unclear: there are too many.
    """
    of_order = [fact for fact in told.facts if _of_order(fact)]
    of_height = [fact for fact in told.facts if fact not in of_order]
    found: list[Way] = []
    for heights in _heights(told, of_height):
        orders = permutations(range(len(heights))) if told.first else iter([()])
        for order in orders:
            way = Way(heights, order)
            if not all(map(way.holds, of_order)):
                continue
            if told.in_order and tuple(heights[n] for n in order) != told.listed:
                continue
            found.append(way)
        if len(found) > MANY:
            raise Unclear
    return found


def _of_order(fact: Fact) -> bool:
    kind, one, other, _ = fact
    return kind in ("at", "before") or any(isinstance(x, tuple) and x[0] == "place" for x in (one, other))


def _heights(told: Towers, facts: Sequence[Fact]) -> Iterator[tuple[int, ...]]:
    """The heights that towers may have."""
    fixed = {fact[1]: fact[3] for fact in facts if fact[0] == "height" and isinstance(fact[1], int)}
    count = len(told.looks)
    most = told.stock.get("") or sum(told.stock.values()) or HIGHEST * count
    for heights in _shares(count, most, fixed):
        if told.listed and sorted(heights) != sorted(told.listed):
            continue
        if (told.unequal and len(set(heights)) < count) or not _bounded(told, heights):
            continue
        if _taken(told, heights) and all(map(Way(heights).holds, facts)):
            yield heights


def _shares(count: int, most: int, fixed: dict[int, int]) -> Iterator[tuple[int, ...]]:
    """So many heights, with at most so many blocks."""
    if not count:
        yield ()
        return
    for heights in _shares(count - 1, most - FEWEST, fixed):
        left = most - sum(heights)
        of_it = fixed.get(count - 1)
        for height in range(FEWEST, min(left, HIGHEST) + 1) if of_it is None else (of_it,):
            if height <= left:
                yield (*heights, height)


def _bounded(told: Towers, heights: Sequence[int]) -> bool:
    """Whether none is higher or lower than it may be."""
    for which, n in told.bounds:
        barred = (
            range(n)
            if which in ("lower", "shorter", "at least")
            else (n,)
            if which == "exactly"
            else range(n + 1, HIGHEST + 1)
        )
        if any(height in barred for height in heights):
            return False
    return True


def _taken(told: Towers, heights: Sequence[int]) -> bool:
    """Whether they take the blocks that there are."""
    for look, many in told.stock.items():
        taken = sum(height for own, height in zip(told.looks, heights, strict=True) if look in ("", own))
        if taken > many or (told.all_used and taken < many):
            return False
    return True
