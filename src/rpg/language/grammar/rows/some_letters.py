"""Some of several letters that are alike: "spell NOON. One O is blue." is of one of the Os, and of no circle."""

from __future__ import annotations

from collections import Counter

from rpg.language import lexicon
from rpg.language.tokens import Token

_SPELT = frozenset({"spell", "spells", "spelling", "write", "writes", "word", "read", "reads", "says", "say"})
_A = frozenset({"a", "an", "one"})
_IS = frozenset({"is", "are", "must", "should", "shall", "be", "being", "to", "has"})
"""What leads to the colour of a letter."""
_SO = frozenset({"upside", "upright", "turned", "rotated", "flipped", "sideways", *lexicon.COLOR})
_TOLD = frozenset({"of", "the"})
"""Ahead of a number these tell already of which letters it is."""


def some_of_the_letters(tokens: list[Token]) -> list[Token]:
    """The tokens with "one of the O blocks" for the "one O" of a word or a lot that has several."""
    out: list[Token] = []
    there: Counter[str] = Counter()
    for n, token in enumerate(tokens):
        letter = token.raw
        if len(letter) > 1 and letter.isupper() and not _SPELT.isdisjoint(before.word for before in tokens[:n]):
            there |= Counter(letter)
        many = (1 if out[-1].word in _A else out[-1].many) if out and len(letter) == 1 and letter.isupper() else 0
        if 0 < many < there[letter] and _looks_so(tokens, n + 1) and not (out[1:] and out[-2].word in _TOLD):
            number = out.pop()
            told = [number.saying("one") if many == 1 else number, number.saying("of"), number.saying("the"), token]
            out += told if tokens[n + 1].word in lexicon.BLOCK else [*told, token.saying("blocks")]
            continue
        there[letter] = max(there[letter], many)
        out.append(token)
    return out


def _looks_so(tokens: list[Token], at: int) -> bool:
    """Whether what stands there tells the colour of the letter before it, or how it is turned."""
    at += at < len(tokens) and tokens[at].word in lexicon.BLOCK
    while at < len(tokens) and tokens[at].word in _IS:
        at += 1
    return at < len(tokens) and tokens[at].word in _SO
