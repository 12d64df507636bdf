"""What two things are to each other, where it stands ahead of them."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from rpg.language.frames.pieces import Piece
from rpg.language.frames.relations.reading import Parse, Statement, behind_verbs, kind_at, lists, words_at
from rpg.language.frames.relations.words import Relation


def of_two(pieces: Sequence[Piece], at: int) -> Iterator[Parse]:
    """What two things are to each other, where it stands ahead of them."""
    kind, first = kind_at(pieces, at), pieces[at] if at < len(pieces) else None
    if first is None:
        return
    if kind == "rel" and first.value == Relation("between", count=2):
        for named, end in lists(pieces, at + 1):
            wide = behind_verbs(pieces, end + (kind_at(pieces, end) == "comma"))
            wide = behind_verbs(pieces, wide + (kind_at(pieces, wide) == "there"))
            if kind_at(pieces, wide) == "width":
                how, what = pieces[wide].value
                yield (Statement(named, "gap" if how == "gap" else "mutual", what),), wide + 1
        return
    if kind == "width":
        how, what = first.value
        yield (Statement((Piece("they", "they"),), "gap" if how == "gap" else "mutual", what),), at + 1
    if kind not in ("apart", "gap", "between", "swap"):
        return
    for named, end in lists(pieces, at + 1):
        if kind in ("apart", "gap"):
            yield (Statement(named, "mutual" if kind == "apart" else "gap", first.value),), end
        if kind == "swap":
            yield (Statement(named, "mutual", "swap places"),), end
            if words_at(pieces, end) == "with":
                for other, last in lists(pieces, end + 1):
                    yield (Statement((*named, *other), "mutual", "swap places"),), last
        if first.value == "from" and words_at(pieces, end) == "to":
            for other, last in lists(pieces, end + 1):
                if kind_at(pieces, last) == "measure":
                    yield (Statement((*named, *other), "mutual", f"be {pieces[last].value} apart"),), last + 1
        elif kind == "between" and kind_at(pieces, end) == "measure":
            far = pieces[end].value
            apart = first.value == "apart"
            yield (Statement(named, "mutual" if apart else "gap", f"be {far} apart" if apart else far),), end + 1
