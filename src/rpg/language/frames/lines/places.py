"""The blocks of a row as they are told: lists of them, and those that are told with a place."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import groupby

from rpg.language.frames.lots import Lot
from rpg.language.frames.pieces import Piece, Unclear

Place = tuple[str, int]
STOPS = frozenset([".", ";", "!", "?"])
_THINGS = ("lot", "place")
_WITHIN = frozenset({"with", "where", "so", "such", "in", "including"})
"""First words of breaks that go on about the same blocks."""


@dataclass(frozen=True)
class Placed:
    """Blocks and their place. `within`: "with a red one at the left end", which is one of the blocks told before."""

    lot: Lot
    place: Place
    within: bool = False


@dataclass(frozen=True)
class Said:
    """What is said of the blocks: lists of those without a place, in the order of the text; blocks with a place; and
    the lists with those of them that stand between the others ("white, red in the middle, then white")."""

    lists: list[list[Lot]]
    placed: list[Placed]
    whole: list[list[Lot]]


@dataclass
class _Segment:
    """The lots and places between two breaks. `mark`: the break ahead of it; `figure`: the row is named in it."""

    mark: str
    said: list[Piece]
    figure: bool = False

    @property
    def kinds(self) -> str:
        return "".join("L" if piece.kind == "lot" else "P" for piece in self.said)


def said_of(pieces: Sequence[Piece], lots: dict[int, Lot]) -> Said:
    """Lists and placed blocks. `lots`: what the pieces of the kind "lot" name, by where they stand in `pieces`.

    Raises:
        Unclear: a place without blocks, or blocks that could have it or not, as all that there are in a row.
    """
    known = {id(pieces[n]): lot for n, lot in lots.items()}
    runs: list[list[Lot]] = []
    whole: list[list[Lot]] = []
    placed: list[Placed] = []
    for sentence in _sentences(pieces):
        found = _placed_in(sentence, known)
        placed += found
        told = {id(one.lot) for one in found}
        for every in _runs(sentence, known):
            run = [lot for lot in every if id(lot) not in told]
            looks = {lot.look for lot in run}
            every = [lot for lot in every if id(lot) not in told or not (lot.known and lot.look in looks)]
            runs += [run] if run else []
            whole += [every] if run else []
    if len(lots) == len(placed) == 1 and (placed[0].lot.count or 0) > 1 and not placed[0].within:
        raise Unclear  # "a row of three red blocks on the left": so is the row, on the table
    return Said(runs, placed, whole)


def _sentences(pieces: Sequence[Piece]) -> list[list[Piece]]:
    found: list[list[Piece]] = [[]]
    for piece in pieces:
        if piece.kind == "break" and piece.words in STOPS:
            found.append([])
        else:
            found[-1].append(piece)
    return [sentence for sentence in found if sentence]


def _segments(sentence: Sequence[Piece]) -> list[_Segment]:
    found = [_Segment("", [])]
    for piece in sentence:
        if piece.kind in ("break", "listed", "direction") and not (
            piece.kind == "break" and not found[-1].said and not found[-1].figure
        ):
            found.append(_Segment(piece.words, []))
        elif piece.kind == "break":
            found[-1].mark += " " + piece.words
        elif piece.kind in _THINGS:
            found[-1].said.append(piece)
        elif piece.kind in ("figure", "mention"):
            found[-1].figure = True
        elif piece.kind == "rest":
            found += [_Segment("rest", [])] if found[-1].said else []
            found[-1].mark += " rest"
    return found


def _placed_in(sentence: Sequence[Piece], known: dict[int, Lot]) -> list[Placed]:
    """The blocks with a place in a sentence: the place stands beside the blocks."""
    segments = _segments(sentence)
    found: list[Placed] = []
    within = False
    for n, segment in enumerate(segments):
        kinds = segment.kinds
        if "P" not in kinds:
            continue
        after = segments[n + 1] if n + 1 < len(segments) else None
        ahead = segments[n - 1] if n else None
        if (
            kinds == "P"
            and after
            and after.kinds == "L"
            and not after.figure
            and (not ahead or ahead.kinds in ("", "P") or ahead in _eaten(segments[:n]))
        ):
            segment.said = [*segment.said, *after.said]
            after.said = []
            kinds = "PL"
        if kinds == "LPL":
            found += _between(segment, after, known)
            continue
        if kinds in ("PLP", "PPL", "LPP"):
            found.append(_refined(segment, known))
            continue
        if len(kinds) % 2 or kinds != kinds[:2] * (len(kinds) // 2) or kinds[0] == kinds[1]:
            raise Unclear
        pairs = [
            (a, b) if a.kind == "lot" else (b, a) for a, b in zip(segment.said[::2], segment.said[1::2], strict=True)
        ]
        if kinds == "LP" and ahead and ahead.kinds and set(ahead.kinds) == {"L"} and segment.mark == "and":
            found += _both_ends([known[id(ahead.said[-1])], known[id(pairs[0][0])]], pairs[0][1].value, len(ahead.said))
            continue
        if kinds[-1] == "L" and after and after.kinds == "L" and after.mark == "and" and not after.figure:
            raise Unclear  # "at the left end a red block and a blue block"
        within = segment.mark.split(" ")[0] in _WITHIN or (within and segment.mark == "and")
        found += [
            Placed(known[id(lot)], place.value, within or place.value[0] in ("first", "last")) for lot, place in pairs
        ]
    return found


def _eaten(segments: Sequence[_Segment]) -> list[_Segment]:
    """The segments ahead that are a place with its blocks."""
    return [segment for segment in segments if segment.kinds == "PL" or not segment.said]


def _between(segment: _Segment, after: _Segment | None, known: dict[int, Lot]) -> list[Placed]:
    """Blocks between others, or flanked by others.

    Raises:
        Unclear: the others are not two.
    """
    first, place, second = segment.said
    one, other = known[id(first)], known[id(second)]
    if place.words.split()[-1] not in ("by", "between"):
        raise Unclear
    if other.count == 2:
        return [Placed(one, ("middle", 0)), Placed(other, ("ends", 0))]
    if other.count in (None, 1) and after and after.kinds == "L" and after.mark == "and":
        third = known[id(after.said[0])]
        after.said = []
        if third.count in (None, 1):
            return [Placed(one, ("middle", 0)), Placed(other, ("end", 0)), Placed(third, ("other", 0))]
    raise Unclear


def _refined(segment: _Segment, known: dict[int, Lot]) -> Placed:
    """ "Starting with red on the left": two words for one place."""
    lot = next(piece for piece in segment.said if piece.kind == "lot")
    places = [piece.value for piece in segment.said if piece.kind == "place"]
    if (
        places[0][0] not in ("first", "last")
        or places[0][1] != 1
        or places[1][0] not in ("left", "right", "front", "back")
    ):
        raise Unclear
    return Placed(known[id(lot)], places[1], True)


def _both_ends(lots: list[Lot], place: Place, many: int) -> list[Placed]:
    """ "Red and blue at the ends": one each; in the middle: in any order.

    Raises:
        Unclear: two kinds of blocks at one place.
    """
    if place[0] == "middle" and many == 1:
        return [Placed(lot, ("inner", 0)) for lot in lots]
    if place[0] != "ends" or many != 1 or any(lot.count not in (None, 1) for lot in lots):
        raise Unclear
    return [Placed(lot, name) for lot, name in zip(lots, (("end", 0), ("other", 0)), strict=True)]


def _runs(sentence: Sequence[Piece], known: dict[int, Lot]) -> list[list[Lot]]:
    """The lists of blocks in a sentence: nothing but breaks, places and small words stands in a list."""
    between = ("glue", "break", "stock", "place", "rest", "each", "again")
    kept = [piece for piece in sentence if piece.kind not in between and piece.value != "now"]
    return [
        [known[id(piece)] for piece in run]
        for listed, run in groupby(kept, lambda piece: piece.kind == "lot")
        if listed
    ]
