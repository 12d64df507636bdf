"""Two sides told by their names alone, "put the reds left and the blues right", or as one side and the other."""

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


_JOINTS = frozenset({",", "and", "while"})
_OF_THE_TABLE = ["of", "the", "table"]
_OTHER_THINGS = frozenset({".", ";", ":", "with", "between", "in", "of", "it", "them", "has", "have"})
"""What may come of these has sides of its own."""


def one_side_each(tokens: list[Token], words: list[str]) -> list[Token] | None:
    """ "The reds on one side, the blues on the other": both on opposite sides of the table, where no other thing is
    named that has sides."""
    at = next((n for n in range(1, len(words) - 3) if words[n : n + 3] == ["on", "one", "side"]), 0)
    begun = at + 3 + 3 * (words[at + 3 : at + 6] == _OF_THE_TABLE)
    other = next((n for n in range(begun, len(words) - 2) if words[n : n + 3] == ["on", "the", "other"]), 0)
    end = other + 3 + (words[other + 3 : other + 4] == ["side"])
    end += 3 * (words[end : end + 3] == _OF_THE_TABLE)
    first = begun
    while first < other and words[first] in _JOINTS:
        first += 1
    if not at or not begun < first < other or (end < len(words) and words[end] not in (".", "!", ";")):
        return None
    if not _JOINTS.isdisjoint({*words[first:other], *words[:at]}) or words[at - 1] in ("is", "are", "be", "go", "goes"):
        return None
    told = words[at + 3 : at + 6] == _OF_THE_TABLE or words[end - 3 : end] == _OF_THE_TABLE
    if not told and not _OTHER_THINGS.isdisjoint(words[:other]):
        return None
    both = [tokens[at].saying(word) for word in ("on", "opposite", "sides", "of", "the", "table")]
    return [*tokens[:at], tokens[at].saying("and"), *tokens[first:other], *both, *tokens[end:]]
