"""The largest number of some digits: "arrange 3, 1 and 4 so that they form the largest possible number" is 431."""

from __future__ import annotations

from dataclasses import replace

from rpg.language import lexicon
from rpg.language.phrases import length_at
from rpg.language.tokens import Token

_LARGEST = frozenset({"largest", "biggest", "highest", "greatest"})
_UTMOST = frozenset({*_LARGEST, "smallest", "lowest", "least"})
_BESIDE = frozenset({"possible", "digit", "-"})
_BEHIND = (("possible",), ("you", "can", "make"), ("you", "can"), ("they", "can"), ("that", "they", "can"),
           ("that", "is", "possible"), ("that", "you", "can"))  # fmt: skip
_MAKE = frozenset(
    {"form", "forms", "make", "makes", "show", "shows", "build", "create", "write", "read", "give", "into"}
)
"""What stands before a number that the digits are to make: "the largest number on the left" is one of them."""
_LEAST = 2
"""Digits that make a number of several."""


def utmost_number(tokens: list[Token], words: list[str]) -> list[Token] | None:
    """The tokens with the number itself, where the digits are listed, and all of them make it."""
    at = next((n for n, word in enumerate(words) if word in _UTMOST), -1)
    noun = next((n for n in range(at + 1, min(at + 6, len(words))) if words[n] == "number"), 0) if at > 0 else 0
    made = at > 1 and words[at - 1] in ("the", "a") and words[at - 2] in _MAKE
    if not noun or not made or not all(map(_allowed, tokens[at + 1 : noun])):
        return None
    end = noun + 1
    end += length_at(words, end, _BEHIND)
    digits = [t.raw for n, t in enumerate(tokens) if not at <= n < end and t.kind == "number"]
    if len(digits) < _LEAST or not all(len(digit) == 1 for digit in digits):
        return None
    told = [_many(token) for token in tokens[at + 1 : noun] if _many(token)]
    text = "".join(sorted(digits, reverse=words[at] in _LARGEST))
    if any(many != len(digits) for many in told) or (text[0] == "0" and not told):
        return None
    if text[0] == "0":
        first = min(digit for digit in digits if digit != "0") if set(digits) != {"0"} else "0"
        text = first + text.replace(first, "", 1)
    number = replace(tokens[noun], kind="number", word=text, raw=text, value=float(text))
    return [*tokens[: at - 1], tokens[at].saying("the"), tokens[noun], number, *tokens[end:]]


def _allowed(token: Token) -> bool:
    return token.word in _BESIDE or bool(_many(token))


def _many(token: Token) -> int:
    """How many digits it is said to have."""
    word = token.word.removesuffix("digit").rstrip("-") if token.word != "digit" else ""
    if token.kind == "number" and isinstance(token.value, float):
        return int(token.value)
    return lexicon.NUMBER.get(word, 0)
