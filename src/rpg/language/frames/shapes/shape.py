"""One flat figure on the table: a plus, a ring, a letter, a square, a rectangle, a triangle."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import replace
from itertools import pairwise

from rpg.language.frames.lots import Lot, as_adjectives, check_listed, check_owned, declared, one, without_brackets
from rpg.language.frames.pieces import Piece, Unclear
from rpg.language.frames.shapes.blocks import blocks_of, by_side, each_side, parted, sum_of, total_of, with_limbs
from rpg.language.frames.shapes.looks import alternate, check_incomplete, colored, looks_of
from rpg.language.frames.shapes.sizes import sized
from rpg.language.frames.shapes.words import PATTERNS as PATTERNS

_ITS_WAY = {
    **{letter: {"stem": "stem", "bar": "bar"} for letter in "T"},
    "L": {"foot": "foot", "bar": "foot"},
    "U": {"opening": "opening"},
    "V": {"opening": "opening", "tip": "tip"},
    "triangle": {"tip": "tip"},
}
_DOWN = re.compile(r"\b(?:down|downwards?|below|underneath|under|hang|hanging)\b")
_ROW_AT = re.compile(
    r"\b(?P<count>\d+|one)(?: blocks?| cubes?)? (?:along|at|in|on|for) (?:the |its )?(?P<side>front|near|nearest|"
    r"back|far|rear|farthest)\b"
)
_CORNERS = re.compile(r"\b(\d+|one|a|an|single) (?:of (?:the|its) )?(?:corners?|vertex|vertices|corner points?)\b")
_ARTICLES = ("a", "an", "the")
_OVER = {"front": "back", "back": "front", "left": "right", "right": "left"}


def told(pieces: Sequence[Piece]) -> str:
    """The figure in plain sentences.

    Raises:
        Unclear: it is not told which figure it is, or not which blocks it is made of.
    """
    _check_for_whom(pieces)
    pieces = parted(_but_so(without_brackets(as_adjectives(pieces))))
    check_listed(pieces)
    check_owned(pieces, ("way", "limb", "arm", "side", "place", "along", "base"))
    _check_parts(pieces)
    shape = _shape(pieces)
    _check_corners(pieces, shape)
    based = any(piece.kind == "place" and piece.value == "base" for piece in pieces)
    if shape in ("square", "triangle", "L", "U") and not based:
        pieces = by_side(pieces)
    elif shape == "plus" or based:
        pieces = each_side(pieces)
    said = blocks_of(pieces, shape)
    _check_where(pieces)
    total, colors = one(pieces, "total"), one(pieces, "colors")
    if any(piece.kind == "except" for piece in pieces) and any(lot.count for lot in said.free):
        raise Unclear  # is it one of them?
    pieces = with_limbs(pieces, said, shape)
    hues = {piece.named["hue"] for piece in pieces if piece.kind in ("limb", "along") and "hue" in piece.named}
    if hues:
        if len(hues) > 1 or said.free or said.placed:
            raise Unclear  # which of them is the corner?
        said.free = [Lot(hues.pop())]
    if shape == "plus" and said.numbers == {"center": 1}:
        pieces = [*pieces, Piece("apart", "", True)]  # "two on each arm and one in the middle"
    if shape == "plus" and {"center", "rest"} <= {part for _, part in said.placed}:
        pieces = [*pieces, Piece("apart", "", True)]  # "a white center and arms of two red blocks"
    if any(piece.kind == "fill" and piece.value == "hollow" for piece in pieces):
        if shape == "circle" and any(part == "inner" for _, part in said.placed):
            raise Unclear  # is its middle empty?
        said.placed = [(lot, "inner" if part == "center" else part) for lot, part in said.placed]
    inner = [lot for lot, part in said.placed if part == "inner"]
    size = total_of(said, total.value if total else None, shape)
    if inner:
        said.free = [lot for lot in said.free if lot.look != inner[0].look or lot.count != 1]
    size_of = sized(pieces, shape, size if size is not None else sum_of(said))
    if said.free and said.placed and size is None and not size_of.measured and not inner:
        check_incomplete(said, shape)
    if one(pieces, "any") and (said.free or said.placed):
        raise Unclear
    if colors or alternate(said, size_of.total):
        size_of, looks, parts = colored(said, size_of, colors.value if colors else "alternating", shape)
    else:
        looks, parts = looks_of(said, size_of, shape)
    each = any(piece.kind == "each" for piece in pieces)
    if parts and each and size_of.name.startswith("a filled") and shape == "square":
        raise Unclear  # the colours of its places are those of a grid
    way = _way(pieces, shape)
    text = f"Build {size_of.name}{size_of.measures}{looks}{way}."
    text += "".join(f" The {part} {'are' if part in ('corners', 'rest') else 'is'} {look}." for part, look in parts)
    if inner:
        text += f" A {inner[0].look} block is in the middle of the {shape}."
    where = one(pieces, "where")
    return f"{text} The {shape} is {where.value}." if where else text


def _check_corners(pieces: Sequence[Piece], shape: str) -> None:
    """Raise Unclear at "a square of which one corner is red", "three corners": not all of them."""
    said = [_CORNERS.search(piece.words) for piece in pieces]
    counts = [1 if not match[1].isdigit() else int(match[1]) for match in said if match]
    if any(count != {"triangle": 3, "U": 2, "L": 1, "V": 1}.get(shape, 4) for count in counts):
        raise Unclear


def _check_for_whom(pieces: Sequence[Piece]) -> None:
    """Raise Unclear at "and for the block at the corner, which is red", which says nothing of itself."""
    for lead, place, told in zip(pieces, pieces[1:], pieces[2:], strict=False):
        if lead.words == "for" and place.kind == "place" and told.words.startswith(", which"):
            raise Unclear


def _but_so(pieces: Sequence[Piece]) -> list[Piece]:
    """ "The letter T, but upside down": behind such a "but" is no block that is left out."""
    turns = [piece.kind == "except" and behind.kind == "way" for piece, behind in pairwise(pieces)]
    return [replace(p, kind="break") if turn else p for p, turn in zip(pieces, [*turns, False], strict=True)]


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
    makes = ("make", "build", "form", "create", "construct", "draw", "making", "forming", "building", "creating")
    wished = declared(pieces[first + 1 :])
    if last == "the" and not wished and (len(ahead) < 2 or ahead[-2] not in makes):
        raise Unclear  # "the circle ..." tells of one that is there
    letter = len(shape) == 1 and last not in ("a", "an") and "shape" not in pieces[first].words
    if letter and not wished and last in ("put", "place", "set", "bring", "lay", "the"):
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
    if [piece.words for piece in ahead[-1:]] == ["and"] and [piece.kind for piece in ahead[-2:-1]] in (
        ["lot"],
        ["total"],
    ):
        raise Unclear


def _check_parts(pieces: Sequence[Piece]) -> None:
    """ "Four of them" are some of blocks that are told of without a look.

    Raises:
        Unclear: "eight red blocks, one of them blue".
    """
    lots = [piece for piece in pieces if piece.kind == "lot" and "count" in piece.named]
    some = [piece for piece in lots if {"them", "these", "which"} & set(piece.words.split())]
    if some and len(some) < len(lots) and not one(pieces, "total"):
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
        if piece.kind not in ("break", "except"):
            continue
        of_some = {"place", "part", "pivot"} & set(clause) or ({"lot", "total"} & set(clause) and lots > 1)
        if "where" in clause and "figure" not in clause and of_some:
            raise Unclear
        clause = []


def _tips(piece: Piece) -> set[str]:
    """Where the tip of a triangle is by the places of its rows: "three in the front row, ..., one at the back"."""
    found = set()
    for row in _ROW_AT.finditer(piece.words):
        side = "front" if row["side"] in ("front", "near", "nearest") else "back"
        count = 1 if row["count"] == "one" else int(row["count"])
        if count not in (1, max(piece.value)):
            continue
        found.add(side if count == 1 else _OVER[side])
    return found


_LIMBS = {"along": "foot", "short": "foot", "up": "long", **{limb: limb for limb in ("long", "bar", "stem")}}
"""The parts that point where "which should point to the right" stands behind their size."""


def _ways(pieces: Sequence[Piece]) -> Iterator[tuple[str, str]]:
    """The parts that point somewhere: the tip, unless "which points" is said behind another one."""
    before = ""
    for piece in pieces:
        if piece.kind == "way":
            yield piece.value[0] or before or "tip", piece.value[1]
        if piece.kind not in ("glue", "break"):
            before = _LIMBS.get(piece.value[0], "") if piece.kind == "limb" else ""


def _way(pieces: Sequence[Piece], shape: str) -> str:
    """ " with its foot to the right".

    Raises:
        Unclear: a part that the figure has not, or two ways; an L whose long arm does not lead away from its foot.
    """
    ways = {("long" if (shape, part) == ("L", "stem") else part, side) for part, side in _ways(pieces)}
    ways |= {("tip", piece.value[1]) for piece in pieces if piece.kind == "base"}
    ways |= {("foot", piece.value[2]) for piece in pieces if piece.kind == "along"}
    ways |= {("tip", side) for piece in pieces if piece.kind == "rows" for side in _tips(piece)}
    if ("any", "") in ways:
        if len(ways) > 1 or any(piece.kind == "limb" and _DOWN.search(piece.words) for piece in pieces):
            raise Unclear
        return ""
    if shape == "T" and any(piece.kind in ("limb", "dims") and _DOWN.search(piece.words) for piece in pieces):
        ways.add(("stem", "front"))  # a figure is seen like a page
    found = set()
    if ("long", "back") in ways and any(part == "foot" and side in ("left", "right") for part, side in ways):
        ways.discard(("long", "back"))
    for part, side in ways:
        if side == "upright":
            part, side = {
                "T": ("stem", "front"),
                "U": ("opening", "back"),
                "V": ("opening", "back"),
                "L": ("foot", "right"),
            }.get(shape, ("", ""))
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
