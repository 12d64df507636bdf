"""One grid, checkerboard, wall, pyramid, or cube of blocks."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Collection, Mapping, Sequence
from dataclasses import replace
from itertools import accumulate, pairwise
from math import isqrt

from rpg.language.frames.grids.colors import COLORS
from rpg.language.frames.grids.composed import FRAMING, composed
from rpg.language.frames.grids.each import plain
from rpg.language.frames.grids.fill import Cell, Filling, completed
from rpg.language.frames.grids.layers import in_order, layered, merged
from rpg.language.frames.grids.measures import SIZES
from rpg.language.frames.grids.parts import Blocks, Said, by_turns, said
from rpg.language.frames.grids.sizes import Figure, Sizes, figures
from rpg.language.frames.grids.words import FIGURES, JOINTS, PLACES
from rpg.language.frames.lots import LOTS, Lot, lot_of, one, without_brackets
from rpg.language.frames.pieces import Piece, Unclear, patterns
from rpg.language.frames.shared import BREAKS, GLUE, WHERE

_WHERE = patterns(
    "where", lambda match: f"on the {match['patch']}", "on (?P<patch>(?:(?:SIZE|long|round) )?COLOR PATCH)"
)
PATTERNS = [*FRAMING, *FIGURES, *SIZES, *PLACES, *COLORS, *LOTS, *WHERE, *_WHERE, *JOINTS, *BREAKS, *GLUE]

_FILLED = frozenset({"filled", "full", "solid", "complete"})
_OF_GRIDS = frozenset({"place", "checkered", "total", "reading", "lines", "each"})
"""What is only said of a grid, so that "3x3" is one."""


def told(pieces: Sequence[Piece]) -> str:
    """The figure in plain sentences.

    Raises:
        Unclear: its size does not follow, or which blocks are where.
    """
    pieces, over = _over(merged(composed(without_brackets(pieces))))
    kind, words = _figure(pieces)
    pieces = in_order(pieces, "figure" if kind in ("wall", "pyramid", "cube") else "")
    pieces = plain(layered(pieces) if kind == "pyramid" else pieces, kind)
    if one(pieces, "any") and any(piece.kind in ("lot", "labels", "alternating") for piece in pieces):
        raise Unclear
    where = one(pieces, "where")
    parts = said(pieces, dims_are_blocks=kind == "pyramid")
    sizes = _sizes(pieces, parts)
    _check(pieces, kind, parts)
    counted = [item.count for _, items in parts.placed for item in items]
    counted += [place.blocks for places, _ in parts.placed for place in places]
    if not (sizes.any or _total(parts) or any(counted)):
        raise Unclear
    checkered = any(piece.kind == "checkered" or piece.value == "board" for piece in pieces) or (
        any(piece.kind == "alternating" for piece in pieces) and not parts.axis
    )
    found: list[str] = []
    for figure in figures(kind, words, sizes):
        try:
            found.append(_checkered(figure, parts) if checkered else _filled(figure, parts, sizes, pieces))
        except Unclear:
            continue
        if kind == "pyramid":
            break  # one that stands in a line is meant, where it can be
    if len(found) != 1:
        raise Unclear
    name = kind if kind in ("wall", "pyramid") else "grid"
    text = f"{found[0]} The {name} is {where.value}." if where else found[0]
    if over:
        odd = [figure for figure in figures(kind, words, sizes) if len(figure.widths) % 2 and figure.widths[0] % 2]
        if len(odd) != 1 or not odd[0].flat or over in re.findall(r"[a-z]+", found[0]):
            raise Unclear
        text += f" Put a {over} block on the center block."
    return text


def _over(pieces: Sequence[Piece]) -> tuple[list[Piece], str]:
    """The pieces without the one block that lies on that in the middle, and its look.

    Raises:
        Unclear: there are more blocks on it, or none.
    """
    at = [n for n, piece in enumerate(pieces) if piece.kind == "over"]
    if not at:
        return list(pieces), ""
    n = at[0]
    near = [m for m in (n - 1, n + 1) if 0 <= m < len(pieces) and pieces[m].kind == "lot"]
    if len(at) > 1 or len(near) != 1:
        raise Unclear
    lot = lot_of(pieces[near[0]])
    if lot.count != 1 or lot.known or " " in lot.look:
        raise Unclear
    return [piece for m, piece in enumerate(pieces) if m not in (n, near[0])], lot.look


def _figure(pieces: Sequence[Piece]) -> tuple[str, str]:
    """The kind of the one figure, and the words it is called by; of rows and columns without a name it is a grid.

    Raises:
        Unclear: there are several, or none.
    """
    at = [n for n, piece in enumerate(pieces) if piece.kind == "figure"]
    dims = " ".join(piece.words for piece in pieces if piece.kind == "dims")
    words = " ".join([dims, *(piece.words for piece in pieces if piece.kind in ("figure", "square", "filled", "flat"))])
    rows = any("rows" in piece.value for piece in pieces if piece.kind == "size")
    sizes = [piece.value for piece in pieces if piece.kind == "dims"]
    filled = any(p.kind == "filled" for p in pieces) or not _FILLED.isdisjoint(dims.split())
    narrow = bool(sizes) and min(sizes[0]) == 2  # its outline is all of it
    if any(pieces[n].value == "outline" for n in at) and not rows and not narrow and not filled:
        raise Unclear  # of a rectangle without a word more the outline is meant
    kinds = {{"board": "grid", "outline": "rectangle"}.get(pieces[n].value, pieces[n].value) for n in at}
    if len(kinds) > 1:
        kinds -= {"square", "rectangle"}
        kinds -= {"grid"} if "cube" in kinds else set()
    for before, n in pairwise(at):
        ahead = " ".join(piece.words for piece in pieces[before + 1 : n])
        if pieces[before].value == pieces[n].value and not ahead.endswith(("the", "this", "as a", "it is a")):
            raise Unclear  # "a red grid and a blue grid"
    if not kinds:
        named = {word for piece in pieces if piece.kind == "place" for word in piece.words.split()}
        kinds = named & {"grid", "wall", "pyramid"}  # "the base of the pyramid"
    if not kinds:
        kinds = {"cube" if any("layers" in piece.value for piece in pieces if piece.kind == "size") else "grid"}
        if not _is_grid(pieces):
            raise Unclear
    if len(kinds) != 1:
        raise Unclear
    return kinds.pop(), words


def _is_grid(pieces: Sequence[Piece]) -> bool:
    """Whether rows and columns are told, so that it need not be said that this is a grid; "two rows of three" may lie
    anywhere."""
    sizes = [set(piece.value) for piece in pieces if piece.kind == "size"]
    names = {name for size in sizes for name in size}
    apart = {name for size in sizes if len(size) == 1 for name in size}
    if {"rows", "columns"} <= apart or {"layers"} < names:
        return True
    if any(piece.kind == "dims" for piece in pieces):
        return any(piece.kind in _OF_GRIDS or "noun" in piece.named for piece in pieces)
    column = any(
        piece.value == "column" if piece.kind == "each" else piece.kind == "place" and piece.value.axis == "column"
        for piece in pieces
    )
    across = column or any(piece.kind in ("checkered", "reading") for piece in pieces)
    return across and {"rows", "columns"} <= names


def _check(pieces: Sequence[Piece], kind: str, parts: Said) -> None:
    """What is told in passing is told of something that is there.

    Raises:
        Unclear: it is not.
    """
    for piece, after in pairwise(pieces):
        if piece.kind == "lot" and after.kind == "figure" and not piece.named.keys().isdisjoint({"size", "behind"}):
            raise Unclear  # "a large red wall" is no wall of large blocks
    several = len({item.look for item in parts.free if item.look}) > 1
    for piece, after in pairwise(pieces):
        if several and piece.kind == "size" and len(piece.value) > 1 and after.kind == "lot":
            raise Unclear  # "two rows of three red and three blue blocks"
        added = piece.kind == "lot" and piece.named.get("det") in ("a", "an") and after.kind == "place"
        if added and parts.free and after.words.split()[0] in ("layer", "row", "level"):
            raise Unclear  # "a red wall with a blue layer on top" may have a layer more
    kinds = {piece.kind for piece in pieces}
    labels = [item for item in parts.all if item.label]
    if ("taper" in kinds and kind != "pyramid") or ("symbols" in kinds and not labels):
        raise Unclear
    if ("square" in kinds and kind != "pyramid") or (by_turns(pieces) and parts.axis and len(parts.listed) != 2):
        raise Unclear


def _sizes(pieces: Sequence[Piece], parts: Said) -> Sizes:
    """All that is told of the size.

    Raises:
        Unclear: two numbers for the same.
    """
    each: dict[str, int] = {}
    for piece in pieces:
        for name, size in piece.value.items() if piece.kind == "size" else ():
            if each.setdefault(name, size) != size:
                raise Unclear
    base = one(pieces, "base")
    parts.based = bool(base or {"base", "line"} & set(each))
    bases = [item.base for item in parts.all if item.base]
    if bases:
        return Sizes(each, None, base.value if base else max(bases))
    dims = one(pieces, "dims")
    squares = [piece for piece in pieces if piece.kind == "figure" and piece.value == "square"]
    total = _total(parts)
    counted = any(not item.look for item in parts.free)
    if squares and counted and not dims and not each and not base and total in (4, 9, 25):
        side = isqrt(total)  # no outline of a square has so many, or it is the same
        return Sizes(each, (side, side))
    return Sizes(each, dims.value if dims else None, base.value if base else None)


def _total(parts: Said) -> int | None:
    """How many blocks there are in all, where that is told.

    Raises:
        Unclear: two such numbers.
    """
    found = {item.count for item in parts.free if not item.look and not item.base}
    if not found and parts.free and not parts.placed and all(item.count for item in parts.free):
        return sum(item.count or 0 for item in parts.free)
    if len(found) > 1:
        raise Unclear
    return found.pop() if found else None


def _filled(figure: Figure, parts: Said, sizes: Sizes, pieces: Sequence[Piece]) -> str:
    """A figure whose blocks are told by their places, or only by their numbers."""
    total = _total(parts)
    filling = Filling(figure, parts)
    if not figure.flat:
        _check_layers(figure, parts, sizes, pieces, len(filling.looks))
    free = [item for item in parts.free if item.look]
    if any(item.half for item in free):
        if len(figure.cells) % 2:
            raise Unclear
        free = [replace(item, count=len(figure.cells) // 2) if item.half else item for item in free]
    reading = {piece.value for piece in pieces if piece.kind == "reading"}
    down = any(piece.kind == "size" and "columns of" in piece.words for piece in pieces)
    if down and "ordered" in reading:
        raise Unclear  # "two columns of three in ascending order" may be read down the columns
    if reading - {"verb"} or (reading and any(item.label for item in free) and not filling.looks):
        return _read(figure, free, total, reading, filled=bool(filling.looks))
    if parts.each and free and all(item.count is None for item in free) and not filling.looks:
        lines = filling.lines(parts.each)
        if len({len(line) for line in lines}) > 1 or len(lines) != len(free):
            raise Unclear
        free = [replace(item, count=len(lines[0])) for item in free]
    counts = completed(filling, free, total)
    for line in filling.lines(parts.each) if parts.each else ():
        if len({filling.looks.get(cell, "") for cell in line}) > 1:
            raise Unclear
    if parts.each and not parts.listed and not any(filling.looks.values()):
        return _each(figure, counts, filling.looks, parts)
    if counts is not None:
        return f"Build {figure.told} from {_lots(counts)}."
    return f"Build {figure.told}{_cells(figure, filling.looks)}"


def _check_layers(figure: Figure, parts: Said, sizes: Sizes, pieces: Sequence[Piece], filled: int) -> None:
    """What is told of the layers is told of all of them. `filled`: of how many places something is told.

    Raises:
        Unclear: numbers are told of some of them, or are not theirs, or may be theirs.
    """
    for counts in (list(map(int, piece.value)) for piece in pieces if piece.kind == "counts"):
        if sorted(counts) != [*figure.widths] or counts not in (sorted(counts), sorted(counts)[::-1]):
            raise Unclear
    free = [item for item in parts.free if item.look]
    below = figure.widths[-1] if {"base", "line"} & set(sizes.each) else 0
    counted = sum(any(item.count for item in items) for _, items in parts.placed)
    tapers = any(piece.kind == "taper" for piece in pieces) and not any(item.look for item in parts.all)
    if not tapers and filled + below < len(figure.cells) and counted > bool(free) and _total(parts) is None:
        raise Unclear
    falling = all((this.count or 0) - (next_.count or 0) == 1 for this, next_ in pairwise(free))
    if falling and len(free) > 1 and not parts.placed:
        raise Unclear  # "a pyramid: three red, two blue, one green"


def _read(figure: Figure, free: Sequence[Blocks], total: int | None, reading: Collection[str], *, filled: bool) -> str:
    """Blocks listed in the order in which the places are read."""
    ordered = "ordered" in reading
    listed = [item.look for item in free for _ in range(item.count or 1)]
    if len(listed) != len(figure.cells) or total not in (None, len(listed)) or filled:
        raise Unclear
    if ordered and (not all(item.label for item in free) or listed != sorted(listed)):
        raise Unclear
    if "near" in reading:  # "the front row first"
        ends = [*accumulate(figure.widths)]
        lines = [listed[end - width : end] for end, width in zip(ends, figure.widths, strict=True)]
        if not figure.flat or "told" in reading:
            raise Unclear
        return f"Build {figure.told} from far to near: {', then '.join(map(', '.join, reversed(lines)))}."
    return f"Build {figure.told}, in reading order: {', '.join(listed)}."


def _each(figure: Figure, counts: Mapping[str, int] | None, looks: Mapping[Cell, str], parts: Said) -> str:
    """A figure of which each line has one colour, and it is not told which line has which."""
    if looks or (counts is None and any(item.look for item in parts.free)):
        raise Unclear
    blocks = _lots(counts) if counts else f"{len(figure.cells)} blocks"
    axis = "layer" if parts.each == "row" and not figure.flat else parts.each
    return f"Build {figure.told} from {blocks}. Each {axis} has one color."


def _lots(counts: Mapping[str, int]) -> str:
    if all(count == 1 for count in counts.values()):
        return ", ".join(counts) if all(len(look) == 1 for look in counts) else f"{', '.join(counts)} blocks"
    return " and ".join(Lot(look, count).blocks for look, count in counts.items())


def _cells(figure: Figure, looks: Mapping[Cell, str]) -> str:
    """What all places hold."""
    listed = [looks.get(cell, "") for cell in figure.cells]
    if not any(listed):
        return f" from {len(listed)} blocks."
    if len(set(listed)) == 1:
        return f" from {Lot(listed[0], len(listed)).blocks}."
    layers = [{looks.get(cell, "") for cell in figure.cells if cell[0] == line} for line in range(len(figure.widths))]
    if len({*figure.widths}) > 1 and not figure.flat and all(len(layer) == 1 and all(layer) for layer in layers):
        upward = [look for layer in reversed(layers) for look in layer]
        return f", layers from bottom to top: {', '.join(upward)}."  # in whatever direction it stands
    if all(len(look) == 1 for look in listed):
        return f" in the order {', '.join(listed)}."  # symbols "in reading order" might be sorted
    return f", in reading order: {', '.join(listed)}."


def _checkered(figure: Figure, parts: Said) -> str:
    """A figure of two colours by turns, both ways.

    Raises:
        Unclear: these are not two colours, or their numbers or places are not such.
    """
    others = [item for places, items in parts.placed for item in items if places[0].kind == "rest"]
    placed = [(places, items) for places, items in parts.placed if places[0].kind != "rest"]
    fixed = Filling(figure, Said(placed=placed)).looks
    free = [item for item in [*parts.free, *others] if item.look]
    names = list(dict.fromkeys([*(item.look for item in free), *fixed.values()]))
    if parts.listed or parts.each or len(names) not in (0, 2) or not figure.columns or figure.square:
        raise Unclear
    if _total(parts) not in (None, len(figure.cells)):
        raise Unclear
    found = []
    for first, second in (names, names[::-1]) if names else ():
        looks = {(line, n): second if (line + n) % 2 else first for line, n in figure.cells}
        counts = Counter(looks.values())
        if all(looks[cell] == look for cell, look in fixed.items()) and all(
            item.count in (None, counts[item.look]) for item in free
        ):
            found.append((looks, counts))
    rows, columns = len(figure.widths), figure.widths[0]
    board = f"Build a {rows}x{columns} checkerboard"
    if not names:
        return f"{board} from {rows * columns} blocks."
    if len(found) == 1:
        return f"Build {figure.told}{_cells(figure, found[0][0])}"
    if not found:
        raise Unclear
    if not figure.flat:
        return f"Build {figure.told} of {names[0]} and {names[1]} blocks in a checkerboard pattern."
    return f"{board} of {names[0]} and {names[1]} blocks."
