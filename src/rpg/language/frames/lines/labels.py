"""One row, line or column of letters and digits, perhaps with coloured blocks among them."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Sequence
from dataclasses import replace
from itertools import pairwise, permutations

from rpg.language.frames import shared
from rpg.language.frames.lines import label_groups as labelgroups
from rpg.language.frames.lines import label_words as labelwords
from rpg.language.frames.lines import parts as rowparts
from rpg.language.frames.lines import plainer as rowplainer
from rpg.language.frames.lines import words as rowwords
from rpg.language.frames.lines.appended import APPENDED, append, without_appended
from rpg.language.frames.lines.arranged import Fact, filled
from rpg.language.frames.lines.ordered import KINDS, WAYS, Labelled, in_sort, in_sort_words, sort_of
from rpg.language.frames.lines.places import STOPS, Said, said_of
from rpg.language.frames.lines.row import check_lots, check_told_once, check_words, noun_of, set_off, verbal
from rpg.language.frames.lines.sentences import Row, in_words
from rpg.language.frames.lots import LOTS, Lot, lot_of, one
from rpg.language.frames.pieces import Pattern, Piece, Unclear, number

PATTERNS: list[Pattern] = [*APPENDED, *labelwords.LABELS, *labelgroups.GROUPS, *labelwords.KINDS, *labelwords.SORTED,
                           *labelwords.RELATIONS, *labelwords.WORDS,
                           *(pattern for pattern in LOTS if pattern.kind == "lot"), *rowwords.FIGURE,
                           *rowwords.PLACES, *rowwords.DIRECTIONS, *rowparts.SPACING, *rowparts.WHERE,
                           *rowparts.WORDS, *shared.WHERE, *shared.BREAKS, *shared.GLUE]  # fmt: skip


def told(pieces: Sequence[Piece]) -> str:
    """The row in plain sentences.

    Raises:
        Unclear: it is not told which blocks it is made of, or what is told of their order does not agree.
    """
    pieces, more = without_appended(pieces)
    pieces = rowplainer.listed(labelgroups.gathered(expanded(pieces)))
    check_lots(pieces)
    check_words(pieces)
    check_numbers(pieces)
    check_told_once(pieces)
    row = Row(noun_of(pieces, sorts=any(piece.kind in ("sort", "kinds") for piece in pieces)), "", "")
    pieces, direction = _without_kind_totals(pieces), one(pieces, "direction")
    total = one(pieces, "total")
    row.direction = direction.value if direction else ""
    lots_at = _lots_at(pieces)
    if not lots_at and not more and all(piece.kind != "relation" for piece in pieces):
        return _unnamed(row, pieces)
    said = said_of(pieces, lots_at)
    row.set_off = bool(said.lists) and set_off(
        pieces, next(n for n, lot in lots_at.items() if lot is said.lists[-1][0])
    )
    row.facts = _facts(said)
    if not said.lists and total:
        said = _spanned(said, total.value)
    labels = labels_of(said, [piece.value for piece in pieces if piece.kind == "relation"])
    row.counts = Counter(labels)
    check_nouns(pieces, labels)
    if total and total.value != len(labels):
        raise Unclear
    kinds = {piece.kind for piece in pieces}
    if "alternate" in kinds:
        return _alternating(row, pieces)
    sort = sort_of(pieces, labels)
    if sort or kinds & {"kinds", "backwards"}:
        check_sorted(pieces, said)
        if sort == "either" and row.near != "front" and all("extreme" not in piece.named for piece in pieces):
            sort = "up"
        text = in_sort(row, sort, labels, said, pieces)
    else:
        row.order = _listed(pieces, said, row) or _following(row, pieces, labels)
        if row.order is None and row.direction and "relation" in kinds:
            raise Unclear
        if (
            row.order is None
            and {"left", "right"} <= {fact[0] for fact in row.facts}
            and len(labels) > len(row.facts) + 1
        ):
            raise Unclear  # "with D at the left and A at the right": as if it were sorted
        text = in_words(row, pieces, Labelled())
    if more:
        append(row, more)
        text = in_words(row, pieces, Labelled())
    if "free" in kinds and (sort or row.order or not row.facts):
        raise Unclear
    return " ".join([text, *_relations(row, pieces, labels)])


def expanded(pieces: Sequence[Piece]) -> list[Piece]:
    """The pieces with each range as the list of its labels (and how that is sorted, if it is told "from" one "to"
    another), and "the largest" as the label that it is.

    Raises:
        Unclear: a range or a largest of nothing.
    """
    found: list[Piece] = []
    for piece, after in zip(pieces, [*pieces[1:], Piece("end", "")], strict=True):
        if (
            len(piece.words) == 3
            and piece.words.startswith("a ")
            and "label" in piece.named
            and ("label" in after.named or (found and "label" in found[-1].named))
        ):
            found.append(Piece("lot", "a", None, {"label": "A"}))  # "A B C"
            piece = replace(piece, named={"label": piece.named["label"]})
        if piece.kind == "range":
            found += _from_range(piece, [other.named["label"] for other in found if "label" in other.named])
            continue
        label = {"label": piece.named["label"].strip("'").upper()} if "label" in piece.named else {}
        found.append(replace(piece, named={**piece.named, **label}))
    digits = sorted({piece.named["label"] for piece in found if "label" in piece.named})
    for n, piece in enumerate(found):
        if piece.kind == "extreme":
            if len(digits) < 2 or not KINDS["digit"].issuperset(digits):
                raise Unclear
            which = digits[0 if piece.value == "low" else -1]
            found[n] = Piece("lot", piece.words, None, {"label": which, "det": "the", "extreme": piece.value})
    return found


def _from_range(piece: Piece, known: list[str]) -> list[Piece]:
    """What a range tells; if its labels are `known` it tells only how they are sorted."""
    labels: list[str] = piece.value
    if len(labels) < 2 or (known and sorted(known) != sorted(labels)):
        raise Unclear
    found = []
    rises = labels == sorted(labels)
    if not rises or known or {"way", "side"} & set(piece.named):
        found.append(Piece("sort", "from" if rises and not known else piece.words, "rises" if rises else "falls"))
    if "side" in piece.named:
        ends = ["left", "right"][:: 1 if piece.named["side"] == "left" else -1]
        found.append(Piece("direction", piece.words, f"from {ends[0]} to {ends[1]}"))
    for n, label in enumerate([] if known else labels):
        found += [Piece("break", ",")] * (n > 0) + [Piece("lot", label, None, {"label": label})]
    return found


def check_numbers(pieces: Sequence[Piece]) -> None:
    """A digit is a label, not a number of blocks, and "a" is no letter.

    Raises:
        Unclear: it may be ("a row of 3: A, B, C", "A, B and C in a row with 2 on the left").
    """
    labels = sum("label" in piece.named for piece in pieces)
    lone = sum(piece.named.get("label", "").isdigit() for piece in pieces) == 1
    colored = any("color" in piece.named for piece in pieces)
    ahead = Piece("", "")
    for piece, after in zip(pieces, [*pieces[1:], Piece("break", "")], strict=True):
        if piece.words.isdigit() and "label" in piece.named:
            of = ahead.words.split()[-1:] == ["of"] or ahead.kind in ("figure", "mention")
            placed = lone and "place" in (ahead.kind, after.kind)
            if after.words == ":" or placed or (of and (int(piece.words) == labels - 1 or colored)):
                raise Unclear
        if piece.words in ("a", "i") and piece.kind == "glue" and (after.kind == "break" or "label" in ahead.named):
            raise Unclear
        ahead = piece


def _without_kind_totals(pieces: Sequence[Piece]) -> list[Piece]:
    """Without "three letters and two digits", where so many are named.

    Raises:
        Unclear: they are not.
    """
    labels = [piece.named["label"] for piece in pieces if "label" in piece.named]
    told = [piece for piece in pieces if piece.kind == "total"]
    kinds = [
        kind for piece in told for kind in KINDS if re.search(rf"\b{kind}s$", piece.words.replace("number", "digit"))
    ]
    if len(kinds) != 2 or len(told) != 2 or not labels:
        return list(pieces)
    if any(
        piece.value != sum(label in KINDS[kind] for label in labels) for piece, kind in zip(told, kinds, strict=True)
    ):
        raise Unclear
    return [piece for piece in pieces if piece.kind != "total"]


def check_nouns(pieces: Sequence[Piece], labels: Sequence[str]) -> None:
    """ "Letters" are letters, "digits" digits, and "the vowels" no others; one of them at least is told.

    Raises:
        Unclear: they are not.
    """
    glue = [piece for piece in pieces if piece.kind in ("glue", "total", "range")]
    words = {word.rstrip("s") for piece in glue for word in piece.words.split()}
    named = {kind for kind in ("letter", "digit") if any(label in KINDS[kind] for label in labels)}
    words = {"digit" if word in ("number", "numeral") else word for word in words}
    told = {"letter", "digit"} & words
    if (
        any(not KINDS[kind].issuperset(labels) for kind in {"vowel", "consonant"} & words)
        or (not named and all(piece.kind != "relation" for piece in pieces))
        or not told <= named
        or ({"rising", "growing"} & {*" ".join(p.words for p in pieces).split()} and "digit" not in told)
    ):
        raise Unclear


def check_sorted(pieces: Sequence[Piece], said: Said) -> None:
    """What is sorted is the row that is to be made.

    Raises:
        Unclear: it may stand there already, in another order.
    """
    kinds = [piece.kind for piece in pieces]
    if "figure" not in kinds and any(a.kind == "mention" and b.kind == "lot" for a, b in pairwise(pieces)):
        raise Unclear
    parts: list[list[Piece]] = [[]]
    for piece in pieces:
        parts.append([]) if piece.words in STOPS and piece.kind == "break" else parts[-1].append(piece)
    for part in parts:
        there = {piece.kind for piece in part}
        again = "figure" not in there and "figure" in kinds
        if "backwards" in there and "lot" not in there:
            raise Unclear
        if (
            "sort" in there
            and again
            and not there & {"lot", "kinds"}
            and _COMMANDS & {word for piece in part for word in piece.words.split()}
        ):
            raise Unclear


_COMMANDS = frozenset({"put", "sort", "arrange", "order", "bring", "place", "set", "lay"})


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
            count = named.get("count", named.get("often", "a"))
            found[n] = Lot(named["label"], 1 if count in ("a", "an") else number(count), named.get("det") == "the")
    return found


def _spanned(said: Said, total: int) -> Said:
    """So many labels of which the first and the last are told, if just these are from one to the other."""
    looks = [placed.lot.look for placed in said.placed]
    told = {placed.place for placed in said.placed}
    labels = labelwords.between(*sorted(looks)) if len(looks) == 2 and max(map(len, looks)) == 1 else []
    if len(labels) != total or told not in ({("first", 1), ("last", 1)}, {("left", 1), ("right", 1)}):
        return said
    lots = [Lot(label, 1) for label in labels]
    return replace(said, lists=[lots], whole=[lots])


def _facts(said: Said) -> list[Fact]:
    """What is told of places: see `arranged.filled`.

    Raises:
        Unclear: one block at two places.
    """
    for placed in said.placed:
        if placed.place[0] in ("ends", "each end", "sides") and (len(placed.lot.look) == 1 or placed.lot.count != 2):
            raise Unclear
    return [(*placed.place, placed.lot.look, placed.lot.count or 1) for placed in said.placed]


def labels_of(said: Said, relations: Sequence[tuple[str, str, str]]) -> list[str]:
    """All blocks: those of the list, or of two lists of the same, and those told only with their place.

    Raises:
        Unclear: the lists differ, or "the A" where no A is told.
    """
    lists = [[lot.look for lot in run for _ in range(lot.count or 1)] for run in said.lists]
    if any(Counter(listed) != Counter(lists[0]) for listed in lists[1:]):
        raise Unclear
    found = lists[0] if lists else list(dict.fromkeys(look for x, _, y in relations for look in (x, y)))
    for placed in said.placed:
        if placed.lot.look not in found:
            if placed.lot.known and lists:
                raise Unclear
            found = [*found, *[placed.lot.look] * (placed.lot.count or 1)]
    return found


def _listed(pieces: Sequence[Piece], said: Said, row: Row) -> list[str] | None:
    """The blocks in the order in which they are listed, if this is told as an order.

    Raises:
        Unclear: there are two orders.
    """
    if not said.lists:
        return None
    figures = [n for n, piece in enumerate(pieces[:-1]) if piece.kind in ("figure", "mention") and not verbal(piece)]
    direct = any(pieces[n + 1].kind == "lot" for n in figures)
    reads = any(piece.kind == "listed" for piece in pieces)
    marked = bool(row.direction) or reads or direct or row.set_off
    order = [lot.look for lot in (said.whole if marked else said.lists)[-1] for _ in range(lot.count or 1)]
    if len(said.lists) > 1 and (not marked or all(piece.kind != "figure" for piece in pieces)):
        raise Unclear
    if reads and row.noun == "column" and not row.direction:
        raise Unclear  # whichever end is read first
    if Counter(order) != row.counts:
        if marked:
            raise Unclear
        return None
    return order if marked or len(set(order)) < len(order) else None


def _following(row: Row, pieces: Sequence[Piece], labels: list[str]) -> list[str] | None:
    """The order that follows from what is told of places and of how blocks stand to each other, if it does."""
    relations = [piece.value for piece in pieces if piece.kind == "relation"]
    if not relations or row.direction not in ("", _ACROSS) or row.near == "front" or not 2 < len(labels) < 8:
        return None
    slots = filled(len(labels), row.facts, row.near, row.first)
    orders = [
        order
        for order in permutations(labels)
        if all(told in ("", label) for told, label in zip(slots, order, strict=True))
        and all(_holds(order, *relation) for relation in relations)
    ]
    if not orders:
        raise Unclear
    if len(orders) > 1:
        return None
    row.direction = _ACROSS
    return list(orders[0])


_ACROSS = "from left to right"


def _holds(order: Sequence[str], x: str, relation: str, y: str) -> bool:
    if x not in order or y not in order:
        return False
    a, b = order.index(x), order.index(y)
    return {
        "left of": a < b,
        "right of": a > b,
        "immediately left of": a + 1 == b,
        "immediately right of": a == b + 1,
        "next to": abs(a - b) == 1,
    }.get(relation, False)


def _alternating(row: Row, pieces: Sequence[Piece]) -> str:
    """A row in which letters and digits alternate, and nothing more is told."""
    if row.facts or any(piece.kind in ("sort", "kinds", "direction", "backwards", "free") for piece in pieces):
        raise Unclear
    lay = f"Lay {Labelled().blocks(row.counts)} in a {row.noun} in which letters and digits alternate."
    return in_words(row, pieces, Labelled(), lay)


def _unnamed(row: Row, pieces: Sequence[Piece]) -> str:
    """Blocks of which no label is told.

    Raises:
        Unclear: it is not told how many of which kind there are, or more than how they are sorted.
    """
    total, sort = one(pieces, "total"), one(pieces, "sort")
    kinds = {kind for kind in ("letter", "digit") for piece in pieces if piece.kind == "total" and kind in piece.words}
    if (
        not total
        or len(kinds) != 1
        or any(piece.kind in ("place", "kinds", "relation", "alternate") for piece in pieces)
    ):
        raise Unclear
    kind = kinds.pop()
    lay = f"Lay {total.value} {kind} blocks in a {row.noun}"
    order = in_sort_words({"listed": "", **WAYS}[sort.value], kind) if sort else ""
    row.size = total.value
    return in_words(row, pieces, Labelled(), f"{lay}{order}{f' {row.direction}' if row.direction else ''}.")


def _relations(row: Row, pieces: Sequence[Piece], labels: Sequence[str]) -> list[str]:
    """What is told of two of the blocks, which are among those of the row."""
    found = []
    for x, relation, y in (piece.value for piece in pieces if piece.kind == "relation"):
        if x == y or labels.count(x) != 1 or labels.count(y) != 1:
            raise Unclear
        if row.order is None:
            found.append(f"The {x} block is {relation} the {y} block.")
        elif not _holds(row.order if row.near == row.first else row.order[::-1], x, relation, y):
            raise Unclear
    return found
