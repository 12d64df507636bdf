"""A text told again by the one family that knows all of its parts."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace

from rpg.language.frames import equation, group, spelled, tower, towers
from rpg.language.frames.pieces import Pattern, Piece, Unclear, cut
from rpg.language.tokens import Token, tokenize

FAMILIES: tuple[tuple[Sequence[Pattern], Callable[[Sequence[Piece]], str]], ...] = (
    (tower.PATTERNS, tower.told),
    (group.PATTERNS, group.told),
    (equation.PATTERNS, equation.told),
    (spelled.PATTERNS, spelled.told),
    (towers.PATTERNS, towers.told),
)
"""The patterns of each family, and how it tells its pieces again (or raises Unclear)."""


def retold(tokens: list[Token]) -> tuple[list[Token], str] | None:
    """The text in plain sentences, their tokens standing where the text stands; None where no family knows all of its
    words, or where several tell it in different ways."""
    found = set()
    for known, told in FAMILIES:
        pieces = cut(tokens, known)
        try:
            found |= {told(pieces)} if pieces else set()
        except Unclear:
            continue
    if len(found) != 1:
        return None
    text, span = found.pop(), (tokens[0].span[0], tokens[-1].span[1])
    return [replace(token, span=span) for token in tokenize(text)[0]], text
