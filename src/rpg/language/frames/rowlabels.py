"""One row, line or column of letters and digits, perhaps with coloured blocks among them."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from dataclasses import replace

from rpg.language.frames import labelwords, rowwords, shared
from rpg.language.frames.arranged import OPPOSITE, Fact
from rpg.language.frames.lots import LOTS, Lot, lot_of, one
from rpg.language.frames.pieces import Pattern, Piece, Unclear, number
from rpg.language.frames.row import check_lots, check_words, noun_of, order_of, set_off
from rpg.language.frames.rowplaces import Said, said_of
from rpg.language.frames.rowtold import Row, in_words

PATTERNS: list[Pattern] = [
    *labelwords.LABELS,
    *labelwords.KINDS,
    *labelwords.SORTED,
    *labelwords.RELATIONS,
    *labelwords.WORDS,
    *LOTS,
    *rowwords.FIGURE,
    *rowwords.PLACES,
    *rowwords.DIRECTIONS,
    *rowwords.SPACING,
    *rowwords.WHERE,
    *rowwords.WORDS,
    *shared.WHERE,
    *shared.BREAKS,
    *shared.GLUE,
]
_KIND = {
    "even": frozenset("02468"),
    "odd": frozenset("13579"),
    "vowel": frozenset("AEIOU"),
    "consonant": frozenset("BCDFGHJKLMNPQRSTVWXYZ"),
    "letter": frozenset("ABCDEFGHIJKLMNOPQRSTUVWXYZ"),
    "digit": frozenset("0123456789"),
}
_NAMES = {"even": "even numbers", "odd": "odd numbers", "vowel": "vowels", "consonant": "consonants",
          "letter": "letters", "digit": "digits"}  # fmt: skip


def told(pieces: Sequence[Piece]) -> str:
    """The row in plain sentences.

    Raises:
        Unclear: it is not told which blocks it is made of, or what is told of their order does not agree.
    """
    pieces = expanded(pieces)
    check_lots(pieces)
    check_words(pieces)
    check_numbers(pieces)
    row = Row(noun_of(pieces), "", "")
    direction, total, sort, kinds = (one(pieces, kind) for kind in ("direction", "total", "sort", "kinds"))
    row.direction = direction.value if direction else ""
    lots_at = _lots_at(pieces)
    if not lots_at:
        return _unnamed(row, pieces)
    said = said_of(pieces, lots_at)
    row.set_off = bool(said.lists) and set_off(pieces, next(n for n, lot in lots_at.items() if lot is said.lists[-1][0]))
    row.facts = _facts(said)
    labels = _labels(said, pieces, row)
    row.counts = Counter(labels)
    if (total and total.value != len(labels)) or not any(len(label) == 1 for label in labels):
        raise Unclear
    if any(piece.kind == "alternate" for piece in pieces):
        if sort or kinds or row.direction or row.facts or len(said.lists) != 1:
            raise Unclear
        return in_words(row, pieces, _Labelled, f"Lay {_Labelled.blocks(row.counts)} in a {row.noun} in which letters and digits alternate.")
    sorting = bool(sort or kinds) or any(piece.kind == "backwards" for piece in pieces)
    if not sorting:
        row.order = order_of(pieces, said, row)
    if any(piece.kind == "free" for piece in pieces) and (sorting or row.order):
        raise Unclear
    text = _sorted(row, labels, said, pieces) if sorting else in_words(row, pieces, _Labelled)
    return " ".join([text, *_relations(pieces, labels)])


def expanded(pieces: Sequence[Piece]) -> list[Piece]:
    """The pieces with each range as the list of its labels, and "the largest" as the label that it is.

    Raises:
        Unclear: a range or a largest of nothing.
    """
    found: list[Piece] = []
    for piece in pieces:
        if piece.kind != "range":
            label = {"label": piece.named["label"].strip("'").upper()} if "label" in piece.named else {}
            found.append(replace(piece, named={**piece.named, **label}))
            continue
        labels: list[str] = piece.value
        known = [other.named["label"] for other in found if "label" in other.named]
        if len(labels) < 2 or (known and sorted(known) != sorted(labels)):
            raise Unclear
        if labels != sorted(labels) or known:
            found.append(Piece("sort", piece.words, "up" if labels == sorted(labels) else "down"))
        for n, label in enumerate([] if known else labels):
            found += [Piece("break", ",")] * (n > 0) + [Piece("lot", label, None, {"label": label})]
    digits = sorted({piece.named["label"] for piece in found if "label" in piece.named})
    for n, piece in enumerate(found):
        if piece.kind == "extreme":
            if len(digits) < 2 or not _KIND["digit"].issuperset(digits):
                raise Unclear
            which = digits[0 if piece.value == "low" else -1]
            found[n] = Piece("lot", piece.words, None, {"label": which, "det": "the"})
    return found


def check_numbers(pieces: Sequence[Piece]) -> None:
    """A digit is a label, not a number of blocks, and "a" is no letter.

    Raises:
        Unclear: it may be ("a row of 3: A, B, C").
    """
    labels = sum("label" in piece.named for piece in pieces)
    ahead = Piece("", "")
    for piece, after in zip(pieces, [*pieces[1:], Piece("break", "")], strict=True):
        if piece.words.isdigit() and "label" in piece.named:
            of = ahead.words.split()[-1:] == ["of"] or ahead.kind in ("figure", "mention")
            if after.words == ":" or (of and int(piece.words) == labels - 1):
                raise Unclear
        if piece.words in ("a", "i") and piece.kind == "glue" and after.kind == "break":
            raise Unclear
        ahead = piece


def _lots_at(pieces: Sequence[Piece]) -> dict[int, Lot]:
    """What the pieces name, by where they stand.

    Raises:
        Unclear: several coloured blocks whose number is left open.
    """
    found = {}
    for n, piece in enumerate(pieces):
        if piece.kind != "lot":
            continue
        named = piece.named
        if "label" not in named:
            lot = lot_of(piece)
            if lot.plural and lot.count is None:
                raise Unclear
            found[n] = replace(lot, count=lot.count or 1)
        else:
            found[n] = Lot(named["label"], number(named["count"].replace("an", "one")) if named.get("count", "a") != "a" else 1,
                           named.get("det") == "the")  # fmt: skip
    return found


def _facts(said: Said) -> list[Fact]:
    """What is told of places: see `arranged.filled`.

    Raises:
        Unclear: one block at two places.
    """
    for placed in said.placed:
        if placed.place[0] in ("ends", "each end", "sides") and (len(placed.lot.look) == 1 or placed.lot.count != 2):
            raise Unclear
    return [(*placed.place, placed.lot.look, placed.lot.count or 1) for placed in said.placed]


def _labels(said: Said, pieces: Sequence[Piece], row: Row) -> list[str]:
    """All blocks: those of the list, or of two lists of the same, and those told only with their place.

    Raises:
        Unclear: the lists differ, or "the A" where no A is told.
    """
    lists = [[lot.look for lot in run for _ in range(lot.count or 1)] for run in said.lists]
    if any(Counter(listed) != Counter(lists[0]) for listed in lists[1:]):
        raise Unclear
    found = lists[0] if lists else []
    for placed in said.placed:
        if placed.lot.look not in found:
            if placed.lot.known and lists:
                raise Unclear
            found = [*found, *[placed.lot.look] * (placed.lot.count or 1)]
    return found


def _unnamed(row: Row, pieces: Sequence[Piece]) -> str:
    """Blocks of which no label is told.

    Raises:
        Unclear: it is not told how many of which kind there are, or more than how they are sorted.
    """
    total, sort = one(pieces, "total"), one(pieces, "sort")
    kinds = {kind for kind in ("letter", "digit") for piece in pieces if piece.kind == "total" and kind in piece.words}
    if not total or len(kinds) != 1 or any(piece.kind in ("place", "kinds", "relation", "alternate") for piece in pieces):
        raise Unclear
    kind = kinds.pop()
    lay = f"Lay {total.value} {kind} blocks in a {row.noun}"
    order = _sort_in_words(sort.value, kind) if sort else ""
    row.size = total.value
    return in_words(row, pieces, _Labelled, f"{lay}{order}{f' {row.direction}' if row.direction else ''}.")


def _sort_in_words(sort: str, kind: str) -> str:
    if sort == "listed":
        raise Unclear
    if kind == "letter":
        return f" in {'reverse ' if sort == 'down' else ''}alphabetical order"
    return f" in {'de' if sort == 'down' else 'a'}scending order"


def _sorted(row: Row, labels: list[str], said: Said, pieces: Sequence[Piece]) -> str:
    """A row whose order follows from how it is sorted.

    Raises:
        Unclear: what is told of its order does not agree.
    """
    sort, kinds = one(pieces, "sort"), one(pieces, "kinds")
    toward = {piece.named["toward"] for piece in pieces if "toward" in piece.named}
    if toward and not row.direction:
        row.direction = {"right": "from left to right", "left": "from right to left"}[toward.pop()]
    toward_end = f"to {toward.pop()}" if toward else ""
    if not row.direction.endswith(toward_end) or any(piece.kind == "alternate" for piece in pieces):
        raise Unclear
    if any(piece.kind == "each kind" for piece in pieces) and not kinds:
        raise Unclear
    order = _order(labels, sort.value if sort else "", kinds.value if kinds else (), pieces)
    if order is None:
        if row.facts or row.noun == "column" or len(said.lists) > 1:
            raise Unclear
        ahead, behind = kinds.value if kinds else ("", "")
        order_said = f"with the {_NAMES[ahead]} before the {_NAMES[behind]}"
        text = f"Lay {_Labelled.blocks(row.counts)} in a {row.noun} {row.direction or 'from left to right'} {order_said}."
        return in_words(row, pieces, _Labelled, text)
    if len(said.lists) > 1 and [lot.look for lot in said.lists[-1]] != order:
        raise Unclear
    return _told_sorted(row, order, sort.value if sort and not kinds else "", pieces)


def _order(labels: list[str], sort: str, kinds: tuple[str, ...], pieces: Sequence[Piece]) -> list[str] | None:
    """The labels in the order in which they are told to be; None where it is only told which kind is ahead.

    Raises:
        Unclear: labels that cannot be sorted so.
    """
    if any(piece.kind == "backwards" for piece in pieces):
        if sort or kinds:
            raise Unclear
        return labels[::-1]
    groups = [[label for label in labels if label in _KIND[kind]] for kind in kinds] or [labels]
    if sum(map(len, groups)) != len(labels) or not all(groups):
        raise Unclear
    if any(not (_KIND["letter"].issuperset(group) or _KIND["digit"].issuperset(group)) for group in groups):
        raise Unclear
    if not sort:
        return None
    if sort == "listed" and labels != sorted(labels):
        raise Unclear
    return [label for group in groups for label in sorted(group, reverse=sort == "down")]


def _told_sorted(row: Row, order: list[str], sort: str, pieces: Sequence[Piece]) -> str:
    """A row with a known order, and perhaps places that tell its direction.

    Raises:
        Unclear: the places do not agree with it.
    """
    if not row.direction and not row.facts and sort:
        kind = "letter" if order[0] in _KIND["letter"] else "digit"
        text = f"Lay {_Labelled.blocks(row.counts)} in a {row.noun}{_sort_in_words('up' if sort == 'listed' else sort, kind)}."
        return in_words(row, pieces, _Labelled, text)
    ways = [row.direction] if row.direction else _ways(row)
    found = []
    for way in ways:
        turned = Row(row.noun, way, "", row.counts, order, row.facts)
        try:
            found.append(in_words(turned, pieces, _Labelled))
        except Unclear:
            continue
    if not found or (len(found) > 1 and row.noun == "line" and not any(name in OPPOSITE for name, *_ in row.facts)):
        raise Unclear
    return found[0]


def _ways(row: Row) -> list[str]:
    """The directions in which it may be read, the usual one first."""
    if row.near == "front":
        return ["from front to back", "from back to front"]
    return ["from left to right", "from right to left"]


def _relations(pieces: Sequence[Piece], labels: Sequence[str]) -> list[str]:
    """What is told of two of the blocks.

    Raises:
        Unclear: they are not among the blocks of the row.
    """
    found = []
    for x, relation, y in (piece.value for piece in pieces if piece.kind == "relation"):
        if x == y or labels.count(x) != 1 or labels.count(y) != 1:
            raise Unclear
        found.append(f"The {x} block is {relation} the {y} block.")
    return found


class _Labelled:
    """How blocks with labels, and coloured ones among them, are told."""

    @staticmethod
    def blocks(counts: Counter[str]) -> str:
        """All of them."""
        labels = [look for look, many in counts.items() for _ in range(many) if len(look) == 1]
        colored = [Lot(look, many).blocks for look, many in counts.items() if len(look) > 1]
        told = [f"the block{'s' * (len(labels) > 1)} {' and '.join([', '.join(labels[:-1]), labels[-1]] if len(labels) > 1 else labels)}"]
        return " and ".join([*told, *colored])

    @staticmethod
    def the(look: str) -> str:
        """The only one of a look."""
        return f"the {look} block"

    @staticmethod
    def an(look: str) -> str:
        """One of several."""
        return f"{'an' if look[0] in 'aeiouAEFHILMNORSX8' else 'a'} {look} block"
