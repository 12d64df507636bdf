"""Several towers that are told all at once: alike, one of each colour, or of several heights."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass, replace
from itertools import pairwise

from rpg.language.frames.groups.shared import Gathered, listed, said_of
from rpg.language.frames.lots import Lot, counted, lot_of
from rpg.language.frames.pieces import Piece, Unclear
from rpg.language.frames.towers.words import ORD

_EQUAL = re.compile(r"\b(?:equal|identical|even|same)\b")


@dataclass(frozen=True)
class Told:
    """Numbers that are told: of towers, of blocks in each, of all blocks, and of blocks in one after the other."""

    count: int | None
    size: int | None
    total: int | None
    heights: list[int]


def told_in_line(names: Sequence[str]) -> str:
    """That each is left of the next."""
    return "".join(f" {a.capitalize()} is left of {b}." for a, b in pairwise(names))


_NTH = re.compile(rf"the (?:{ORD})(?: one| block)?")


def block_of_one(pieces: Sequence[Piece], places: Sequence[tuple[str, Sequence[Lot]]]) -> bool:
    """ "A tower of blue blocks, four, the third one red": one of its blocks is told, and no third tower."""
    told = any(_NTH.fullmatch(piece.words) for piece in pieces)
    return told and places[0][0] == "a" and not all(lots[0].count for _, lots in places)


def together(pieces: Sequence[Piece], found: Gathered, told_of: Told) -> tuple[str, list[str]]:
    """Towers that are told all at once, and the colours of those that have one each.

    Raises:
        Unclear: it does not follow which blocks each of them has.
    """
    count, size, kinds = told_of.count, told_of.size, [piece.kind for piece in pieces]
    lots, bases = list(found.lots.values()), {piece.value for piece in pieces if piece.kind == "basis"}
    if any(len(lot.look) == 1 for lot in lots) or (bases and {"place", "over", "under"} & set(kinds)):
        raise Unclear
    if bases:
        way = told_in_line([f"the {lot.look} tower" for lot in lots]) if "way" in kinds else ""
        return _by_color(lots, bases, told_of) + way, [lot.look for lot in lots]
    if {"place", "over", "under"} & set(kinds):
        return _layered(pieces, lots, told_of), []
    if "way" in kinds and not told_of.heights:
        raise Unclear
    if told_of.heights:
        return _of_heights(pieces, lots, told_of), []
    if count is None or count < 2:
        raise Unclear
    if "even" in kinds and size is None:
        lots = counted(lots, told_of.total)
        number_of = told_of.total or sum(lot.count or 0 for lot in lots)
        if (
            any(lot.count is None for lot in lots)
            or not number_of
            or number_of % count
            or "each" in kinds
            or _of_towers(pieces)
        ):
            raise Unclear
        return f"Build {count} towers of the same height from {said_of(lots) if lots else f'{number_of} blocks'}.", []
    if len(lots) > 1 and _one_for_each(pieces, lots, told_of):
        return f"Build {count} towers, {listed([f'one of {lot.blocks}' for lot in lots])}.", [lot.look for lot in lots]
    if len(lots) > 1:
        if "each" not in kinds or kinds.index("each") > kinds.index("lot") or any(lot.count is None for lot in lots):
            raise Unclear
        high = sum(lot.count or 0 for lot in lots)
        sizes = {size, *(piece.value for piece in pieces if piece.kind == "each")} - {None, high}
        if sizes or told_of.total not in (None, count * high):
            raise Unclear
        return f"Build {count} towers of {said_of(lots)} each.", []
    look = f"{lots[0].look} " if lots else ""
    each = size
    if lots and lots[0].count:
        per_tower = "each" in kinds or _of_towers(pieces)
        equal = any(piece.kind == "figure" and _EQUAL.search(piece.words) for piece in pieces)
        if equal and per_tower and "each" not in kinds and size is None and lots[0].count % count == 0:
            raise Unclear  # "three equal towers of nine red blocks"
        if equal and not per_tower and lots[0].count % count == 0:
            size = size or lots[0].count // count  # "with six red blocks make three equal towers"
        each = lots[0].count if per_tower else lots[0].count // count
        if (size or each) != each or (not per_tower and (size is None or size * count != lots[0].count)):
            raise Unclear
    if each is None or each < 2 or told_of.total not in (None, each * count):
        raise Unclear
    return f"Build {count} towers of {each} {look}blocks each.", []


def _of_towers(pieces: Sequence[Piece]) -> bool:
    """Whether the blocks stand right behind the towers that are made of them: "two towers of three red blocks"."""
    return any(
        a.kind == "figure" and [b.kind, c.kind] == ["glue", "lot"] and b.words == "of"
        for a, b, c in zip(pieces, pieces[1:], pieces[2:], strict=False)
    )


def _one_for_each(pieces: Sequence[Piece], lots: Sequence[Lot], told_of: Told) -> bool:
    """Whether a tower is told by each lot of a list: "three towers: 2 red, 2 green, 2 blue"."""
    kinds = [piece.kind for piece in pieces]
    behind = pieces[kinds.index("figure") + 1].words if "figure" in kinds[:-1] else ""
    return (
        behind in (":", "-")
        and told_of.count == len(lots)
        and told_of.size is None
        and not {"each", "even", "place"} & set(kinds)
        and min(lot.count or 0 for lot in lots) > 1
        and told_of.total in (None, sum(lot.count or 0 for lot in lots))
    )


def _by_color(lots: list[Lot], bases: set[str], told_of: Told) -> str:
    """One tower of each colour.

    Raises:
        Unclear: there are other numbers of towers or blocks, or towers may have the same colour.
    """
    count, size, total = told_of.count, told_of.size, told_of.total
    if told_of.heights or (
        "color" not in bases and bases != {"single", "different"} and not (bases == {"single"} and count == len(lots))
    ):
        raise Unclear
    if not lots:
        if count is None or size is None or count < 2 or total not in (None, count * size):
            raise Unclear
        return f"Build {count} towers of {size} blocks each, one tower per color."
    lots = counted([Lot(lot.look, lot.count or size) for lot in lots], total, evenly=True)
    if (
        len(lots) < 2
        or count not in (None, len(lots))
        or any((lot.count or 0) < 2 or size not in (None, lot.count) for lot in lots)
    ):
        raise Unclear
    return f"Build {len(lots)} towers from {said_of(lots)}, one tower per color."


def _layered(pieces: Sequence[Piece], lots: list[Lot], told_of: Told) -> str:
    """Towers alike, of which it is told which blocks are at the bottom and which on top.

    Raises:
        Unclear: something else is told of them, or it may be told of one of them.
    """
    count, size = told_of.count, told_of.size
    said = [p for p in pieces if p.kind in ("lot", "place", "over", "under", "stop", "each")]
    kinds = [p.kind for p in said if p.kind not in ("stop", "each")]
    if (
        count is None
        or count < 2
        or len(lots) != 2
        or told_of.heights
        or not (
            "each" in [p.kind for p in said]
            or _of_towers(pieces)
            or any(p.kind == "size" and re.match("(?:in )?each|every", p.words) for p in pieces)
        )
    ):
        raise Unclear
    names = [lot.look for lot in lots]
    said, kinds = _placed_only(said, kinds)
    if kinds in (["lot", "over", "lot"], ["lot", "under", "lot"]):
        order = [next(lot for lot in lots if lot.look == lot_of(p).look) for p in said if p.kind == "lot"]
        top, bottom = order if kinds[1] == "over" else order[::-1]
        if max(lot.count or 1 for lot in lots) > 1 and "each" not in [p.kind for p in said]:
            raise Unclear  # "two towers of two red blocks on a blue block"
    elif kinds == ["lot", "lot", "place"]:  # "one red block and one gray block on it"
        at_top = next(p.value for p in said if p.kind == "place") == "at the top"
        bottom, top = lots if at_top else lots[::-1]
    elif kinds in (["lot", "place", "lot", "place"], ["place", "lot", "place", "lot"]):
        at = [p.value for p in said if p.kind == "place"]
        if sorted(at) != ["at the bottom", "at the top"]:
            raise Unclear
        order = [next(lot for lot in lots if lot.look == lot_of(p).look) for p in said if p.kind == "lot"]
        bottom, top = order if at[0] == "at the bottom" else order[::-1]
    else:
        raise Unclear
    numbers_of = [lot.count or 1 for lot in lots]
    if (
        size not in (None, sum(numbers_of))
        or told_of.total not in (None, count * sum(numbers_of))
        or len(set(names)) < 2
    ):
        raise Unclear
    low, high = Lot(bottom.look, bottom.count or 1), Lot(top.look, top.count or 1)
    return f"Build {count} towers, each with {low.blocks} at the bottom and {high.blocks} at the top."


def _placed_only(said: list[Piece], kinds: list[str]) -> tuple[list[Piece], list[str]]:
    """What is told of places behind two lots that are told ahead of them: "one red and one blue, the red one below"."""
    told_of = [piece for piece in said if piece.kind not in ("stop", "each")]
    if kinds[:2] != ["lot", "lot"] or len(kinds) < 4:
        return said, kinds
    ahead, behind = told_of[:2], told_of[2:]
    again = [lot_of(piece) for piece in behind if piece.kind == "lot"]
    looks = [lot_of(piece).look for piece in ahead]
    if any(lot.look not in looks or lot.count not in (None, 1) for lot in again):
        raise Unclear
    if len(again) == 1 and kinds[2:] in (["lot", "place"], ["place", "lot"]):
        other = ahead[1 - looks.index(again[0].look)]
        at = next(piece for piece in behind if piece.kind == "place")
        opposite = "at the top" if at.value == "at the bottom" else "at the bottom"
        behind = [*behind, *[other, replace(at, value=opposite)][:: 1 if kinds[2] == "lot" else -1]]
    return behind, [piece.kind for piece in behind]


def _of_heights(pieces: Sequence[Piece], lots: list[Lot], told_of: Told) -> str:
    """Towers of several heights.

    Raises:
        Unclear: the numbers of towers or blocks do not agree.
    """
    heights = told_of.heights
    all_of_them = sum(heights)
    if (
        told_of.count not in (None, len(heights))
        or told_of.size
        or told_of.total not in (None, all_of_them)
        or len(lots) > 1
    ):
        raise Unclear
    if len(heights) < 2 or min(heights) < 2 or (lots and lots[0].count not in (None, all_of_them)):
        raise Unclear
    if not (lots or told_of.count or told_of.total):
        raise Unclear
    look = f"{lots[0].look} " if lots else ""
    way = " from left to right" if any(piece.kind == "way" for piece in pieces) else ""
    return f"Build {len(heights)} {look}towers of heights {listed([str(height) for height in heights])}{way}."
