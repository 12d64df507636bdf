"""How letters and digits of a row are sorted, told in words."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence

from rpg.language.frames.lines.places import Said
from rpg.language.frames.lines.sentences import Colored, Row, in_words
from rpg.language.frames.lots import Lot, one
from rpg.language.frames.pieces import Piece, Unclear

KINDS = {
    "even": frozenset("02468"),
    "odd": frozenset("13579"),
    "vowel": frozenset("AEIOU"),
    "consonant": frozenset("BCDFGHJKLMNPQRSTVWXYZ"),
    "letter": frozenset("ABCDEFGHIJKLMNOPQRSTUVWXYZ"),
    "digit": frozenset("0123456789"),
}
_NAMES = {
    "even": "even numbers",
    "odd": "odd numbers",
    "vowel": "vowels",
    "consonant": "consonants",
    "letter": "letters",
    "digit": "digits",
}
WAYS = {
    "abc": "either",
    "listed": "either",
    "numbers": "either",
    "rises": "up",
    "up": "up",
    "zyx": "down",
    "down": "down",
    "falls": "down",
}
"""How what is told of sorting runs; "either": up, unless places tell otherwise."""


def sort_of(pieces: Sequence[Piece], labels: Sequence[str]) -> str:
    """How the labels are sorted: "up" or "down", "either" where it may run either way; "" where this is not told.

    Raises:
        Unclear: two ways, or one that is not for such labels.
    """
    told = [piece for piece in pieces if piece.kind == "sort"]
    others = [piece for piece in pieces if piece.kind in ("sort", "kinds", "backwards") and piece.words != "from"]
    values = {piece.value for piece in told if piece.words != "from" or not others}
    extremes = [n for n, piece in enumerate(pieces) if "extreme" in piece.named]
    if extremes and not values and all(piece.kind != "free" for piece in pieces):
        both = len({pieces[n].named["extreme"] for n in extremes}) > 1
        if not both:
            raise Unclear  # of the others it is not told where they are
        values = {"numbers"}
    if len(values) > 1:
        values -= {"listed"}  # "sort them from smallest to largest"
    if "listed" in values and list(labels) != sorted(labels):
        raise Unclear
    if (values & {"abc", "zyx"} and not KINDS["letter"] & set(labels)) or (
        values & {"up", "down", "numbers"} and not KINDS["digit"] & set(labels)
    ):
        raise Unclear
    ways = {WAYS[value] for value in values}
    if len(ways) > 1:
        raise Unclear
    return ways.pop() if ways else ""


def in_sort(row: Row, sort: str, labels: list[str], said: Said, pieces: Sequence[Piece]) -> str:
    """A row whose order follows from how it is sorted.

    Raises:
        Unclear: what is told of its order does not agree.
    """
    kinds = one(pieces, "kinds")
    order_said: tuple[str, str] | None
    toward = {piece.named["toward"] for piece in pieces if "toward" in piece.named}
    if toward and not row.direction:
        row.direction = "from left to right" if toward == {"right"} else "from right to left"
    if any(not row.direction.endswith(end) for end in toward) or (
        any(piece.kind == "each kind" for piece in pieces) and not kinds
    ):
        raise Unclear
    if any(piece.kind == "backwards" for piece in pieces):
        if sort or kinds or any(piece.kind == "listed" for piece in pieces):
            raise Unclear
        row.order, order_said = labels[::-1], None
    elif kinds:
        row.order, order_said = _by_kinds(labels, sort, kinds.value)
    else:
        row.order = sorted(labels, reverse=sort == "down")
        order_said = in_sort_words(sort, "letter" if labels[0] in KINDS["letter"] else "digit"), ""
        if not (KINDS["letter"].issuperset(labels) or KINDS["digit"].issuperset(labels)):
            raise Unclear
    if len(said.lists) > 1 and [lot.look for lot in said.lists[-1]] != row.order:
        raise Unclear
    row.direction = _way(row, pieces, sort, order_said is None or bool(kinds))
    if not order_said:
        return in_words(row, pieces, Labelled())
    noun = {"": row.noun, "f": "column", "b": "column"}.get(row.direction[5:6], "row")
    along = f" {row.direction}" if row.direction else ""
    return in_words(
        row,
        pieces,
        Labelled(),
        f"Lay {Labelled().blocks(row.counts)} in a {noun}{order_said[0]}{along}{order_said[1]}.",
    )


def _by_kinds(labels: list[str], sort: str, kinds: tuple[str, str]) -> tuple[list[str] | None, tuple[str, str] | None]:
    """The order of labels of two kinds, None where it is only told which kind is ahead; and how that is told.

    Raises:
        Unclear: some are of neither kind, or none of one.
    """
    groups = [[label for label in labels if label in KINDS[kind]] for kind in kinds]
    if sum(map(len, groups)) != len(labels) or not all(groups):
        raise Unclear
    order = [label for group in groups for label in sorted(group, reverse=sort == "down")] if sort else None
    if "letter" in kinds:
        return order, None
    ahead, behind = (_NAMES[kind] for kind in kinds)
    sorts = in_sort_words(sort, "digit" if "odd" in kinds else "letter") if sort else ""
    return order, (sorts, f" with the {ahead} before the {behind}")


def _way(row: Row, pieces: Sequence[Piece], sort: str, needed: bool) -> str:
    """The direction in which it is sorted; where places tell it, it is that. `needed`: one must be told.

    Raises:
        Unclear: the places do not agree.
    """
    ways = ["from front to back", "from back to front"] if row.near == "front" else list(_ACROSS)
    if not row.facts:
        return row.direction or ways[0] * needed
    if row.order is None:
        raise Unclear
    open_way = sort == "either" or row.near == "front"  # a column has no end where everyone begins
    for way in [row.direction] if row.direction else ways[: 2 if open_way else 1]:
        try:
            in_words(Row(row.noun, way, "", row.counts, row.order, row.facts), pieces, Labelled())
        except Unclear:
            continue
        return way
    raise Unclear


_ACROSS = ("from left to right", "from right to left")


def in_sort_words(sort: str, kind: str) -> str:
    """How letters or digits are sorted."""
    if kind == "letter":
        return f" in {'reverse ' if sort == 'down' else ''}alphabetical order"
    return f" in {'de' if sort == 'down' else 'a'}scending order"


class Labelled(Colored):
    """How blocks with labels, and coloured ones among them, are told."""

    @staticmethod
    def blocks(counts: Counter[str]) -> str:
        """All of them."""
        labels = [look for look, many in counts.items() for _ in range(many) if len(look) == 1]
        colored = [Lot(look, many).blocks for look, many in counts.items() if len(look) > 1]
        listed = [", ".join(labels[:-1]), labels[-1]] if len(labels) > 1 else labels
        told = [f"the block{'s' * (len(labels) > 1)} {' and '.join(listed)}"] if labels else []
        return " and ".join([*told, *colored])
