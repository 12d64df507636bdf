"""What is told of the floors of one tower, ready to be put in order."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from dataclasses import replace
from itertools import pairwise

from rpg.language.frames.lots import one
from rpg.language.frames.pieces import Piece, Unclear
from rpg.language.frames.towers.floor_parts import item_of
from rpg.language.frames.towers.floors import floors
from rpg.language.lexicon import COMMANDS

_BOTTOM = ("bottom", 1)
_FEWEST = 2


def looks_of(pieces: Sequence[Piece], way: Piece | None, size: int | None = None) -> list[str]:
    """The looks of the blocks of one tower, from bottom to top. `size`: how many there are, if that is told elsewhere.

    Raises:
        Unclear: it does not follow what is where.
    """
    kinds = [piece.kind for piece in pieces]
    if "where" in kinds and "upon" in kinds[kinds.index("where") :]:
        raise Unclear  # "three red blocks on the mat, a green one on it": on the mat, or on them?
    total = one(pieces, "total")
    if total and size not in (None, total.value):
        raise Unclear
    size = total.value if total else size
    looks = floors(_without_stock(_on_the_ground(pieces)), way.value if way else None, size)
    absent = {piece.value for piece in pieces if piece.kind == "absent"}
    if len(looks) < _FEWEST or any(look.split()[-1] in absent for look in looks) or _commanded(pieces):
        raise Unclear
    return looks


def _commanded(pieces: Sequence[Piece]) -> bool:
    """ "Then put ...": what is done one after the other, which is more than where it is in the end."""
    return any(a.kind == "then" and b.words in COMMANDS for a, b in pairwise(pieces))


def _on_the_ground(pieces: Sequence[Piece]) -> list[Piece]:
    """A block on the table or on a patch is the lowest one."""
    found: list[Piece] = []
    for n, piece in enumerate(pieces):
        before = next((p.kind for p in reversed(pieces[:n]) if p.kind != "glue"), "")
        ground = piece.kind in ("table", "where") and before == "item"
        found.append(replace(piece, kind="part", value=_BOTTOM) if ground else piece)
    return found


def _without_stock(pieces: Sequence[Piece]) -> list[Piece]:
    """The list behind "from bottom to top", where the same blocks are told ahead of it.

    Raises:
        Unclear: other blocks are.
    """
    at = next((n for n, piece in enumerate(pieces) if piece.kind == "way"), 0)
    ahead, behind = list(pieces[:at]), list(pieces[at:])
    stock, listed = ([item_of(p) for p in part if p.kind == "item"] for part in (ahead, behind))
    if not stock or not listed:
        return list(pieces)
    counts = [Counter[str](), Counter[str]()]
    for count, items in zip(counts, (stock, listed), strict=True):
        for item in items:
            count[item.look] += item.count or 1
    if counts[0] != counts[1] or any(item.count is None and item.plural and item.known for item in stock):
        raise Unclear
    return [*(piece for piece in ahead if piece.kind != "item"), *behind]
