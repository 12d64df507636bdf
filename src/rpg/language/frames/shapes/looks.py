"""The looks of a flat figure's blocks: how many there are of each, and which part has which."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace

from rpg.language.frames.lots import Lot, counted
from rpg.language.frames.pieces import Unclear
from rpg.language.frames.shapes.blocks import SINGLE, Told
from rpg.language.frames.shapes.sizes import Sized

_MAKES: dict[str, Callable[[int], bool]] = {
    **dict.fromkeys(("plus", "X", "V"), lambda n: n > 4 and n % 2 == 1),
    **dict.fromkeys(("square", "rectangle", "triangle", "circle"), lambda n: n > 2),
    **dict.fromkeys(("T", "L", "U"), lambda n: n > 3),
}
"""Whether so many blocks may make the figure by themselves."""


def check_incomplete(said: Told, shape: str) -> None:
    """Blocks that have no place make no figure without those that have one.

    Raises:
        Unclear: "an L of five red blocks, and a blue block at its corner".
    """
    free = sum(lot.count or 0 for lot in said.free)
    looks = {lot.look for lot in said.free}
    if free and not any(lot.look in looks for lot, _ in said.placed) and _MAKES[shape](free):
        raise Unclear


def alternate(said: Told, total: int | None) -> bool:
    """Whether the blocks of a ring are listed one by one, two looks in turn; then each look is told of once."""
    looks = [lot.look for lot in said.free]
    if len(looks) < 4 or len(looks) != total or looks != looks[:2] * (total // 2) or looks[0] == looks[1]:
        return False
    if said.placed or any(lot.count not in (None, 1) for lot in said.free):
        return False
    said.free = [Lot(look, total // 2) for look in looks[:2]]
    return True


def colored(said: Told, size: Sized, colors: str, shape: str) -> tuple[Sized, str, list[tuple[str, str]]]:
    """A figure whose colours alternate, or all differ.

    Raises:
        Unclear: the figure is no ring, or it is told where some of the blocks are.
    """
    if said.placed and any(part != "inner" for _, part in said.placed):
        raise Unclear
    if colors == "different":
        if said.free or not size.total:
            raise Unclear
        return size, f" from {size.total} blocks of {size.total} different colors", []
    if shape not in ("circle", "square") or size.name.startswith("a filled") or len(said.free) < 2:
        raise Unclear
    lots = counted(said.free, size.total, evenly=True)
    if any(lot.count is None for lot in lots):
        raise Unclear
    named = replace(size, measures=size.measures + " of alternating colors")
    return named, f" from {' and '.join(lot.blocks for lot in lots)}", []


def _merged(said: Told, placed: Sequence[tuple[Lot, str]]) -> list[Lot]:
    """All lots of the figure: those without a place, and those of other looks that have one.

    Raises:
        Unclear: a part has two looks, or so many blocks do not fit there.
    """
    if len({part for _, part in placed}) < len(placed):
        raise Unclear
    lots = list(said.free)
    for lot, part in placed:
        many = 1 if part in SINGLE else lot.count
        if part in SINGLE and lot.count not in (None, 1):
            raise Unclear
        same = [other for other in lots if other.look == lot.look]
        if same and lot.count is not None and not lot.known and lot.count != same[0].count and same[0] in said.free:
            raise Unclear
        if not same:
            lots.append(replace(lot, count=many))
    return lots


def looks_of(said: Told, size: Sized, shape: str) -> tuple[str, list[tuple[str, str]]]:
    """ "from 4 red blocks and 1 blue block", and which part has which look.

    Raises:
        Unclear: the numbers do not agree, or do not follow.
    """
    placed = [(lot, part) for lot, part in said.placed if part != "inner"]
    lots = _merged(said, placed)
    total = size.total
    open_ = [lot for lot in lots if lot.count is None]
    if not lots:
        return (f" from {total} blocks" if total else ""), []
    parts = [(part, lot.look) for lot, part in placed]
    if len(open_) == 1 and (total is not None or len(lots) == 1) and (total is not None or not placed):
        lots = counted(lots, total)
        open_ = [lot for lot in lots if lot.count is None]
    if (
        not said.free
        and total
        and not open_
        and sum(lot.count or 0 for lot in lots) < total
        and dict(parts).keys() <= SINGLE
    ):
        return f" from {total} blocks", parts  # of the others no look is told
    told_of = {part for part, _ in parts}
    whole = shape == "circle" or len(placed) < len(said.placed)
    if (
        not (said.free or whole)
        and len(lots) == 1
        and told_of != {"bar", "stem"}
        and (len(told_of) == 1 or "rest" not in told_of)
    ):
        raise Unclear  # how do the others look?
    if not open_ or len(lots) == 1:
        if total is not None and sum(lot.count or 0 for lot in lots) != total and not open_:
            raise Unclear
        blocks = " and ".join(lot.blocks for lot in lots)
        special = [(part, look) for part, look in parts if part != "rest"]
        if parts and not special and len(lots) == 2:
            raise Unclear
        most = {"corners": 3 if shape == "triangle" else 2 if shape == "U" else 4}
        for lot, part in placed:
            if (lot.count and part in most and lot.count != most[part]) or (part in most and len(lots) == 1):
                raise Unclear
        return f" from {blocks}", special[:1] if {p for p, _ in special} == {"bar", "stem"} else special
    if any(lot.count for lot in said.free) or len(said.free) > 1:
        raise Unclear
    rest = [("rest", lot.look) for lot in said.free if lot.look not in [look for _, look in parts]]
    return (f" from {total} blocks" if total else ""), [*parts, *rest]
