""" "Make a palindrome out of the letters L, E, V, E and L": those letters in a row, in whichever mirrored order."""

from __future__ import annotations

from collections import Counter

from rpg.language.grammar.rows.parting import STOPS
from rpg.language.tokens import Token

_FROM = ("out", "of", "from", "with", "using")
_LETTERS = frozenset({"the", "these", "letter", "letters", "block", "blocks", "cube", "cubes"})
_JOINTS = frozenset({",", "and"})
_MAKE = frozenset({"make", "build", "form", "create", "arrange", "spell", "write", "lay", "put", "a", "please"})


def palindromes(tokens: list[Token]) -> list[Token]:
    """The tokens, with the letters sorted: in the order in which they are told they may be one palindrome of many."""
    words = [token.word for token in tokens]
    at = words.index("palindrome") if "palindrome" in words else 0
    begin = next((n + 1 for n in range(at - 1, -1, -1) if words[n] in STOPS), 0)
    end = next((n for n in range(at, len(words)) if words[n] in STOPS), len(words))
    behind = at + 1
    while behind < end and words[behind] in _FROM:
        behind += 1
    told = [token for token in tokens[behind:end] if token.word not in _LETTERS and token.word not in _JOINTS]
    if not at or behind == at + 1 or not _MAKE.issuperset(words[begin:at]) or len(told) < _FEWEST:
        return tokens
    alone = [count for count in Counter(token.raw for token in told).values() if count % 2]
    if len(alone) > 1 or not all(len(token.raw) == 1 and token.raw.isupper() for token in told):
        return tokens
    first = tokens[begin]
    listed = [part for token in sorted(told, key=lambda token: token.raw) for part in (token, first.saying(","))]
    row = ("in", "a", "row", "in", "mirrored", "order")
    said = [*map(first.saying, ("put", "the", "letters")), *listed[:-1], *map(first.saying, row)]
    return [*tokens[:begin], *said, *tokens[end:]]


_FEWEST = 3
