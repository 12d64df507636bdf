"""One more block at an end of a row that has an order: "the digits 1 to 6 in order, a red block after the last one"."""

from __future__ import annotations

from collections.abc import Sequence

from rpg.language.frames.lines.label_words import LABEL
from rpg.language.frames.lines.sentences import Row
from rpg.language.frames.pieces import Pattern, Piece, Unclear, patterns

APPENDED: list[Pattern] = patterns(
    "appended", None,
    "(?:(?:with|and|plus|also|put|place|add|lay|there BE) )*(?:a|an|one) (?:plain )?(?P<color>COLOR)(?: BLOCK| one)? "
    "(?:placed |put |added |(?:right|directly|immediately) )*(?P<side>after|before|ahead of) (?:the )?(?:(?P<end>first|"
    f"last)(?: (?:one|BLOCK|number|digit|letter))?|(?:number |digit |letter )?(?P<label>{LABEL}))",
)  # fmt: skip
"""Kind "appended": a block that is not of the order, ahead of its first or behind its last."""


def without_appended(pieces: Sequence[Piece]) -> tuple[list[Piece], list[Piece]]:
    """The pieces without such blocks, and those."""
    return [p for p in pieces if p.kind != "appended"], [p for p in pieces if p.kind == "appended"]


def append(row: Row, more: Sequence[Piece]) -> None:
    """Make them part of the row.

    Raises:
        Unclear: the row has no order, or they have no end of it for themselves.
    """
    order = row.order
    if (
        not order
        or (row.noun == "line" and not row.direction)
        or len({p.named["side"] == "after" for p in more}) < len(more)
    ):
        raise Unclear
    for piece in more:
        after, color = piece.named["side"] == "after", piece.named["color"]
        end = order[-1 if after else 0]
        told = {"label": end, "end": "last" if after else "first"}
        if color in order or any(
            piece.named[key].strip("'").upper() != said.upper() for key, said in told.items() if key in piece.named
        ):
            raise Unclear
        row.counts[color] += 1
        row.order = order = [*order, color] if after else [color, *order]
