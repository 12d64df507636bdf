"""One row, line or column of coloured blocks."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Sequence
from dataclasses import replace
from itertools import pairwise, takewhile

from rpg.language.frames import shared
from rpg.language.frames.lines import parts as rowparts
from rpg.language.frames.lines import plainer as rowplainer
from rpg.language.frames.lines import sizes as rowsizes
from rpg.language.frames.lines import words as rowwords
from rpg.language.frames.lines.appended import APPENDED, append, without_appended
from rpg.language.frames.lines.counts import facts_of, facts_of_listed, numbered
from rpg.language.frames.lines.places import STOPS, Said, said_of
from rpg.language.frames.lines.sentences import Colored, Row, in_words
from rpg.language.frames.lots import LOTS, Lot, lot_of, one
from rpg.language.frames.pieces import Pattern, Piece, Unclear, patterns
from rpg.language.lexicon import RAINBOW

PATTERNS: list[Pattern] = [*LOTS,
                           *patterns("total", lambda match: int(match["n"]),
                                     r"of (?P<n>\d+)(?= (?:[,.;:(!]|with|where|that|in|from|"
                                     r"alternat\w+|touching|evenly|which|on|the) )", r"of (?P<n>\d+)(?! [a-zA-Z0-9])",
                                     r"(?:with )?(?:a )?length (?:of )?(?P<n>\d+)(?: BLOCK)?",
                                     r"(?P<n>\d+)(?: BLOCK)? long", r"(?P<n>\d+) in " r"number",
                                     r"(?P<n>\d+)(?= (?:in|on|make|making|form|forming) (?:a|one) )",
                                     r"(?:quantity|count|amount|number)(?: (?:BE|of|:))? (?P<n>\d+)(?= (?:[,.;)]|$))",
                                     r"(?P<n>\d+)(?: BLOCK)?(?= (?:row|line|column) )"), *APPENDED, *rowparts.OF_THEM,
                           *rowsizes.SIZED, *rowplainer.PLACES, *rowplainer.BEFORE, *rowwords.FIGURE,
                           *rowwords.PLACES, *rowwords.DIRECTIONS, *rowparts.SPACING, *rowparts.PATTERNED,
                           *rowparts.EACH, *rowparts.REST, *rowparts.WHERE, *rowparts.WORDS, *shared.WHERE,
                           *shared.BREAKS, *shared.GLUE]  # fmt: skip


def told(pieces: Sequence[Piece]) -> str:
    """The row in plain sentences.

    Raises:
        Unclear: it is not told which blocks it is made of, or what is told of their order leaves it open.
    """
    pieces, more = without_appended(pieces)
    pieces = rowsizes.sized(rowplainer.listed(rowplainer.beforehand(rowplainer.singly(rowplainer.of_line(pieces)))))
    check_lots(pieces)
    check_words(pieces)
    check_told_once(pieces)
    noun = noun_of(pieces)
    lots_at = lots_of(pieces)
    said = said_of(pieces, lots_at)
    by_size = rowsizes.by_size(pieces)
    pattern = pattern_of(pieces) or by_size
    total, each, direction = (one(pieces, kind) for kind in ("total", "each", "direction"))
    size = total.value if total else None
    row = Row(noun, rowsizes.way(pieces, direction.value if direction else ""), pattern)
    row.set_off = bool(said.lists) and set_off(
        pieces, next(n for n, lot in lots_at.items() if lot is said.lists[-1][0])
    )
    order = None if by_size else order_of(pieces, said, row)
    if (
        said.lists
        and adds(pieces)
        and {placed.lot.look for placed in said.placed} - {lot.look for run in said.lists for lot in run}
    ):
        raise Unclear  # what is put there could go on top
    open_rest = any(piece.kind == "rest" for piece in pieces) and size is None
    order = rowplainer.repeated(pieces, order, size)
    open_rainbow = pattern == "rainbow" and bool(size) and not said.lists and len(said.placed) == 1
    if open_rainbow:
        row.size, (_, row.facts) = size or 0, facts_of(said, [], size, pattern)
    elif order is not None:
        together = all(lot.plural for run in said.lists for lot in run)
        if size not in (None, len(order)) or open_rest or (each and not together):
            raise Unclear
        row.order, row.counts = order, Counter(order)
        row.facts = facts_of_listed(said, row.counts)
    else:
        lots = [lot for run in said.lists for lot in run]
        others = len(lots) == 1 and any(piece.kind == "rest" and piece.named for piece in pieces)
        lots, row.facts = facts_of(said, lots, size, pattern, others)
        row.counts = Counter({lot.look: lot.count for lot in numbered(lots, said, size, pattern, open_rest)})
        row.size = size or 0
    check_rest(pieces, row.counts)
    hues = size if open_rainbow else len(row.counts)
    if any(piece.kind == "hues" and piece.value != hues for piece in pieces):
        raise Unclear
    if more:
        append(row, more)
    return in_words(row, pieces, Colored())


def check_rest(pieces: Sequence[Piece], counts: Counter[str]) -> None:
    """ "The other two" are two, and "the inner two" are all but the ends.

    Raises:
        Unclear: they are not.
    """
    for n, piece in enumerate(pieces):
        told = [int(said) for said in piece.named.values()] if piece.kind == "rest" else []
        after = next((other for other in pieces[n:] if other.kind == "lot"), None)
        if told and (after is None or counts[lot_of(after).look] != told[0]):
            raise Unclear
        if "k" in piece.named and piece.kind == "rest" and all(other.value != ("ends", 0) for other in pieces[:n]):
            raise Unclear


_OF_WHICH = re.compile(r"\bof (?:them|these|those|which)\b")


def lots_of(pieces: Sequence[Piece]) -> dict[int, Lot]:
    """What the pieces name, by where they stand; with the numbers that "two of each" and "half of them" tell.

    Raises:
        Unclear: these are told of other blocks, too.
    """
    found = {n: lot_of(piece) for n, piece in enumerate(pieces) if piece.kind == "lot"}
    for at in (n for n, piece in enumerate(pieces) if piece.kind == "again"):
        ahead = [lot.look for n, lot in found.items() if n < at]
        if ahead[-1:] != [look for look in ahead[:-1] if look == ahead[-1]][:1]:
            raise Unclear  # "red, white, blue again"
    each, total = one(pieces, "each"), one(pieces, "total")
    counted_at = [n for n in found if "count" in pieces[n].named]
    if each:
        if counted_at:
            raise Unclear
        return {n: replace(lot, count=each.value) for n, lot in found.items()}
    of_them = [
        n
        for n, piece in enumerate(pieces)
        if piece.kind == "total" and piece.words.endswith(("them", "these", "those"))
    ]
    if of_them and (sum(n < of_them[0] for n in found) != 1 or any(piece.kind == "rest" for piece in pieces)):
        raise Unclear
    parts = [n for n in found if _OF_WHICH.search(pieces[n].words)]
    if parts and not total and any(n not in parts for n in found if n < parts[0]):
        raise Unclear  # "three red blocks, two of which are blue"
    halves = [n for n in found if "half" in pieces[n].named]
    if halves:
        again = [n for n in found if n not in halves and pieces[n].words.endswith(("half", "part", "ones", "group"))]
        if len(halves) != 2 or len(found) > 2 + len(again) or not total or total.value % 2:
            raise Unclear
        return {n: replace(lot, count=total.value // 2) if n in halves else lot for n, lot in found.items()}
    for n, piece in enumerate(pieces):
        behind = next((m for m in found if m > n), None)
        if piece.kind == "rest" and piece.named and behind and found[behind].count is None and not total:
            found[behind] = replace(found[behind], count=int(next(iter(piece.named.values()))))
    return found


def adds(pieces: Sequence[Piece]) -> bool:
    """Whether something is to be done once the row is told, or stands on one of its ends."""
    at = next(n for n, piece in enumerate(pieces) if piece.kind == "lot")
    return any(
        piece.kind == "act"
        or (piece.kind == "place" and {"on", "end"} <= {word.rstrip("s") for word in piece.words.split()})
        for piece in pieces[at:]
    )


def noun_of(pieces: Sequence[Piece], *, sorts: bool = False) -> str:
    """What the figure is called: "lined up" says less than a noun. `sorts`: blocks that are sorted in a direction are a
    row without any noun.

    Raises:
        Unclear: there is no figure, or there are two.
    """
    told = [piece for piece in pieces if piece.kind == "figure"]
    nouns = [piece.value for piece in told if not verbal(piece)]
    again = [piece.value for piece in pieces if piece.kind == "mention"]
    way = one(pieces, "direction") if sorts or any(piece.kind in ("beside", "axis") for piece in pieces) else None
    if (
        len(nouns) > 1
        or len(told) - len(nouns) > 1
        or not (told or again or way)
        or len(set(again)) > 1
        or (nouns and again and set(again) != set(nouns))
    ):
        raise Unclear
    stock = [n for n, piece in enumerate(pieces) if piece.kind == "stock"]
    figure = next(n for n, piece in enumerate(pieces) if piece.kind in ("figure", "mention", "direction"))
    between = pieces[min(stock[0], figure) : max(stock[0], figure)] if stock else []
    parted = any(piece.kind == "break" and piece.words in ".;:,and" for piece in between)
    if stock and (len(stock) > 1 or not parted):
        raise Unclear  # "there are three blocks in a row" tells of the start
    if not nouns and any(piece.kind == "mention" and after.words.startswith("of") for piece, after in pairwise(pieces)):
        raise Unclear  # "the row of red blocks" is there already
    noun: str = [*nouns, *again, "line" if told or not way else "column" if "front" in way.value else "row"][0]
    axis = one(pieces, "axis")
    if axis and noun not in ("line", axis.value):
        raise Unclear
    if noun == "column" and not any(lies(piece) for piece in pieces):
        raise Unclear  # it may be a tower
    return str(axis.value) if axis else noun


def lies(piece: Piece) -> bool:
    """Whether something is said that shows that a column lies on the table, as gaps that a tower has not."""
    away = piece.kind in ("direction", "place") and bool(
        {"front", "back"} & set(str(piece.value[0] if piece.kind == "place" else piece.value).split())
    )
    return (
        away
        or piece.kind in ("where", "axis")
        or (piece.kind == "spacing" and "touch" not in piece.value)
        or bool({"table", "lay", "flat", "behind"} & set(piece.words.split()))
    )


def verbal(piece: Piece) -> bool:
    """Whether a figure is told by a verb, "lined up", not by a noun."""
    return piece.words.startswith(
        ("line up", "align", "lines", "lined", "lining", "line them", "line these", "line it", "line all")
    )


def pattern_of(pieces: Sequence[Piece]) -> str:
    """The pattern of the colours.

    Raises:
        Unclear: there are two.
    """
    found = {piece.value for piece in pieces if piece.kind == "pattern"}
    if found > {"different"} and found & {"rainbow"}:
        found -= {"different"}
    if len(found) > 1:
        raise Unclear
    return found.pop() if found else ""


def check_words(pieces: Sequence[Piece]) -> None:
    """Words that tell of what stands beside them.

    Raises:
        Unclear: "then" is no list, "all but two" or "A to E but C" are not all of these, a number of blocks has a
        place ("the three blocks in the middle"), or "the blue ones together" are no further ones.
    """
    if any(lot.kind == "lot" and "det" in lot.named and by.words == "together" for lot, by in pairwise(pieces)):
        raise Unclear
    of_all = False
    for piece in pieces:
        if piece.words == "but" and of_all:
            raise Unclear
        of_all = (of_all and piece.kind != "break") or not _ALL.isdisjoint(piece.words.split())
    bound = [piece for piece in pieces if piece.kind != "glue"]
    for piece, after in pairwise([*bound, Piece("end", "")]):
        if {piece.kind, after.kind} == {"total", "place"} and after.words != "middle":
            raise Unclear
    ahead = zip(bound, bound[1:], [*bound[2:], Piece("end", "")], strict=False)
    if any(but.words == "but" and lot.kind == "lot" and after.kind != "place" for but, lot, after in ahead):
        raise Unclear
    bound = [piece for piece in bound if piece.kind != "break"]
    for piece, after in pairwise([*bound, Piece("end", "")]):
        if piece.value == "now" and after.kind not in ("lot", "place"):
            raise Unclear


_ALL = frozenset({"all", "each", "every", "everything", "any", "none", "no"})


def check_told_once(pieces: Sequence[Piece]) -> None:
    """Where a direction is told of a list, no later sentence lists the same again.

    Raises:
        Unclear: "red and blue from left to right; then blue and red".
    """
    parts: list[list[Piece]] = [[]]
    for piece in pieces:
        parts.append([]) if piece.kind == "break" and piece.words in STOPS and piece.words != ":" else parts[-1].append(
            piece
        )
    ordered = False
    for part in parts:
        kinds = {piece.kind for piece in part}
        bare = sum(piece.kind == "lot" for piece in part) > 1 and not kinds & {"direction", "place"}
        if ordered and bare and all(piece.kind != "listed" or piece.value == "now" for piece in part):
            raise Unclear
        ordered = ordered or {"lot", "direction"} <= kinds


def check_lots(pieces: Sequence[Piece]) -> None:
    """Lots are parted from each other, unless three or more bare colours are listed.

    Raises:
        Unclear: they are not, or small words between them tell more ("from red to blue"), or some of them are told once
            more ("red, blue and green with red and blue together").
    """
    for n in (n for n, piece in enumerate(pieces) if piece.words == "with"):
        behind = [*takewhile(lambda piece: piece.kind in ("lot", "break"), pieces[n + 1 :])]
        again = {piece.words for piece in behind if piece.kind == "lot"}
        placed = any(piece.kind == "place" for piece in pieces[n + 1 + len(behind) :][:1])
        if again and not placed and again <= {piece.words for piece in pieces[:n] if piece.kind == "lot"}:
            raise Unclear
    for a, b, c in zip(pieces, pieces[1:], pieces[2:], strict=False):
        if a.kind == c.kind == "lot" and (b.kind == "glue" or b.words == ":"):
            raise Unclear  # "x: red, green, blue" is no list of four
        colored = a.kind == "lot" and "noun" not in a.named and b.kind == "figure" and " " not in b.words
        if colored and c.words in ("of", "with", "from"):
            raise Unclear  # "a red row of blue blocks"
    check_joined(pieces)
    together = [(a, b) for a, b in pairwise(pieces) if a.kind == b.kind == "lot"]
    bare = all(
        not {"noun", "count", "many"} & set(piece.named) and piece.named.get("det", "a") in ("a", "an")
        for pair in together
        for piece in pair
    )
    bare = bare or all("count" in piece.named for pair in together for piece in pair)
    bare = bare or all("half" in piece.named for pair in together for piece in pair)
    labels = [2 if "half" in a.named else ("label" in a.named) + ("label" in b.named) for a, b in together]
    alternate = any(a.value == "alternating" and b.kind == "lot" for a, b in pairwise(pieces))
    if together and ((len(together) < 2 and 2 not in labels and not alternate) or not bare or 1 in labels):
        raise Unclear


def check_joined(pieces: Sequence[Piece]) -> None:
    """A list is one list, and a sentence with blocks is about the row.

    Raises:
        Unclear: "A and B, C and D"; "three blocks in a row. Red, white and blue must touch."
    """
    seps: list[str] = []
    for piece in [*pieces, Piece("end", "")]:
        if piece.kind == "break" and piece.words in (",", "and", "plus"):
            seps.append(piece.words)
        elif piece.kind == "lot":
            seps.append("")
        elif piece.kind != "glue":
            seps = (
                seps[: max(n for n, sep in enumerate(seps) if not sep)]
                if piece.kind == "place" and "" in seps
                else seps
            )
            inner = [join.strip() for join in " ".join(sep or "|" for sep in seps).split("|")[1:-1]]
            if "," in inner and any("and" in join for join in inner[:-1]):
                raise Unclear
            seps = []
    parts: list[list[Piece]] = [[]]
    for piece in pieces:
        parts.append([]) if piece.kind == "break" and piece.words in STOPS else parts[-1].append(piece)
    for part in parts:
        kinds = {piece.kind for piece in part}
        if {"lot", "spacing"} <= kinds and not kinds & {"figure", "mention", "listed", "direction", "place", "total"}:
            raise Unclear


def order_of(pieces: Sequence[Piece], said: Said, row: Row) -> list[str] | None:
    """The looks of all blocks in the order in which they are listed, if this is told as an order.

    Raises:
        Unclear: two lists that do not agree, a list that is not of all blocks, or an order of which there is no list.
    """
    listed = any(piece.kind == "listed" for piece in pieces)
    if not said.lists:
        if listed:
            raise Unclear
        return None
    marked = bool(row.direction) or listed
    last, ahead = (said.whole if marked else said.lists)[-1], [lot for run in said.lists[:-1] for lot in run]
    looks = [lot.look for lot in last]
    repeated = len(set(looks)) < len(looks)
    again = bool(ahead) and bool({lot.look for lot in ahead} & set(looks))
    marked = marked or (row.set_off and all(lot.count in (None, 1) and not lot.plural for lot in last[:-1]))
    if again and not marked:
        raise Unclear
    if len(set(looks)) == 1 and not repeated and not again:
        return None
    if not (marked or repeated) or (row.pattern in ("alternating", "grouped") and not again and not repeated):
        if any(piece.value == "now" for piece in pieces):
            raise Unclear
        return None
    if ahead and not again and (len(last) < 2 or not marked):
        raise Unclear
    if row.pattern == "rainbow" and not repeated and not row.direction:
        if [look for look in RAINBOW if look in looks] not in (looks, looks[::-1]):
            raise Unclear
        return None
    known = Counter({lot.look: lot.count or 1 for lot in ahead})
    order = []
    for lot in last:
        if lot.count is None and lot.plural and lot is not last[-1] and lot.look not in known:
            raise Unclear
        many = lot.count or (known[lot.look] if looks.count(lot.look) == 1 and lot.plural and lot.look in known else 1)
        order += [lot.look] * many
    if ahead and (not again or (len(known) == len(ahead) and Counter(order) != known) or len(known) != len(ahead)):
        raise Unclear
    return order


_DEALT = re.compile(r"\bof (?:them|these|those|which)\b")


def set_off(pieces: Sequence[Piece], at: int) -> bool:
    """Whether the list that begins there stands behind a colon or comma which the row is named ahead of; "one of them
    red, the others blue" is no list."""
    if _DEALT.search(pieces[at].words):
        return False
    ahead = [piece for piece in pieces[:at] if piece.kind not in ("glue", "place")]
    return bool(ahead) and ahead[-1].words in (":", ",") and any(piece.kind in ("figure", "mention") for piece in ahead)
