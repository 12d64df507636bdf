"""Which blocks of a flat figure are where, as far as it is told."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, replace

from rpg.language.frames.lots import Lot, lot_of
from rpg.language.frames.pieces import Piece, Unclear

_PARTS: dict[str, dict[str, str]] = {
    "plus": {"center": "center", **dict.fromkeys(("around", "arms", "sides", "rest"), "rest")},
    "X": {"center": "center", **dict.fromkeys(("around", "arms", "rest"), "rest")},
    "circle": {"center": "inner", **dict.fromkeys(("around", "sides", "rest"), "rest")},
    "square": {"center": "center", "corners": "corners", **dict.fromkeys(("around", "sides", "rest"), "rest")},
    "rectangle": {"corners": "corners", **dict.fromkeys(("sides", "rest"), "rest")},
    "triangle": {"corners": "corners", "tip": "tip", "rest": "rest", "sides": "rest"},
    "T": {"bar": "bar", "stem": "stem", "rest": "rest"},
    "L": {"corners": "corner", "rest": "rest"},
    "V": {"tip": "tip", "arms": "rest", "rest": "rest"},
    "U": {"corners": "corners", "base": "base", **dict.fromkeys(("sides", "arms", "around", "rest"), "rest")},
}
"""The parts of each figure that may have a colour, by the words for places."""
SINGLE = frozenset({"center", "inner", "tip", "corner"})


@dataclass
class Told:
    """What is said of the blocks: those of the figure, those with a place, and how many are where."""

    free: list[Lot] = field(default_factory=list)
    placed: list[tuple[Lot, str]] = field(default_factory=list)
    numbers: dict[str, int] = field(default_factory=dict)


def parted(pieces: Sequence[Piece]) -> list[Piece]:
    """The pieces with the looks of limbs as those of places: "a red bar of three blocks"; and without the colon of
    "center: red"."""
    found: list[Piece] = []
    for n, piece in enumerate(pieces):
        before = pieces[n - 1] if n else Piece("break", "")
        behind = pieces[n + 1] if n + 1 < len(pieces) else Piece("break", "")
        if piece.words == ":" and before.kind in ("place", "each") and behind.kind == "lot":
            continue
        found.append(piece)
        if piece.kind == "lot" and before.kind == "arm" and not {"count", "det"} & piece.named.keys():
            found.append(Piece("place", "", "arms"))  # "each arm has two red blocks"
        limb = before.kind == "limb" and before.value[0] in ("bar", "stem") and behind.kind in ("break", "except")
        if piece.kind == "lot" and limb and not {"count", "noun", "many"} & piece.named.keys():
            found.append(Piece("part", "", before.value[:2]))  # "top line 5 blocks blue"
        following = next((p.kind for p in pieces[n + 1 :] if p.kind not in ("glue", "dims", "fill")), "")
        if piece.kind == "place" and following == "figure":
            found.append(Piece("break", ""))  # "in the middle of a ring of ..."
        alone = n < 2 or pieces[n - 2].kind != "arm"
        if (
            before.kind == "lot"
            and alone
            and not {"count", "noun", "many"} & before.named.keys()
            and not piece.words[0].isdigit()
        ):
            if piece.kind == "arm":
                found.append(Piece("place", "", "arms"))
            elif piece.kind == "limb" and piece.value[0] in ("bar", "stem"):
                found.append(Piece("part", "", piece.value[:2]))
    return found


def each_side(pieces: Sequence[Piece]) -> list[Piece]:
    """ "On each side one white block": of the one in the middle."""
    return [replace(p, kind="each", value="around") if p.kind == "per" and p.words[:2] == "on" else p for p in pieces]


def by_side(pieces: Sequence[Piece]) -> list[Piece]:
    """ "Three red blocks along each side": so many blocks has a side, and all are red."""
    found: list[Piece] = []
    for piece in pieces:
        sided = piece.kind == "per" or (piece.kind == "each" and piece.value == "around")
        if not sided or not found or found[-1].kind != "lot" or "count" not in found[-1].named:
            found.append(piece)
            continue
        count = lot_of(found[-1]).count
        found[-1] = replace(found[-1], named={**found[-1].named, "det": "", "count": "", "many": "s"})
        del found[-1].named["count"]
        found.append(Piece("side", piece.words, count))
    return found


def with_limbs(pieces: Sequence[Piece], said: Told, shape: str) -> list[Piece]:
    """The pieces, and the sizes of a T's limbs that are told by their blocks; blocks of one look are one lot."""
    limbs = [(part, lot.count) for lot, part in said.placed if part in ("bar", "stem") and lot.count]
    looks = {lot.look for lot, _ in said.placed}
    if shape != "T" or len(limbs) != 2 or len(said.placed) != 2:
        return list(pieces)
    if len(looks) == 1:
        if said.free:
            raise Unclear
        said.free, said.placed = [Lot(looks.pop(), sum(count for _, count in limbs))], []
    told_of = {piece.value[0] for piece in pieces if piece.kind == "limb"}
    return [*pieces, *(Piece("limb", "", (part, count, False)) for part, count in limbs if part not in told_of)]


def blocks_of(pieces: Sequence[Piece], shape: str) -> Told:
    """The lots of the text with their places, clause by clause.

    Raises:
        Unclear: it is not clear which of them has which place.
    """
    pieces = _around(_its(pieces))
    said = Told()
    clause: list[Piece] = []
    for piece in [*pieces, Piece("break", "")]:
        if piece.kind in ("lot", "place", "part", "each", "per"):
            clause.append(piece)
        if piece.kind in ("break", "except"):
            _clause(clause, said, shape)
            clause = []
    inside = {"inner", "center"} & {*said.numbers, *(part for _, part in said.placed)}
    if shape in ("circle", "square") and not inside and ("place", "around") in [(p.kind, p.value) for p in pieces]:
        raise Unclear  # "a circle around it": around what is told of elsewhere
    return said


def _around(pieces: Sequence[Piece]) -> list[Piece]:
    """ "Four red around a blue one": each of the two has its place."""
    found = list(pieces)
    for n, piece in enumerate(pieces):
        if piece.kind != "pivot":
            continue
        before = next((m for m in range(n - 1, -1, -1) if pieces[m].kind in ("lot", "total")), None)
        behind = next((m for m in range(n + 1, len(pieces)) if pieces[m].kind == "lot"), None)
        if behind is None or any(p.kind == "break" for p in pieces[n:behind]):
            raise Unclear
        if before is None or any(p.words in (".", ";", ",") for p in pieces[before:n]):
            raise Unclear
        outer, inner = (before, behind) if piece.value == "around" else (behind, before)
        for m, place in ((outer, "around"), (inner, "center")):
            if pieces[m].kind == "lot":
                named = {**pieces[m].named, "at": place}
                found[m] = replace(pieces[m], named=named)
            elif place == "center":
                raise Unclear
    return found


def _its(pieces: Sequence[Piece]) -> list[Piece]:
    """ "Put one red block down and eight blue ones around it": "it" is in the middle."""
    lots = [n for n, piece in enumerate(pieces) if piece.kind == "lot"]
    around = [n for n, piece in enumerate(pieces) if piece.kind == "place" and piece.value == "around"]
    others = [piece for piece in pieces if piece.kind in ("place", "part", "each", "pivot")]
    if (
        len(lots) != 2
        or len(around) != 1
        or len(others) != 1
        or pieces[around[0]].words.split()[-1] not in ("it", "that")
    ):
        return list(pieces)
    first, second = lots
    between = [piece.kind for piece in pieces[first:second]]
    if (
        lot_of(pieces[first]).count != 1
        or "break" not in between
        or "figure" in between
        or "figure" in [p.kind for p in pieces[:first]]
    ):
        return list(pieces)
    return [*pieces[: first + 1], Piece("place", "", "center"), *pieces[first + 1 :]]


def _clause(clause: Sequence[Piece], said: Told, shape: str) -> None:
    """What one clause says of lots and places."""
    lots = [piece for piece in clause if piece.kind == "lot"]
    places = [piece for piece in clause if piece.kind != "lot"]
    at = [piece for piece in lots if "at" in piece.named]
    for piece in at:
        said.placed.append(_placed(lot_of(piece), piece, _part(piece.named["at"], shape)))
    lots = [piece for piece in lots if piece not in at]
    if at and not lots:
        if any(
            place.kind == "part" or _part(place.value, shape) not in [p for _, p in said.placed] for place in places
        ):
            raise Unclear
        return
    if not places:
        said.free += map(lot_of, lots)
    elif (
        not lots
        and all(place.kind == "place" for place in places)
        and [_part(p.value, shape) for p in places] == [p for _, p in said.placed[-1:]]
    ):
        return  # told twice: "inside, in the middle"
    elif not lots or (len(lots) == 1 and len(places) > 1 and all(place.kind == "part" for place in places)):
        said.free += map(lot_of, lots)
        for place in places:
            if place.kind != "part":
                raise Unclear
            part, many = place.value
            part = _part(part, shape)
            if part in said.numbers:
                raise Unclear
            said.numbers[part] = many
    else:
        kinds = [piece.kind == "lot" for piece in clause]
        if len(kinds) % 2 or kinds != kinds[:2] * (len(kinds) // 2) or kinds[0] == kinds[1]:
            raise Unclear
        for lot, place in zip(lots, places, strict=True):
            if place.kind == "per":
                raise Unclear
            part, many = place.value if place.kind == "part" else (place.value, None)
            found = lot_of(lot)
            if place.kind == "each":
                found = replace(found, count=(found.count or 1) * _times(part, shape))
            if many is not None and found.count not in (None, many):
                raise Unclear
            said.placed.append(_placed(replace(found, count=many or found.count), lot, _part(part, shape)))


def _placed(lot: Lot, piece: Piece, part: str) -> tuple[Lot, str]:
    """A lot at its part of the figure.

    Raises:
        Unclear: several blocks where there is room for one: "two blue ones in the middle", "blue blocks inside".
    """
    several = lot.count is None and ("many" in piece.named or piece.named.get("noun", "").endswith("s"))
    if part in SINGLE and (several or lot.count not in (None, 1)):
        raise Unclear
    if part in ("bar", "stem", "base") and piece.named.get("det") in ("a", "an") and "noun" not in piece.named:
        return replace(lot, count=None), part  # "a red bar"
    return lot, part


def _times(place: str, shape: str) -> int:
    """How many such places the figure has: one block in each of them makes so many.

    Raises:
        Unclear: it has none that are counted.
    """
    if place == "corners" and shape in ("square", "rectangle", "triangle"):
        return 3 if shape == "triangle" else 4
    if shape in ("plus", "X") and place in ("around", "arms"):
        return 4
    if shape == "U" and place in ("around", "arms"):
        return 2
    raise Unclear


def _part(place: str, shape: str) -> str:
    """The part of the figure that words for a place mean."""
    if place not in _PARTS[shape]:
        raise Unclear
    return _PARTS[shape][place]


def total_of(said: Told, total: int | None, shape: str) -> int | None:
    """How many blocks the figure has, as far as that is told, without one that stands in it."""
    inner = any(part == "inner" for _, part in said.placed) or "inner" in said.numbers
    if len(said.numbers) > 1 and shape not in ("plus", "X", "T", "L", "V", "U"):
        raise Unclear  # "four at the corners and one in the middle" are no outline
    if said.numbers and not said.placed:
        counts = sum(number for part, number in said.numbers.items() if part != "inner")
        if len(said.numbers) > 1 and total is not None and total != sum(said.numbers.values()):
            raise Unclear
        if "inner" in said.numbers:
            raise Unclear
        return counts if len(said.numbers) > 1 else total
    if inner and total is not None and sum(lot.count or 1 for lot, _ in said.placed) == total:
        return total - 1
    return total


def sum_of(said: Told) -> int | None:
    """How many blocks are told of, if it is told of all of them how many."""
    counts: dict[str, int | None] = {lot.look: lot.count for lot in said.free}
    for lot, part in said.placed:
        if part == "inner":
            continue
        count = 1 if part in SINGLE else lot.count
        if lot.look not in counts:
            counts[lot.look] = count
        elif lot.look not in [other.look for other in said.free]:
            raise Unclear  # blocks of one look at two places
    told_of = [count for count in counts.values() if count is not None]
    return sum(told_of) if told_of and len(told_of) == len(counts) else None
