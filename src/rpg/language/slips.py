"""Which words of the language a word that means nothing here could be typed for, and which ones are mixed up."""

from __future__ import annotations

from functools import lru_cache
from itertools import groupby

from rpg.language.common_words import COMMON_WORDS
from rpg.language.spelling import LONG_WORD, NEAR_KEYS, NO_SLIPS, distance, nearest, slip, vocabulary

_MOST = 4
"""So many words at most are told that a word could be typed for."""
_RARE = 2
"""What a word that is seldom said of blocks is less likely meant, against one that often is."""
_WILD = 3
"""A slip that is made with no finger and by no ear."""
_GLUED = frozenset({"a", "the", "of", "on", "in", "to", "at", "by", "is", "it", "and", "from", "with", "next", "put",
                    "block", "cube", "row", "tower", "all", "red", "blue", "green"})  # fmt: skip
"""Words between which a space is left out."""
_VOWELS = frozenset("aeiouy")
MIXED_UP = {
    "too": "to", "then": "than", "than": "then", "form": "from", "from": "form", "there": "their", "their": "there",
    "an": "and", "were": "where", "read": "red", "tree": "three",
}  # fmt: skip
"""Words that are typed for others, each of them a word by itself."""


@lru_cache(maxsize=1024)
def slips_of(word: str) -> tuple[str, ...]:
    """The words that it is a slip for; none where it is an ordinary word that means something else, or some of what is
    known."""
    if not _may_be_one(word):
        return ()
    near = nearest(word, 1 if len(word) < LONG_WORD else 2)
    return tuple(known for known in near if len(known) > 2 and slip(word, known))


def _may_be_one(word: str) -> bool:
    several = len(word) > 3 and word.endswith("s") and word[:-1] in vocabulary()
    return word not in NO_SLIPS and word not in vocabulary() and not several


@lru_cache(maxsize=1024)
def meant_by(word: str) -> tuple[tuple[int, str], ...]:
    """The words that a word that means nothing could be typed for, each with how unlikely it is: by the slip that it
    takes, and by whether it is often said of blocks."""
    if word not in vocabulary() and word in MIXED_UP:
        return ((0, MIXED_UP[word]),)
    if not _may_be_one(word):
        return ()
    near = nearest(word, 1 if len(word) < LONG_WORD else 2)
    usual = [known for known in near if known in COMMON_WORDS]
    seldom = [known for known in near if known not in COMMON_WORDS and known not in NO_SLIPS and len(known) > 2]
    apart = [(1, f"{word[:n]} {word[n:]}") for n in range(1, len(word)) if {word[:n], word[n:]} <= _GLUED]
    found = [(_unlikely(word, known), known) for known in (*usual, *seldom)]
    likely = [*apart, *((cost + _RARE * (known in seldom), known) for cost, known in found if cost < _WILD)]
    return tuple(sorted(likely, key=lambda x: (x[0], COMMON_WORDS.get(x[1], len(COMMON_WORDS))))[:_MOST])


def _unlikely(word: str, known: str) -> int:
    """How unlikely it is to type `word` for `known`: letters that change places or are doubled come first, then one
    that is left out, that stands beside the right one or sounds like it; the first one is seldom wrong."""
    first = 0 if word[0] == known[0] or word[:2] == known[1::-1] else 1 if len(word) >= LONG_WORD - 2 else _WILD
    if sorted(word) == sorted(known) or _undoubled(word) == _undoubled(known):
        return first
    if distance(word, known, 1) > 1 or len(word) < len(known):
        return first + 1
    if len(word) > len(known):
        return first + 1 + (len(word) < LONG_WORD - 2)
    wrong, right = next((a, b) for a, b in zip(word, known, strict=True) if a != b)
    likely = right in NEAR_KEYS.get(wrong, "") or {wrong, right} <= _VOWELS
    return first + (1 if likely else _WILD if len(word) < LONG_WORD else 2)


def _undoubled(word: str) -> str:
    return "".join(letter for letter, _ in groupby(word))
