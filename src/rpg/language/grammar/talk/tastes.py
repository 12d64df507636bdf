"""A liking that is told in front of a wish: "My daughter loves purple, so make ..."."""

from __future__ import annotations

from collections.abc import Sequence

from rpg.language import lexicon
from rpg.language.idle_talk import idle
from rpg.language.tokens import Token

_FOND = frozenset({
    "love", "loves", "like", "likes", "adore", "adores", "prefer", "prefers", "enjoy", "enjoys", "fond", "favorite",
})  # fmt: skip
_HUES = frozenset({*lexicon.COLOR, *lexicon.COLOR_PLURAL})
_SO = 12
"""So many words at most tell of a taste."""


def taste_told(tokens: Sequence[Token]) -> int:
    """Where what follows from a liking begins; 0 where none is told.

    It is one if with something of daily life for the colours it would ask for nothing.
    """
    words = [token.word for token in tokens[:_SO]]
    so = next((n for n, word in enumerate(words[:-1]) if word in (",", ".") and words[n + 1] == "so"), 0)
    hues = [n for n, word in enumerate(words[:so]) if word in _HUES]
    if not hues or words[so - 1] not in _HUES or "would" in words[:so] or _FOND.isdisjoint(words[: hues[0]]):
        return 0
    said = [
        token.saying("games") if n in hues or token.word == "color" else token for n, token in enumerate(tokens[:so])
    ]
    return so + 2 if idle(said) else 0
