"""Sentences that only a comma parts: "four cubes in a row, three white and one red, red is second from the left"."""

from __future__ import annotations

from dataclasses import replace

from rpg.language import lexicon
from rpg.language.phrases import by_first, length_at
from rpg.language.tokens import Token

_AND = frozenset({"and", "but", "while", "whereas", "where"})
_BE = by_first(("is", "are", "comes", "stands", "goes", "sits", "must be", "should be", "has to be", "must come",
                "should come", "must stand", "should stand", "must go", "should go", "shall be", "is to be",
                "being", "lies"))  # fmt: skip
_ONE = frozenset({"one", "block", "cube", "brick", "box", "letter", "number", "digit", "ones", "blocks", "cubes"})
_PLACES = frozenset({"leftmost", "rightmost", "last", "topmost", "uppermost", "lowest", "highest", "closest",
                     "nearest", "farthest", "furthest", *lexicon.ORDINAL})  # fmt: skip
_AT = frozenset({"at", "on", "in"})
_ENDS = frozenset({"left", "right", "top", "bottom", "front", "back", "end", "beginning", "start", "very", "far",
                   "near", "middle", "center", "centre", "first", "second", "third", "last"})  # fmt: skip
_ENDING = frozenset({",", ".", ";", "!", "?"})


def in_sentences(tokens: list[Token]) -> list[Token] | None:
    """The words with a full stop where behind a line of blocks it is said which one is at which place of it."""
    out: list[Token] = []
    lined = False
    n = 0
    while n < len(tokens):
        token = tokens[n]
        lined = lined or token.word in lexicon.STRUCTURE or token.word in ("stack", "stacked")
        if token.word == "," and lined:
            start = n + 1 + (n + 1 < len(tokens) and tokens[n + 1].word in _AND)
            if _tells_a_place(tokens, start):
                out.append(replace(token, word=".", raw="."))
                n = start
                continue
        out.append(token)
        n += 1
    return out if len(out) < len(tokens) or [t.word for t in out] != [t.word for t in tokens] else None


def _tells_a_place(tokens: list[Token], n: int) -> bool:
    """ "Red is the second from the left", "the blue one stands at the right end"."""
    words = [token.word for token in tokens[n : n + 12]] + [""] * 12
    at = 1 if words[0] == "the" else 0
    looks = words[at] in lexicon.COLOR or words[at] in lexicon.LETTER or (len(words[at]) == 1 and words[at].isalnum())
    if not looks:
        return False
    at += 1 + (words[at + 1] in _ONE)
    verb = max((length_at(words, at, found) for found in (_BE.get(words[at], ()),)), default=0)
    at += verb
    if not verb:
        return False
    at += words[at] == "the"
    if words[at] in _PLACES:
        return True
    at += words[at] in _AT
    at += words[at] == "the"
    return words[at - 1] in (*_AT, "the") and words[at] in _ENDS
