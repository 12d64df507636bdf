"""Sentences in the order of words of a specification, as rows that turn them into plain ones."""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from dataclasses import replace
from functools import cached_property, lru_cache

from rpg.language.grammar.rows.parting import STOPS
from rpg.language.tokens import Token

Turn = tuple[str, str]
"""What is looked for in a sentence, and what is said instead; "{1}" is the first group, "{1s}" several of it."""
_MOST = 4
"""No sentence is turned more often by the same row."""


class Turns:
    """Rows in their order, found by words that a text has where they fit."""

    def __init__(self, rows: Sequence[Turn]) -> None:
        self.rows = tuple(rows)

    @cached_property
    def _certain(self) -> list[str]:
        """What a text has where each of the rows fits."""
        return [_certain(row) for row, _ in self.rows]

    @cached_property
    def _by_word(self) -> dict[str, list[int]]:
        """The rows by the longest word of that; those of which no word is known to be whole under ""."""
        found: dict[str, list[int]] = {}
        for number, certain in enumerate(self._certain):
            word = max(re.findall(r"(?<= )\w+(?= )", certain), key=len, default="")
            found.setdefault(word, []).append(number)
        return found

    def fitting(self, told: Told, behind: int = -1) -> list[int]:
        """The rows behind a certain one that may fit somewhere in a text."""
        text = "\n".join([text for _, _, _, text in told])
        found = [number for word in {"", *text.split()} for number in self._by_word.get(word, ())]
        return sorted(number for number in found if number > behind and self._certain[number] in text)


def turned(tokens: list[Token], turns: Turns) -> list[Token]:
    """The tokens, every sentence of them turned by whichever rows fit it."""
    told = _told(tokens)
    waiting = turns.fitting(told)
    while waiting:
        number = waiting.pop(0)
        row, said = turns.rows[number]
        for _ in range(_MOST):
            changed = _once(tokens, told, _compiled(row), said)
            if changed is None:
                break
            tokens, told = changed, _told(changed)
            waiting = turns.fitting(told, number)
    return tokens


@lru_cache(maxsize=4096)
def _compiled(pattern: str) -> re.Pattern[str]:
    return re.compile(pattern)


def _certain(pattern: str) -> str:
    """A part of what is looked for without which it is nowhere: the longest that stands outside of brackets."""
    plain = pattern
    while (outside := re.sub(r"\((?:[^()\\]|\\.)*\)[?*+]?", "^", plain)) != plain:
        plain = outside
    if {*"|()"} & {*plain}:
        return ""
    return max(re.split(r"\\.|\[[^]]*\]|.[?*+]|.\{|[^a-z ]", plain), key=len)


Told = list[tuple[int, int, list[str], str]]
"""Where each sentence begins and ends, its words, and all of it."""


def _told(tokens: list[Token]) -> Told:
    words = [token.word.replace(" ", "_") or "_" for token in tokens]
    return [(begin, end, words[begin:end], " ".join(words[begin:end])) for begin, end in _sentences(tokens)]


def _once(tokens: list[Token], told: Told, pattern: re.Pattern[str], said: str) -> list[Token] | None:
    """The tokens with the first fitting sentence turned."""
    for begin, end, words, text in told:
        match = pattern.search(text)
        if match is None or not match.group():
            continue
        starts = _starts(words)
        first, last = _covered(starts, match.span())
        plain = list(_said(tokens[begin:end], match, said, starts))
        return [*tokens[: begin + first], *plain, *tokens[begin + last :]]
    return None


def _sentences(tokens: list[Token]) -> Iterable[tuple[int, int]]:
    begin = 0
    for n, token in enumerate(tokens):
        if token.kind == "punct" and token.word in STOPS:
            yield begin, n
            begin = n + 1
    yield begin, len(tokens)


def _starts(words: list[str]) -> list[int]:
    """Where in the text each word begins."""
    starts, at = [], 0
    for word in words:
        starts.append(at)
        at += len(word) + 1
    return starts


def _covered(starts: list[int], span: tuple[int, int]) -> tuple[int, int]:
    """The first word of a stretch of text, and the one behind it."""
    inside = [n for n, at in enumerate(starts) if span[0] <= at < span[1]]
    return (inside[0], inside[-1] + 1) if inside else (0, 0)


def _said(tokens: list[Token], match: re.Match[str], said: str, starts: list[int]) -> Iterable[Token]:
    first, last = _covered(starts, match.span())
    span = (tokens[first].span[0], tokens[last - 1].span[1])
    for word in said.split():
        if not word.startswith("{"):
            punct = not word.isalpha()
            yield Token("punct" if punct else "word", word, word, span)
            continue
        group = int(word.strip("{s}"))
        if match.group(group):
            begin, end = _covered(starts, match.span(group))
            kept = tokens[begin:end]
            if word.endswith("s}") and not kept[-1].word.endswith("s"):
                kept = [*kept[:-1], replace(kept[-1], word=kept[-1].word + "s", raw=kept[-1].raw + "s")]
            yield from kept
