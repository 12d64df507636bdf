"""Texts as the second reader meets them."""

from __future__ import annotations

from rpg.language.frames.retelling import plainly
from rpg.language.grammar.talk.asides import without_asides
from rpg.language.spelling import read_words
from rpg.language.tokens import Token, tokenize


def words(text: str) -> list[Token]:
    """The words of a text, with the talk taken out that never says anything."""
    return without_asides(read_words(tokenize(text)[0])[0])


def told(text: str) -> str | None:
    """What the one family that knows all of a text's words tells; None where none does."""
    return plainly(words(text))
