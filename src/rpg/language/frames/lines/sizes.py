"""Blocks of a row that are told by their size alone, and rows that are sorted by size."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from rpg.language import lexicon
from rpg.language.frames.pieces import Pattern, Piece, Unclear, patterns

_SIZED = "(?P<color>SIZE|medium|normal)(?: sized)?"
_TO = "(?:to|up to|down to|towards?|until|→)"
_LOW = "(?:the )?(?:small|smallest|smaller|little|littlest|tiny|tiniest)(?: (?:one|BLOCK))?"
_HIGH = "(?:the )?(?:big|biggest|bigger|large|largest|larger)(?: (?:one|BLOCK))?"
_LEAST, _MOST = "(?:smallest|littlest|tiniest)", "(?:biggest|largest)"
_AT, _END = "(?:on|at|to|in) the", "(?: end| side)?"
_SORTS = (
    "(?:(?:in|into|by|an|a|the|BE|sorted|sort|ordered|order|arranged|arrange|them|going|goes|go|running|runs|from|"
    "with|all|their|so that they are) )*"
)
_BLOCKS = "(?:(?:and|with|so that|each|they|which|that|the|BLOCK|must|should|to) )*"
_GET = f"{_BLOCKS}(?:get|gets|getting|become|becomes|becoming|grow|growing|grows|are|is)"
_IN_SIZE = f"{_BLOCKS}(?:their )?sizes?"
SIZED: list[Pattern] = [
    *patterns("lot", None,
        rf"(?:(?P<det>the|a|an|both the|both|the other) )?(?:(?P<count>NUM) )?(?:plain )?{_SIZED} "
        r"(?P<noun>BLOCK|ones|one)(?! in size)", rf"{_SIZED}(?= (?:[,.;)]|and|then|$))"),
    *patterns("bysize", "increasing",
        f"{_SORTS}{_LOW} {_TO} {_HIGH}", f"{_SORTS}(?:increasing|ascending|growing|rising) (?:in )?(?:order of "
        f")?sizes?",
        f"{_SORTS}(?:increasing|ascending) order (?:of|by) size", f"{_LOW} (?:BE )?first", f"{_HIGH} (?:BE "
        f")?last", f"{_GET} (?:larger|bigger)(?: in size)?", f"{_IN_SIZE} (?:increase|increasing|grow|growing)",
        f"{_BLOCKS}(?:increase|increasing|grow|growing) in size"),
    *patterns("bysize", "decreasing",
        f"{_SORTS}{_HIGH} {_TO} {_LOW}",
        f"{_SORTS}(?:decreasing|descending|shrinking|falling) (?:in )?(?:order of )?sizes?",
        f"{_SORTS}(?:decreasing|descending) order (?:of|by) size", f"{_HIGH} (?:BE )?first", f"{_LOW} (?:BE "
        f")?last", f"{_GET} smaller(?: in size)?", f"{_IN_SIZE} (?:decrease|decreasing|shrink|shrinking)",
        f"{_BLOCKS}(?:decrease|decreasing|shrink|shrinking) in size"),
    *patterns("bysize", "increasing",
        f"(?:the |with |with the )*{_LEAST}(?: (?:one|BLOCK))? (?:BE )?{_AT} (?P<side>left){_END}",
        f"(?:the |with |with the )*{_MOST}(?: (?:one|BLOCK))? (?:BE )?{_AT} (?P<side>right){_END}"),
    *patterns("bysize", "decreasing",
        f"(?:the |with |with the )*{_MOST}(?: (?:one|BLOCK))? (?:BE )?{_AT} (?P<side>left){_END}",
        f"(?:the |with |with the )*{_LEAST}(?: (?:one|BLOCK))? (?:BE )?{_AT} (?P<side>right){_END}"),
    *patterns("bysize", "", f"{_SORTS}(?:by|in order of|according to|order of) (?:their )?sizes?"),
]  # fmt: skip
"""A lot whose look is its size, and "bysize": "increasing", "decreasing", or "" where it may run either way."""
_SIZES = frozenset({*lexicon.SIZE, "medium", "normal"})


def sized(pieces: Sequence[Piece]) -> list[Piece]:
    """The pieces with the colour that is told of all blocks ("all of them red") told of each, where only their sizes
    are told else.

    Raises:
        Unclear: some blocks are told by their size and others by their colour.
    """
    lots = [piece for piece in pieces if piece.kind == "lot"]
    bare = [piece for piece in lots if piece.named.get("color") in _SIZES]
    if not bare:
        return list(pieces)
    colored = [n for n, piece in enumerate(pieces) if piece.kind == "lot" and piece.named.get("color") not in _SIZES]
    if not colored:
        return list(pieces)
    words = [word for piece in pieces[max(0, colored[0] - 3) : colored[0] + 1] for word in piece.words.split()]
    if len(colored) > 1 or "all" not in words or {"count", "noun"} & set(pieces[colored[0]].named):
        raise Unclear
    color = pieces[colored[0]].named["color"]
    return [
        replace(piece, named={**piece.named, "size": piece.named["color"], "color": color})
        if piece.kind == "lot"
        else piece
        for n, piece in enumerate(pieces)
        if n != colored[0]
    ]


def by_size(pieces: Sequence[Piece]) -> str:
    """How a row is sorted by the sizes of its blocks: "increasing" or "decreasing"; "" where it is not.

    Raises:
        Unclear: in two ways.
    """
    ways = {piece.value for piece in pieces if piece.kind == "bysize"}
    ways = ways if ways == {""} else ways - {""}
    if len(ways) > 1 or (ways and any(piece.kind in ("place", "pattern", "listed") for piece in pieces)):
        raise Unclear
    return (ways.pop() or "increasing") if ways else ""


def way(pieces: Sequence[Piece], direction: str) -> str:
    """The direction of a row; sorted with "the smallest on the left" it runs from there.

    Raises:
        Unclear: the other way.
    """
    if all("side" not in piece.named for piece in pieces if piece.kind == "bysize"):
        return direction
    if direction not in ("", "from left to right"):
        raise Unclear
    return "from left to right"
