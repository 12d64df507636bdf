"""What a text must have in its words where a pattern fits: rows of patterns are found by it."""

from __future__ import annotations

import re
from collections.abc import Iterable
from functools import lru_cache

_Needs = list[frozenset[str]]
_DEEPEST = 16
"""Brackets are at most so deep inside of others."""


def _bracket() -> str:
    """A pattern of a whole bracket, with all those in it."""
    found = plain = r"[^()\\[]++|\\.|\[\^?[^]]+\]"
    for _ in range(_DEEPEST):
        found = rf"\((?:{plain}|{found})*+\)"
    return found


_PIECES = re.compile(
    rf"{_bracket()}(?:[?*]\??|\{{0[\d,]*\}}\??)?|[a-z ]+(?![?*+{{])|\\.|\[\^?[^]]+\]|[?*+]\??|\{{[\d,]+\}}\??|."
)
"""Brackets, letters, what stands for one character, and how often something is said."""
_PLAIN = re.compile(r"\((?:\?:|\?P<\w+>)?([a-z ]+(?:\|[a-z ]+)+)\)")
"""Words of which one is said."""
_BEGUN = re.compile(r"\((?:\?:|\?P<\w+>|(?!\?))")
"""Where a bracket begins whose parts are in the text; others look ahead or behind, or are the same again."""


def needed(pattern: str) -> _Needs:
    """Where a pattern fits, a text has one of each of these sets inside of a word; those that are rarest come first."""
    return sorted(_needed(pattern), key=_rare, reverse=True)


def _rare(parts: frozenset[str]) -> int:
    return min(map(len, parts))


def _most(needs: _Needs) -> frozenset[str]:
    """What is needed most."""
    return max(needs, key=_rare) if len(needs) > 1 else needs[0]


def _needed(pattern: str) -> _Needs:
    """The same in the order of the pattern; of several ways to say something, one of what each of them needs most."""
    run: list[str | _Needs] = []
    ways = [run]
    for piece in _PIECES.findall(pattern):
        if piece == "|":
            run = []
            ways.append(run)
        elif piece == "(":
            raise ValueError(f"brackets are too deep inside of others: {pattern}")
        elif piece[0] == "(":
            run.append(_of_bracket(piece) if piece[-1] == ")" else [])
        elif piece[0] in "?*{" and (piece[0] != "{" or piece[1] == "0"):
            run[-1] = []
        else:
            escaped = piece[0] == "\\" and not piece[1].isalnum()
            run.append(piece[-1] if escaped else piece if piece[0] not in "\\[^$.+{" else [])
    if len(ways) == 1:
        return _of_run(run)
    needs = [_of_run(way) for way in ways]
    return [frozenset[str]().union(*(_most(way) for way in needs))] if all(needs) else []


@lru_cache(maxsize=4096)
def _of_bracket(bracket: str) -> _Needs:
    """What is needed of a bracket; patterns are made of the same parts, so that most of them are known already."""
    plain = _PLAIN.fullmatch(bracket)
    if plain is not None:
        phrases = [phrase.split() for phrase in plain[1].split("|")]
        return [frozenset([max(words, key=len) for words in phrases])] if all(phrases) else []
    begun = _BEGUN.match(bracket)
    return _needed(bracket[begun.end() : -1]) if begun is not None else []


def _of_run(run: Iterable[str | _Needs]) -> _Needs:
    """What is needed of words, and of what brackets among them need."""
    found: _Needs = []
    words = ""
    for piece in (*run, []):
        if isinstance(piece, str):
            words += piece
            continue
        found += [frozenset({word}) for word in words.split()]
        found += piece
        words = ""
    return found
