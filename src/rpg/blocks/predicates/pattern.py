"""How a figure's cells are filled: by row, column or layer, as a checkerboard, or in reading order."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from random import Random

from rpg.blocks.figures import Cell, Ideal, lines
from rpg.blocks.predicates.order import SHUFFLES, agrees, sequences
from rpg.blocks.traits import Traits
from rpg.ir.order import Pattern


def reading_order(cells: Sequence[Cell], upward: bool) -> list[int]:
    """Cells, by index, as a page is read: top layer first (or last, if `upward`), far row first, from the left."""
    sign = 1 if upward else -1
    return sorted(range(len(cells)), key=lambda k: (sign * cells[k].level, cells[k].row, cells[k].column))


def follows(pattern: Pattern, ideal: Ideal, blocks: Sequence[str], traits: Traits) -> bool:
    """Do `blocks`, one per cell, follow the pattern?"""
    cells = ideal.cells
    if pattern.kind == "reading":
        if ideal.ring:
            return any(_goes_round(pattern, turned, traits) for turned in _turns(blocks))
        read = list(blocks) if pattern.own else [blocks[k] for k in reading_order(cells, pattern.upward)]
        either = pattern.order.by == "rainbow" and pattern.order.first is None
        return agrees(pattern.order, read, traits) or (either and agrees(pattern.order, read[::-1], traits))
    values = [traits.of(name, pattern.attribute) for name in blocks]
    if pattern.kind == "checkerboard":
        even = {v for v, cell in zip(values, cells, strict=True) if parity(cell) == 0}
        odd = {v for v, cell in zip(values, cells, strict=True) if parity(cell) == 1}
        return len(even) == len(odd) == 1 and even != odd and not (ideal.ring and len(cells) % 2)
    per_line = [{values[k] for k in line} for line in lines(cells, pattern.kind).values()]
    return all(len(found) == 1 for found in per_line) and len(set.union(*per_line)) == len(per_line)


def parity(cell: Cell) -> int:
    """Which of a checkerboard's two values a cell has."""
    return (cell.row + cell.column + cell.level) % 2


def _turns(blocks: Sequence[str]) -> Iterator[list[str]]:
    """A ring read from each of its blocks, both ways round."""
    for way in (list(blocks), list(blocks)[::-1]):
        for k in range(len(way)):
            yield way[k:] + way[:k]


def _goes_round(pattern: Pattern, ring: Sequence[str], traits: Traits) -> bool:
    """Does the order hold along a ring? No two neighbours of an alternating one agree, the last and first included."""
    closed = [*ring, ring[0]] if pattern.order.by == "alternating" and len(ring) > 2 else ring
    return agrees(pattern.order, closed, traits)


def fillings(
    pattern: Pattern | None, ideal: Ideal, names: Sequence[str], traits: Traits, rng: Random
) -> Iterator[list[str]]:
    """Blocks for the cells, one each, that follow the pattern; the most natural first."""
    cells = ideal.cells
    if pattern is None or pattern.kind == "reading":
        own = pattern is not None and pattern.own
        read = [*range(len(cells))] if own else reading_order(cells, pattern is not None and pattern.upward)
        order = (pattern or Pattern(kind="reading")).order
        for sequence in sequences(order, names, traits, rng):
            filled = [""] * len(cells)
            for k, name in zip(read if not ideal.ring else range(len(cells)), sequence, strict=True):
                filled[k] = name
            if pattern is None or follows(pattern, ideal, filled, traits):
                yield filled
        return
    for attempt in range(SHUFFLES + 1):
        pool = list(names)
        if attempt:
            rng.shuffle(pool)
        filling = _dealt(pattern, cells, pool, traits)
        if filling is not None and follows(pattern, ideal, filling, traits):
            yield filling


def _dealt(pattern: Pattern, cells: Sequence[Cell], pool: Sequence[str], traits: Traits) -> list[str] | None:
    """Groups of blocks with one value dealt to lines of their number."""
    if pattern.kind == "checkerboard":
        places = [[k for k, cell in enumerate(cells) if parity(cell) == n] for n in (0, 1)]
    else:
        places = list(lines(cells, pattern.kind).values())
    groups = list(traits.by_value(tuple(pool), pattern.attribute).values())
    if len(groups) != len(places):
        return None
    filled = [""] * len(cells)
    for place in sorted(places, key=len, reverse=True):
        group = next((g for g in groups if len(g) == len(place)), None)
        if group is None:
            return None
        groups.remove(group)
        for k, name in zip(place, group, strict=True):
            filled[k] = name
    return filled
