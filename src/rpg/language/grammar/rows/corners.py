"""Corners that are named once: "it starts in the far left corner; bring it to the near right one"."""

from __future__ import annotations

from dataclasses import replace

from rpg.language import lexicon
from rpg.language.tokens import Token

_DEEP = frozenset({"near", "far", "front", "back", "rear"})
_WIDE = frozenset({"left", "right"})
_INTO = frozenset({"in", "into", "to"})


def corners_again(tokens: list[Token]) -> list[Token]:
    """The tokens, with "the near right one" as a corner where one was named before, and nothing else was that could be
    in such a place: no patch, and nothing that is "one" in a corner of its own."""
    words = [token.word for token in tokens]
    if "corner" not in words or any(word in lexicon.PATCH for word in words):
        return tokens
    out = list(tokens)
    for n in range(words.index("corner") + 1, len(words) - 4):
        place = words[n : n + 5]
        sides = {*place[2:4]}
        if place[0] in _INTO and place[1] == "the" and place[4] == "one" and sides & _DEEP and sides & _WIDE:
            out[n + 4] = replace(tokens[n + 4], kind="word", word="corner", value=None)
    return out
