"""How many blocks of each look a row has, and how many are at its places."""

from __future__ import annotations

from collections import Counter
from dataclasses import replace

from rpg.language.frames.lines.arranged import Fact
from rpg.language.frames.lines.places import Said
from rpg.language.frames.lots import Lot, counted
from rpg.language.frames.pieces import Unclear


def facts_of(
    said: Said, lots: list[Lot], size: int | None, pattern: str, others: bool = False
) -> tuple[list[Lot], list[Fact]]:
    """All lots, those told only with their place among them, and what is told of places: see `arranged.filled`.
    `others`: the only lot without a place is told as "the other four", so that those with one are no part of it.

    Raises:
        Unclear: it is not told how many blocks are at a place, or whether they are among the blocks told before.
    """
    free = {lot.look: lot for lot in lots}
    whole = bool(size) and all(lot.count for lot in lots) and sum(lot.count or 0 for lot in lots) == size
    added: Counter[str] = Counter()
    facts = []
    besides = False
    for placed in said.placed:
        lot, (name, nth) = placed.lot, placed.place
        same = free.get(lot.look)
        if same is None and free and lot.known:
            raise Unclear  # "the red one" where none is told
        besides = besides or (same is None and bool(free) and lot.count is None and all(one.count for one in lots))
        if same and not lot.known and lot.count and same.count and not (placed.within or whole):
            raise Unclear
        many = _how_many(lot, name, same, pattern)
        if same is None:
            added[lot.look] += many
        facts.append((name, nth, lot.look, many))
    if besides and not others and size != sum(lot.count or 0 for lot in lots) + added.total():
        raise Unclear  # "three orange blocks, white on the left", but not "a row of four: ..."
    return [*lots, *(Lot(look, many) for look, many in added.items())], facts


def facts_of_listed(said: Said, counts: Counter[str]) -> list[Fact]:
    """What is told of places where all blocks are listed in order."""
    found = []
    for placed in said.placed:
        lot, twice = placed.lot, placed.place[0] in ("ends", "each end")
        every = counts[lot.look] if lot.plural else 2 if twice else 1
        found.append((*placed.place, lot.look, lot.count or every))
    return found


def _how_many(lot: Lot, name: str, same: Lot | None, pattern: str) -> int:
    """How many blocks are at a place, on both sides where it has two."""
    twice = name in ("each end", "sides")
    every = same.count if same and same.count and (lot.plural or lot.known) else None
    if name == "ends":
        if lot.count not in (None, 1, 2) or (lot.count == 1 and lot.known) or every not in (None, 2):
            raise Unclear
        return 2
    if lot.count is not None:
        if twice and lot.known:
            raise Unclear
        return lot.count * 2 if twice else lot.count
    if every is not None:
        return every
    if lot.plural or (same and same.count != 1 and not pattern):
        if twice and not same:
            return 2 if not lot.plural or name == "each end" else _unclear()
        return _unclear()
    return 2 if twice else 1


def _unclear() -> int:
    raise Unclear


_OUTER = frozenset({
    ("ends", 0), ("each end", 0), ("first", 1), ("last", 1), ("left", 1), ("right", 1), ("front", 1), ("back", 1),
})  # fmt: skip
"""What alternates in an odd row has one more of what is at one of these."""


def numbered(lots: list[Lot], said: Said, size: int | None, pattern: str, open_rest: bool) -> list[Lot]:
    """The lots with their numbers.

    Raises:
        Unclear: they are not all told, or do not agree.
    """
    if any(lot.count is None and lot.plural for lot in lots[:-1]) and size is None:
        raise Unclear
    if pattern == "alternating" and len(lots) == 2 and size and size % 2 and all(lot.count is None for lot in lots):
        outer = {placed.lot.look for placed in said.placed if placed.place in _OUTER}
        more = [n for n, lot in enumerate(lots) if lot.look in outer]
        if len(more) == 1:
            lots = [replace(lot, count=size // 2 + (n == more[0])) for n, lot in enumerate(lots)]
    several = len(lots) > 1 and not open_rest
    if lots and lots[-1].count is None and lots[-1].plural and size is None and not (len(lots) > 1 and not said.placed):
        raise Unclear
    found = counted(lots, size if lots else None, evenly=pattern == "alternating", singly=several)
    if any(lot.count is None for lot in found):
        raise Unclear
    return found
