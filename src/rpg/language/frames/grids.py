"""One grid, checkerboard, wall, pyramid, or cube of blocks."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from dataclasses import replace

from rpg.language.frames.grid_fill import Cell, Filling, completed
from rpg.language.frames.grid_parts import Blocks, Said, said
from rpg.language.frames.grid_sizes import Figure, Sizes, figures
from rpg.language.frames.grid_words import COLORS, FIGURES, JOINTS, PLACES, SIZES
from rpg.language.frames.grid_words import Place
from rpg.language.frames.lots import LOTS, Lot, check_listed, one
from rpg.language.frames.pieces import Piece, Unclear
from rpg.language.frames.shared import BREAKS, GLUE, WHERE

PATTERNS = [*FIGURES, *SIZES, *PLACES, *COLORS, *LOTS, *WHERE, *JOINTS, *BREAKS, *GLUE]
_NAMES = {"rectangle": "grid", "square": "grid", "board": "grid"}


def told(pieces: Sequence[Piece]) -> str:
    """The figure in plain sentences.

    Raises:
        Unclear: its size does not follow, or which blocks are where.
    """
    check_listed(pieces)
    kind, words = _figure(pieces)
    where = _where(pieces)
    parts = said(pieces, dims_are_blocks=kind == "pyramid")
    checkered = kind == "board" or any(piece.kind == "checkered" for piece in pieces)
    labels = [item.look for item in parts.free if item.label]
    sizes = _sizes(pieces, kind, parts)
    total = _total(parts, kind)
    reading = any(piece.kind == "reading" for piece in pieces)
    if any(piece.kind == "taper" for piece in pieces) and kind != "pyramid" or (reading and not labels):
        raise Unclear
    found = []
    if checkered and not sizes.any:
        found = [_bare_board(parts, total)]
    else:
        for figure in figures(kind, words, sizes):
            try:
                text = _checkered(figure, parts, total) if checkered else _filled(figure, parts, total, sizes, reading)
            except Unclear:
                continue
            found.append((figure, text))
            if kind == "pyramid":
                break
    if len(found) != 1 or (kind == "pyramid" and not _sized(sizes, parts, total)):
        raise Unclear
    name = "wall" if kind == "wall" else kind if kind == "pyramid" else "grid"
    return f"{found[0]}{f' The {name} is {where}.' if where else ''}"
