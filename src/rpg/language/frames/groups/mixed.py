"""Groups of several looks: strangers told by the group that they are in, "by colour, but with one blue block among the
red ones", and what each group has."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from itertools import pairwise

from rpg.language.frames.groups.shared import listed, said_of
from rpg.language.frames.lots import Lot, counted, lot_of, one
from rpg.language.frames.pieces import Piece, Unclear, number, patterns

_LEADS = (
    "with|has|have|there is|there are|let|leave|leaving|keep|keeping|put|putting|place|placing|hide|hiding|slip|"
    "slipping|sneak|sneaking|mix|mixing|add|adding|and|so that|such that"
)
_GOES = (
    "(?:(?:is|are|be|being|must|should|shall|has to|have to|may|will|to|left|put|placed|kept|mixed|hidden|sneaked|"
    "slipped|hides?|hiding|sits?|sitting|stands?|standing|lies?|lying|goes|go|belongs?|ends up|end up|stays?) )*"
)
MIXED = patterns(
    "mixed", lambda match: (match["color"], number(match["count"] or "1"), match["other"]),
    f"(?:(?:{_LEADS}) )*(?:(?:exactly |just |only |a |an )*(?P<count>NUM)(?: of the)?|an?) (?P<color>COLOR)s? "
    f"(?:(?:stranger|outlier|intruder|misfit|BLOCK|ones?|odd one out) )?{_GOES}(?:in|into|among|amongst|inside|with|"
    "to) the (?P<other>COLOR)s? ?(?:ones|BLOCK|group|pile|cluster|bunch|heap|lot)?",
)  # fmt: skip
"""Kind "mixed": which blocks are where others are, and how many."""
_STRANGER = "(?:stranger|outlier|intruder|misfit|spy|impostor|odd one out|exception)"
SNEAKED = patterns(
    "glue", None,
    "(?:that (?:is|has been) )?(?:mixed|sneaked|snuck|thrown|slipped|smuggled|hidden|hiding) (?:in|in (?:it|there)|"
    f"among them|between them)|among them|as (?:the|a|an|its) (?:(?:only|single|lone) )?{_STRANGER}",
)  # fmt: skip
"""What is said of a block of a group that looks unlike the others of it, besides that it is there."""
EXCEPT = patterns("except", None, "except for|except|save for|apart from|but for")
"""Kind "except": what stands behind it is there as well, "all blue except for a single green one"."""


def excepted(pieces: Sequence[Piece]) -> list[Piece]:
    """Pieces with the exceptions to what all of a group are as further blocks of it.

    Raises:
        Unclear: it is told how many all of them are, with the exception or without it.
    """
    found = list(pieces)
    for n, piece in enumerate(pieces):
        if piece.kind != "except":
            continue
        around = [p for p in (*pieces[max(n - 1, 0) : n], *pieces[n + 1 : n + 2]) if p.kind == "lot"]
        if len(around) != 2 or "count" in around[0].named or lot_of(around[1]).count is None:
            raise Unclear
        found[n] = replace(piece, kind="glue")
    return found


def among_others(pieces: Sequence[Piece], lots: Sequence[Lot]) -> list[list[Lot]]:
    """The groups of lots of one colour each, when the strangers have gone to those of others.

    Raises:
        Unclear: no group is of that colour, it is told twice, or none of a colour stay with each other.
    """
    mixed = [piece.value for piece in pieces if piece.kind == "mixed"]
    if any(piece.kind in ("strange", "every") for piece in pieces):
        raise Unclear
    groups = {lot.look: [lot] for lot in lots}
    if len(groups) < len(lots) or len({(color, other) for color, _, other in mixed}) < len(mixed):
        raise Unclear
    for color, many, other in mixed:
        if other not in groups or color not in groups or color == other:
            raise Unclear
        groups[color][0] = replace(groups[color][0], count=(groups[color][0].count or 0) - many)
        groups[other].append(Lot(color, many))
    if any((group[0].count or 0) < 1 for group in groups.values()):
        raise Unclear
    return list(groups.values())


EACH_HAS = [
    *patterns(
        "lot", None,
        "(?:exactly |just |only )*(?P<count>NUM) (?P<noun>BLOCK) (?:is|are|must be|should be|has to be|shall be) "
        "(?P<color>COLOR)(?! BLOCK)",
        "(?:the|all the|all) (?:others|rest|(?:other|remaining) (?:ones|BLOCK|(?P<count>NUM)(?: BLOCK| ones)?)) "
        "(?:(?:is|are|be|being|must|should|shall|has to|have to|all) )*(?P<color>COLOR)(?P<many>)(?! BLOCK)",
    ),
    *patterns("figure", None, "(?:in|into|as|to) pairs"),
    *patterns("every", None, "(?:in |of |within )?(?:each|every) pair(?: (?:BE|has|have|contains|gets))?",
              "(?:added|put|placed|joined) to (?:each|every one|both)(?: of them| of these)?"),
    *patterns("each", lambda match: number(match["count"]), "(?P<count>NUM) (?:BLOCK )?of either(?: kind| color)?"),
]  # fmt: skip
"""What each of several groups has: "in each group exactly one block is white, the others are brown"."""
_PAIR = 2
_OF_EACH = {"lot", "each", "every", "figure", "size", "total", "stop", "break", "glue", "parted", "even", "from"}


def each_alike(pieces: Sequence[Piece]) -> str | None:
    """So many groups with the same blocks, where these are told of each at once; None where they are not.

    Raises:
        Unclear: it is open how many groups there are, or the blocks that there are do not make them.
    """
    every = [n for n, piece in enumerate(pieces) if piece.kind == "every"]
    kinds = {piece.kind for piece in pieces}
    if len(every) != 1 or kinds - _OF_EACH:
        return None
    stop = next((n for n in range(every[0], len(pieces)) if pieces[n].kind == "stop"), len(pieces))
    figure = max((n for n in range(every[0]) if pieces[n].kind == "figure"), default=-1)
    each = [piece for piece in pieces[every[0] : stop] if piece.kind in ("lot", "each")]
    begin = every[0] if each else figure  # "two groups of three black blocks, with one white block in each"
    each = each or [piece for piece in pieces[begin + 1 : every[0]] if piece.kind == "lot"]
    stocked = [piece for piece in pieces[: max(begin, 0)] if piece.kind == "lot"]
    if not each or len(each) + len(stocked) < sum(piece.kind in ("lot", "each") for piece in pieces):
        raise Unclear
    lots, stock = ([lot_of(piece) for piece in part if piece.kind == "lot"] for part in (each, stocked))
    lots = lots or [replace(lot, count=each[0].value) for lot in stock]
    count = _how_many(pieces)
    size = _each_size(pieces, count)
    if count is None and (each_has := size or sum(lot.count or 0 for lot in lots)):
        count = sum(lot.count or 0 for lot in stock) // each_has or None
    there = {lot.look: (lot.count or 0) // (count or 1) for lot in stock}
    lots = counted([replace(lot, count=lot.count or there.get(lot.look) or None) for lot in lots], size)
    if count is None or any(lot.count is None for lot in lots):
        raise Unclear
    if stock and {lot.look: lot.count for lot in stock} != {lot.look: (lot.count or 0) * count for lot in lots}:
        raise Unclear
    return f"Make {count} groups, each of {said_of(lots)}."


def _each_size(pieces: Sequence[Piece], count: int | None) -> int | None:
    """How many blocks each of the groups has, if it is told."""
    for piece, behind in pairwise(pieces):
        if piece.kind == "figure" and piece.words.endswith("pairs"):
            return _PAIR
        if piece.kind == "figure" and behind.kind == "total" and behind.words.startswith("of "):
            return int(behind.value)  # "two groups of three blocks"
    size, total = one(pieces, "size"), one(pieces, "total")
    if total and count and total.value % count == 0:
        return int(total.value) // count
    return int(size.value) if size else None


def _how_many(pieces: Sequence[Piece]) -> int | None:
    """How many groups there are, if it is told."""
    told = {piece.value for piece in pieces if piece.kind == "figure" and piece.value is not None}
    if len(told) > 1:
        raise Unclear
    return told.pop() if told else None


def groups_of(groups: Sequence[Sequence[Lot]]) -> str:
    """Groups told one by one with their blocks."""
    told = listed([f"one of {said_of(lots)}" for lots in groups])
    return f"Make {len(groups)} groups, {told}."
