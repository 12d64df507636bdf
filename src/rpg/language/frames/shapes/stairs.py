"""One staircase: how many steps or how high, which way it rises, the looks of its steps."""

from __future__ import annotations

from collections.abc import Sequence

from rpg.language.frames.lots import (
    Lot,
    as_adjectives,
    check_listed,
    check_owned,
    counted,
    declared,
    lot_of,
    one,
    placed_lots,
    without_brackets,
)
from rpg.language.frames.pieces import Piece, Unclear
from rpg.language.frames.shapes.stairs_words import NTH, OVER
from rpg.language.frames.shapes.stairs_words import PATTERNS as PATTERNS
from rpg.language.lexicon import RAINBOW


def told(pieces: Sequence[Piece]) -> str:
    """The staircase in plain sentences.

    Raises:
        Unclear: it is told of more than one, or its steps do not agree.
    """
    pieces = without_brackets(as_adjectives(pieces))
    if any(piece.kind == "borne" for piece in pieces):
        raise Unclear  # what is put on a step is no step
    check_listed(pieces)
    check_owned(pieces, ("way", "low", "place", "end"))
    _check_figure(pieces)
    _check_rainbow(pieces)
    steps = _steps(pieces)
    total = one(pieces, "total")
    size = total.value if total else None
    if steps and size not in (None, steps * (steps + 1) // 2):
        raise Unclear
    size = steps * (steps + 1) // 2 if steps else size
    steps = steps or next((n for n in range(2, 8) if size == n * (n + 1) // 2), None)
    way = _way(pieces)
    if (one_of(pieces, "then") or one_of(pieces, "own")) and not _in_order(pieces) and not one_of(pieces, "place"):
        raise Unclear
    hues = one(pieces, "hues")
    if hues:
        blocks, parts = "", _by_height(pieces, hues.value, steps)
    else:
        blocks, parts = ("", _ordered(pieces)) if _in_order(pieces) else _looks(pieces, steps, size)
    text = f"Build a staircase{f' of {steps} steps' if steps else ''}{blocks}{f' rising to the {way}' if way else ''}."
    over = [look for part, look in parts if part == "over it"]
    text += f" Put a {over[0]} block on top of the staircase." if over else ""
    rest = [(part, look) for part, look in parts if part != "over it"]
    said = [f"the {part} {'are' if part == 'rest' else 'is'} {look}" for part, look in rest]
    text += (
        f" {', '.join(said[:-1])}{' and ' if len(said) > 1 else ''}{said[-1]}.".replace(" the", " The", 1)
        if said
        else ("")
    )
    where = one(pieces, "where")
    return f"{text} The staircase is {where.value}." if where else text


def _check_figure(pieces: Sequence[Piece]) -> None:
    """One staircase is to be built.

    Raises:
        Unclear: there are none or several, it may be there already, or more is asked for.
    """
    at = [n for n, piece in enumerate(pieces) if piece.kind in ("figure", "steps", "heights")]
    figures = [n for n in at if pieces[n].kind == "figure"]
    named = [n for n in figures if pieces[n].words != "steps"]
    if (
        not named
        and not any("stairs" in pieces[n].words for n in at)
        and not (
            (figures or any("step" in pieces[n].words for n in at))
            and (one_of(pieces, "heights") or one_of(pieces, "way"))
        )
    ):
        raise Unclear
    again = [
        n for n in figures[1:] if pieces[n - 1].words not in ("the", "this", "that") and pieces[n].words != "steps"
    ]
    if again or (figures and any("staircases" in pieces[n].words or "stairways" in pieces[n].words for n in figures)):
        raise Unclear
    ahead = [piece for piece in pieces[: at[0]] if piece.words not in ("a", "an")]
    there = [p.words for p in ahead] == ["the"] and not declared(pieces[at[0] + 1 :])
    if there or ([p.words for p in ahead[-1:]] == ["and"] and len(ahead) > 1):
        raise Unclear  # "the stairs are ..." may tell of now; "a red block and stairs" is more than stairs
    if [p.words for p in ahead[-1:]] in (["on"], ["onto"], ["to"]):
        raise Unclear


def _steps(pieces: Sequence[Piece]) -> int | None:
    """How many steps there are, by all that tells it."""
    found: set[int] = {piece.value for piece in pieces if piece.kind == "steps"}
    found |= {piece.value[0] for piece in pieces if piece.kind == "top"}
    for piece in pieces:
        if piece.kind == "heights":
            heights = piece.value
            if sorted(heights) != [*range(1, len(heights) + 1)] or list(heights) not in (
                sorted(heights), sorted(heights, reverse=True)):  # fmt: skip
                raise Unclear
            found.add(len(heights))
    ends = [piece.value for piece in pieces if piece.kind == "end"]
    if ends:
        if len(ends) != 2 or min(ends)[0] != 1 or OVER[ends[0][1]] != ends[1][1]:
            raise Unclear
        found.add(max(ends)[0])
    lots = [count for piece in pieces if piece.kind == "lot" if (count := lot_of(piece).count)]
    if not found and len(lots) > 2 and sorted(lots) == [*range(1, len(lots) + 1)]:
        found.add(len(lots))
    if len(found) > 1 or any(n < 2 for n in found):
        raise Unclear
    return found.pop() if found else None


def _way(pieces: Sequence[Piece]) -> str:
    """Where it rises to.

    Raises:
        Unclear: it rises two ways, or blocks are listed in an order of which nothing is said.
    """
    ways = {piece.value for piece in pieces if piece.kind == "way"}
    ways |= {piece.value[1] for piece in pieces if piece.kind == "top"}
    ends = [piece.value for piece in pieces if piece.kind == "end"]
    ways |= {max(ends)[1]} if ends else set()
    order = one(pieces, "order")
    if order:
        heights = one(pieces, "heights")
        lots = [count for piece in pieces if piece.kind == "lot" if (count := lot_of(piece).count)]
        if not heights and not (len(lots) > 2 and sorted(lots) == [*range(1, len(lots) + 1)]):
            raise Unclear
        ways |= {order.value if (heights.value if heights else lots)[0] == 1 else OVER[order.value]}
    if len(ways) > 1:
        raise Unclear
    return ways.pop() if ways else ""


def one_of(pieces: Sequence[Piece], kind: str) -> bool:
    """Whether there is a piece of a kind."""
    return any(piece.kind == kind for piece in pieces)


def _in_order(pieces: Sequence[Piece]) -> bool:
    """Whether the looks of the steps are listed one after the other."""
    listed = [lot_of(piece) for piece in pieces if piece.kind == "lot"]
    led = any(one_of(pieces, kind) for kind in ("own", "order", "then", "piled")) or _one_by_one(pieces)
    return led and len({lot.look for lot in listed}) > 1 and not one_of(pieces, "place")


def _one_by_one(pieces: Sequence[Piece]) -> bool:
    """ "Stairs: one red, two orange, three yellow": such numbers behind a colon are those of the steps."""
    colon = next((n for n, piece in enumerate(pieces) if piece.words == ":"), len(pieces))
    counts = [lot_of(piece).count or 0 for piece in pieces[colon:] if piece.kind == "lot"]
    return len(counts) > 2 and sorted(counts) == [*range(1, len(counts) + 1)]


def _check_rainbow(pieces: Sequence[Piece]) -> None:
    """ "Rainbow stairs: one red, two orange, three yellow".

    Raises:
        Unclear: no colours are listed, or not in that order.
    """
    if one(pieces, "rainbow"):
        hues = [RAINBOW.index(look) if (look := lot_of(p).look) in RAINBOW else -1 for p in pieces if p.kind == "lot"]
        if len(hues) < 3 or -1 in hues or hues not in (sorted(hues), sorted(hues, reverse=True)):
            raise Unclear


def _ordered(pieces: Sequence[Piece]) -> list[tuple[str, str]]:
    """The looks of steps that are listed: one block, then two, then three.

    Raises:
        Unclear: so many blocks make no steps.
    """
    lots = [lot_of(piece) for piece in pieces if piece.kind == "lot"]
    ahead = {lot.look for lot in lots if lot.count is None}
    lots = [lot for lot in lots if lot.count]
    counts = [lot.count or 0 for lot in lots]
    if ahead not in (set(), {lot.look for lot in lots}) or not 1 < len(lots) <= len(NTH):
        raise Unclear
    if sorted(counts) != [*range(1, len(lots) + 1)] or counts not in (sorted(counts), sorted(counts, reverse=True)):
        raise Unclear
    return [
        (f"{nth} step", lot.look) for nth, lot in zip(NTH, sorted(lots, key=lambda lot: lot.count or 0), strict=False)
    ]


def _by_height(pieces: Sequence[Piece], hues: Sequence[str], steps: int | None) -> list[tuple[str, str]]:
    """The looks of the steps whose heights are listed, each with its colour.

    Raises:
        Unclear: they are as many as neither, or it is not told which is which.
    """
    heights = one(pieces, "heights")
    if not heights or len(hues) != steps or steps > len(NTH) or one_of(pieces, "lot") or one_of(pieces, "place"):
        raise Unclear
    rising = hues if heights.value[0] == 1 else hues[::-1]
    return [(f"{nth} step", look) for nth, look in zip(NTH, rising, strict=False)]


def _looks(pieces: Sequence[Piece], steps: int | None, size: int | None) -> tuple[str, list[tuple[str, str]]]:
    """ "from 6 red blocks", or which step has which look.

    Raises:
        Unclear: it is not told of each block, or the numbers do not agree.
    """
    free, placed = placed_lots(pieces)
    over = [lot for lot, part in placed if part == "over it"]
    if over:
        if len(placed) > 1 or over[0].count not in (None, 1) or over[0].look in [lot.look for lot in free]:
            raise Unclear
        if not free or (free[0].count is None and not steps) or (steps and free[0].count not in (None, size)):
            raise Unclear  # is it one of the blocks of the stairs?
        placed = []
    if len({lot.look for lot, _ in placed}) == 1 and not free and steps and len(placed) == steps:
        free, placed = [Lot(placed[0][0].look)], []
    if placed:
        named = [part for _, part in placed]
        inferred = not steps and len(named) > 1 and sorted(named) == sorted(f"{nth} step" for nth in NTH[: len(named)])
        if inferred:
            steps, size = len(named), len(named) * (len(named) + 1) // 2
        if not steps or size is None:
            raise Unclear
        parts = _parts(free, placed, steps, size)
        by_steps = all(part.endswith(" step") for part, _ in parts) and not inferred
        return ("" if by_steps else f" from {size} blocks"), parts
    if len(free) > 1:
        raise Unclear  # which of them are where?
    lots = counted(free, size)
    if lots:
        return f" from {lots[0].blocks}", [("over it", lot.look) for lot in over]
    return (f" from {size} blocks" if size and not steps else ""), []


def _parts(free: list[Lot], placed: list[tuple[Lot, str]], steps: int, size: int) -> list[tuple[str, str]]:
    """The looks of the steps: each one's, or those of some and of the rest."""
    high = {"lowest step": 1, "middle step": 2, "highest step": steps, "top block of the highest step": 1}
    numbered = {f"{nth} step": n for n, nth in enumerate(NTH, 1)}
    high |= numbered
    if len({numbered.get(part, high.get(part, 0)) for _, part in placed if part.endswith(" step")}) < sum(
        part.endswith(" step") and not part.startswith("top block") for _, part in placed
    ):
        raise Unclear  # one step is told twice
    if any(numbered.get(part, 0) > steps for _, part in placed):
        raise Unclear
    parts = [part for _, part in placed]
    if len(set(parts)) < len(parts) or len(free) > 1 or ("middle step" in parts and steps != 3):
        raise Unclear
    said = sum(high.get(part, 0) for part in parts)
    for lot, part in placed:
        if lot.count not in (None, high.get(part, size - said)):
            raise Unclear
    if free and (free[0].count not in (None, size - said) or "rest" in parts):
        raise Unclear
    if {"highest step", "top block of the highest step"} <= set(parts):
        raise Unclear
    rest = [("rest", free[0].look)] if free else []
    found = [*((part, lot.look) for lot, part in placed), *rest]
    if said < size and all(part != "rest" for part, _ in found):
        raise Unclear
    return sorted(found, key=lambda item: item[0] == "rest")
