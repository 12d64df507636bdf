"""Two sides told by their names alone: "put the reds left and the blues right", "A goes left, B goes right"."""

from __future__ import annotations

from rpg.language import lexicon
from rpg.language.tokens import Token

_OTHER = {"left": "right", "right": "left"}
_AFTER = frozenset({",", "and", ".", ";", "while", "!"})
_PUT = frozenset({"put", "place", "move", "set", "bring", "push", "slide"})
_GO = frozenset({"go", "goes"})
_NOUNS = frozenset({"one", "ones", "numbers", "digits", "letters", "vowels", "consonants", "evens", "odds", "half",
                    "number", "letter", "vowel", "consonant", "digit"})  # fmt: skip
_HUES = frozenset({*lexicon.COLOR, *(f"{color}s" for color in lexicon.COLOR), *lexicon.BLOCK})


def bare_sides(tokens: list[Token], words: list[str]) -> list[Token] | None:
    """The tokens with "to the" before both; where nothing is put or goes there, a note says it as it stands."""
    sides = [n for n, word in enumerate(words) if word in _OTHER and _bare(tokens, words, n)]
    if {words[n] for n in sides} != {*_OTHER} or len(sides) != len(_OTHER):
        return None
    out = list(tokens)
    for n in reversed(sides):
        out[n:n] = [tokens[n].saying(word) for word in ("to", "the")]
    return out


def _bare(tokens: list[Token], words: list[str], n: int) -> bool:
    """Whether a side ends what is said of some blocks."""
    if not n or (n + 1 < len(words) and words[n + 1] not in _AFTER):
        return False
    before = words[n - 1]
    put = not _PUT.isdisjoint(words[:n]) or not _GO.isdisjoint(words[:n])
    named = before in _NOUNS or before in _HUES or (len(tokens[n - 1].raw) == 1 and tokens[n - 1].kind != "punct")
    return before in _GO or (put and named)
