"""One flat figure on the table: a plus, a ring, a letter, a square, a rectangle, a triangle."""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, replace

from rpg.language.frames.lots import Lot, as_adjectives, check_listed, counted, lot_of, one
from rpg.language.frames.pieces import Piece, Unclear
from rpg.language.frames.shape_sizes import Sized, sized
from rpg.language.frames.shape_words import PATTERNS as PATTERNS

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
    "U": {"corners": "corners", "rest": "rest"},
}
"""The parts of each figure that may have a colour, by the words for places."""
_MAKES: dict[str, Callable[[int], bool]] = {
    **dict.fromkeys(("plus", "X", "V"), lambda n: n > 4 and n % 2 == 1),
    **dict.fromkeys(("square", "rectangle", "triangle", "circle"), lambda n: n > 2),
    **dict.fromkeys(("T", "L", "U"), lambda n: n > 3),
}
"""Whether so many blocks may make the figure by themselves."""
_SINGLE = frozenset({"center", "inner", "tip", "corner"})
_ITS_WAY = {
    **{letter: {"stem": "stem", "bar": "bar"} for letter in "T"},
    "L": {"foot": "foot", "bar": "foot"},
    "U": {"opening": "opening"},
    "V": {"opening": "opening", "tip": "tip"},
    "triangle": {"tip": "tip"},
}
_DOWN = re.compile(r"\b(?:down|downwards?|below|underneath|under|hang|hanging)\b")
_ARTICLES = ("a", "an", "the")
_OVER = {"front": "back", "back": "front", "left": "right", "right": "left"}


@dataclass
class _Told:
    """What is said of the blocks: those of the figure, those with a place, and how many are where."""

    free: list[Lot] = field(default_factory=list)
    placed: list[tuple[Lot, str]] = field(default_factory=list)
    numbers: dict[str, int] = field(default_factory=dict)


def told(pieces: Sequence[Piece]) -> str:
    """The figure in plain sentences.

    Raises:
        Unclear: it is not told which figure it is, or not which blocks it is made of.
    """
    pieces = _parted(as_adjectives(pieces))
    check_listed(pieces)
    shape = _shape(pieces)
    if shape in ("square", "triangle", "L", "U"):
        pieces = _by_side(pieces)
    said = _blocks(pieces, shape)
    _check_where(pieces)
    total, colors = one(pieces, "total"), one(pieces, "colors")
    if any(piece.kind == "except" for piece in pieces) and any(lot.count for lot in said.free):
        raise Unclear  # is it one of them?
    pieces = _with_limbs(pieces, said, shape)
    if any(piece.kind == "fill" and piece.value == "hollow" for piece in pieces):
        if shape == "circle" and any(part == "inner" for _, part in said.placed):
            raise Unclear  # is its middle empty?
        said.placed = [(lot, "inner" if part == "center" else part) for lot, part in said.placed]
    inner = [lot for lot, part in said.placed if part == "inner"]
    size = _total(said, total.value if total else None, shape)
    if inner:
        said.free = [lot for lot in said.free if lot.look != inner[0].look or lot.count != 1]
    size_of = sized(pieces, shape, size if size is not None else _sum(said))
    if said.free and said.placed and size is None and not size_of.measured and not inner:
        _check_incomplete(said, shape)
    if one(pieces, "any") and (said.free or said.placed):
        raise Unclear
    if colors or _alternate(said, size_of.total):
        size_of, looks, parts = _colored(said, size_of, colors.value if colors else "alternating", shape)
    else:
        looks, parts = _looks(said, size_of, shape)
    way = _way(pieces, shape)
    text = f"Build {size_of.name}{size_of.measures}{looks}{way}."
    text += "".join(f" The {part} {'are' if part in ('corners', 'rest') else 'is'} {look}." for part, look in parts)
    if inner:
        text += f" A {inner[0].look} block is in the middle of the {shape}."
    where = one(pieces, "where")
    return f"{text} The {shape} is {where.value}." if where else text


def _parted(pieces: Sequence[Piece]) -> list[Piece]:
    """The pieces with the looks of limbs as those of places: "a red bar of three blocks"; and without the colon of
    "center: red"."""
    found: list[Piece] = []
    for n, piece in enumerate(pieces):
        before = pieces[n - 1] if n else Piece("break", "")
        behind = pieces[n + 1] if n + 1 < len(pieces) else Piece("break", "")
        if piece.words == ":" and before.kind in ("place", "each") and behind.kind == "lot":
            continue
        found.append(piece)
        following = next((p.kind for p in pieces[n + 1 :] if p.kind not in ("glue", "dims", "fill")), "")
        if piece.kind == "place" and following == "figure":
            found.append(Piece("break", ""))  # "in the middle of a ring of ..."
        if before.kind == "lot" and not {"count", "noun", "many"} & before.named.keys() and not piece.words[0].isdigit():
            if piece.kind == "arm":
                found.append(Piece("place", "", "arms"))
            elif piece.kind == "limb" and piece.value[0] in ("bar", "stem"):
                found.append(Piece("part", "", piece.value[:2]))
    return found


def _by_side(pieces: Sequence[Piece]) -> list[Piece]:
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


def _shape(pieces: Sequence[Piece]) -> str:
    """The figure that all of the text is about.

    Raises:
        Unclear: there is none, or there are several; or it may be something else that is there.
    """
    figures = [n for n, piece in enumerate(pieces) if piece.kind == "figure"]
    if not figures and any(piece.kind == "pivot" and "encirc" in piece.words for piece in pieces):
        return "circle"
    if not figures:
        raise Unclear
    first = figures[0]
    shape: str = pieces[first].value
    for n in figures[1:]:
        if pieces[n].value != shape or pieces[n - 1].words not in ("the", "this", "of the", "that"):
            raise Unclear
    ahead = [piece.words for piece in pieces[:first]]
    if any(piece.kind == "again" for piece in pieces[:first]):
        raise Unclear
    last = ahead[-1] if ahead else ""
    makes = ("make", "build", "form", "create", "construct", "draw")
    if last == "the" and (len(ahead) < 2 or ahead[-2] not in makes):
        raise Unclear  # "the circle ..." tells of one that is there
    letter = len(shape) == 1 and last not in ("a", "an") and "shape" not in pieces[first].words
    if letter and last in ("put", "place", "set", "bring", "lay", "the"):
        raise Unclear  # a block with this letter
    if last in ("on", "onto", "upon", "inside", "within"):
        raise Unclear
    _check_joined(pieces, first)
    colored = [piece.kind for piece in pieces[max(0, first - 1) : first]] == ["lot"]
    if colored and first > 1 and pieces[first - 2].words in ("in", "into", "on", "onto", "inside", "within", "upon"):
        raise Unclear  # a patch
    return shape


def _check_joined(pieces: Sequence[Piece], first: int) -> None:
    """What is joined to the figure by "and" is a part of it.

    Raises:
        Unclear: "two white blocks and a circle", "the letter L and two red blocks" are more than a figure.
    """
    behind = [piece for piece in pieces[first + 1 :] if piece.words not in _ARTICLES]
    if [piece.words for piece in behind[:1]] == ["and"] and [piece.kind for piece in behind[1:2]] == ["lot"]:
        end = next((n for n, piece in enumerate(behind[1:], 1) if piece.kind == "break"), len(behind))
        if not {"place", "pivot", "part"} & {piece.kind for piece in behind[1:end]}:
            raise Unclear
    ahead = [piece for piece in pieces[:first] if piece.words not in _ARTICLES]
    if [piece.words for piece in ahead[-1:]] == ["and"] and [piece.kind for piece in ahead[-2:-1]] in (["lot"], ["total"]):
        raise Unclear


def _check_where(pieces: Sequence[Piece]) -> None:
    """What is said of a place on the table is said of the figure.

    Raises:
        Unclear: it may be said of some blocks.
    """
    clause: list[str] = []
    lots = sum(piece.kind in ("lot", "total") for piece in pieces)
    for piece in [*pieces, Piece("break", "")]:
        clause.append(piece.kind)
        if piece.kind in ("break", "except"):
            if "where" in clause and "figure" not in clause:
                if {"place", "part", "pivot"} & set(clause) or {"lot", "total"} & set(clause) and lots > 1:
                    raise Unclear
            clause = []


def _check_incomplete(said: _Told, shape: str) -> None:
    """Blocks that have no place make no figure without those that have one.

    Raises:
        Unclear: "an L of five red blocks, and a blue block at its corner".
    """
    free = sum(lot.count or 0 for lot in said.free)
    looks = {lot.look for lot in said.free}
    if free and not any(lot.look in looks for lot, _ in said.placed) and _MAKES[shape](free):
        raise Unclear


def _colored(said: _Told, size: Sized, colors: str, shape: str) -> tuple[Sized, str, list[tuple[str, str]]]:
    """A figure whose colours alternate, or all differ.

    Raises:
        Unclear: the figure is no ring, or it is told where some of the blocks are.
    """
    if said.placed and any(part != "inner" for _, part in said.placed):
        raise Unclear
    if colors == "different":
        if said.free or not size.total:
            raise Unclear
        return size, f" from {size.total} blocks of {size.total} different colors", []
    if shape not in ("circle", "square") or size.name.startswith("a filled") or len(said.free) < 2:
        raise Unclear
    lots = counted(said.free, size.total, evenly=True)
    if any(lot.count is None for lot in lots):
        raise Unclear
    named = replace(size, measures=size.measures + " of alternating colors")
    return named, f" from {' and '.join(lot.blocks for lot in lots)}", []


def _alternate(said: _Told, total: int | None) -> bool:
    """Whether the blocks of a ring are listed one by one, two looks in turn; then each look is told of once."""
    looks = [lot.look for lot in said.free]
    if len(looks) < 4 or len(looks) != total or looks != looks[:2] * (total // 2) or looks[0] == looks[1]:
        return False
    if said.placed or any(lot.count not in (None, 1) for lot in said.free):
        return False
    said.free = [Lot(look, total // 2) for look in looks[:2]]
    return True


def _blocks(pieces: Sequence[Piece], shape: str) -> _Told:
    """The lots of the text with their places, clause by clause.

    Raises:
        Unclear: it is not clear which of them has which place.
    """
    pieces = _around(_its(pieces))
    said = _Told()
    clause: list[Piece] = []
    for piece in [*pieces, Piece("break", "")]:
        if piece.kind in ("lot", "place", "part", "each", "per"):
            clause.append(piece)
        if piece.kind in ("break", "except"):
            _clause(clause, said, shape)
            clause = []
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
    if len(lots) != 2 or len(around) != 1 or len(others) != 1 or pieces[around[0]].words.split()[-1] not in ("it", "that"):
        return list(pieces)
    first, second = lots
    between = [piece.kind for piece in pieces[first:second]]
    if lot_of(pieces[first]).count != 1 or "break" not in between or "figure" in between or "figure" in [p.kind for p in pieces[:first]]:
        return list(pieces)
    return [*pieces[: first + 1], Piece("place", "", "center"), *pieces[first + 1 :]]


def _clause(clause: Sequence[Piece], said: _Told, shape: str) -> None:
    """What one clause says of lots and places."""
    lots = [piece for piece in clause if piece.kind == "lot"]
    places = [piece for piece in clause if piece.kind != "lot"]
    at = [piece for piece in lots if "at" in piece.named]
    for piece in at:
        said.placed.append((lot_of(piece), _part(piece.named["at"], shape)))
    lots = [piece for piece in lots if piece not in at]
    if at and not lots:
        if any(place.kind == "part" or _part(place.value, shape) not in [p for _, p in said.placed] for place in places):
            raise Unclear
        return
    if not places:
        said.free += map(lot_of, lots)
    elif not lots and [_part(place.value, shape) for place in places if place.kind == "place"] == [p for _, p in said.placed[-1:]]:
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
            said.placed.append((replace(found, count=many or found.count), _part(part, shape)))


def _times(place: str, shape: str) -> int:
    """How many such places the figure has: one block in each of them makes so many.

    Raises:
        Unclear: it has none that are counted.
    """
    if place == "corners" and shape in ("square", "rectangle", "triangle"):
        return 3 if shape == "triangle" else 4
    if shape in ("plus", "X") and place in ("around", "arms"):
        return 4
    raise Unclear


def _part(place: str, shape: str) -> str:
    """The part of the figure that words for a place mean."""
    if place not in _PARTS[shape]:
        raise Unclear
    return _PARTS[shape][place]


def _total(said: _Told, total: int | None, shape: str) -> int | None:
    """How many blocks the figure has, as far as that is told, without one that stands in it."""
    inner = any(part == "inner" for _, part in said.placed) or "inner" in said.numbers
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


def _with_limbs(pieces: Sequence[Piece], said: _Told, shape: str) -> list[Piece]:
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


def _sum(said: _Told) -> int | None:
    """How many blocks are told of, if it is told of all of them how many."""
    counts: dict[str, int | None] = {lot.look: lot.count for lot in said.free}
    for lot, part in said.placed:
        if part == "inner":
            continue
        count = 1 if part in _SINGLE else lot.count
        if lot.look not in counts:
            counts[lot.look] = count
        elif lot.look not in [other.look for other in said.free]:
            raise Unclear  # blocks of one look at two places
    told_of = [count for count in counts.values() if count is not None]
    return sum(told_of) if told_of and len(told_of) == len(counts) else None


def _looks(said: _Told, size: Sized, shape: str) -> tuple[str, list[tuple[str, str]]]:
    """ "from 4 red blocks and 1 blue block", and which part has which look.

    Raises:
        Unclear: the numbers do not agree, or do not follow.
    """
    placed = [(lot, part) for lot, part in said.placed if part != "inner"]
    if len({part for _, part in placed}) < len(placed):
        raise Unclear
    lots = list(said.free)
    for lot, part in placed:
        many = 1 if part in _SINGLE else lot.count
        if part in _SINGLE and lot.count not in (None, 1):
            raise Unclear
        same = [other for other in lots if other.look == lot.look]
        if same and lot.count is not None and not lot.known and lot.count != same[0].count and same[0] in said.free:
            raise Unclear
        if not same:
            lots.append(replace(lot, count=many))
    total = size.total
    open_ = [lot for lot in lots if lot.count is None]
    if not lots:
        return (f" from {total} blocks" if total else ""), []
    parts = [(part, lot.look) for lot, part in placed]
    if len(open_) == 1 and (total is not None or len(lots) == 1) and (total is not None or not placed):
        lots = counted(lots, total)
        open_ = [lot for lot in lots if lot.count is None]
    if not said.free and total and not open_ and sum(lot.count or 0 for lot in lots) < total and dict(parts).keys() <= _SINGLE:
        return f" from {total} blocks", parts  # of the others no look is told
    if not open_ or len(lots) == 1:
        if total is not None and sum(lot.count or 0 for lot in lots) != total and not open_:
            raise Unclear
        blocks = " and ".join(lot.blocks for lot in lots)
        special = [(part, look) for part, look in parts if part != "rest"]
        if parts and not special and len(lots) == 2:
            raise Unclear
        most = {"corners": 3 if shape == "triangle" else 2 if shape == "U" else 4}
        for lot, part in placed:
            if lot.count and part in most and lot.count != most[part] or part in most and len(lots) == 1:
                raise Unclear
        return f" from {blocks}", special[:1] if {p for p, _ in special} == {"bar", "stem"} else special
    if any(lot.count for lot in said.free) or len(said.free) > 1:
        raise Unclear
    rest = [("rest", lot.look) for lot in said.free if lot.look not in [look for _, look in parts]]
    return (f" from {total} blocks" if total else ""), [*parts, *rest]


def _way(pieces: Sequence[Piece], shape: str) -> str:
    """ " with its foot to the right".

    Raises:
        Unclear: a part that the figure has not, or two ways.
    """
    ways = {(piece.value[0], piece.value[1]) for piece in pieces if piece.kind == "way"}
    ways |= {("tip", piece.value[1]) for piece in pieces if piece.kind == "base"}
    ways |= {("foot", piece.value[2]) for piece in pieces if piece.kind == "along"}
    if ("any", "") in ways:
        if len(ways) > 1 or any(piece.kind == "limb" and _DOWN.search(piece.words) for piece in pieces):
            raise Unclear
        return ""
    if shape == "T" and any(piece.kind in ("limb", "dims") and _DOWN.search(piece.words) for piece in pieces):
        ways.add(("stem", "front"))  # a figure is seen like a page
    found = set()
    for part, side in ways:
        if side == "upright":
            part, side = {"T": ("stem", "front"), "U": ("opening", "back"), "V": ("opening", "back"), "L": ("foot", "right")}.get(shape, ("", ""))
        elif part == "all":
            part, side = {"T": ("stem", "back"), "U": ("opening", "front"), "V": ("tip", "back")}.get(shape, ("", ""))
        elif part == "bar":
            part, side = "stem", _OVER.get(side, "")
        part = {"foot": "stem"}.get(part, part) if shape == "T" else part
        if part not in _ITS_WAY.get(shape, {}) or not side:
            raise Unclear
        found.add((part, side))
    if len(found) > 1:
        raise Unclear
    return "".join(f" with its {part} to the {side}" for part, side in found)
