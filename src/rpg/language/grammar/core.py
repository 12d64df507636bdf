"""The parser's bones: a token row, memoised rules that give every reading, and how far any of them came.

A rule is a generator of (meaning, next position). Positions that matched are never 0, so that helpers return the next
position or 0 for "no".
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator, Mapping
from functools import lru_cache, wraps
from typing import Any, Concatenate, ParamSpec, TypeVar, cast

from rpg.core.diagnostics import Span
from rpg.language import lexicon
from rpg.language.tokens import Token

M = TypeVar("M")
A = ParamSpec("A")
Results = Iterator[tuple[M, int]]

MAX_READINGS = 48
"""Readings kept per rule and place; more than this only arises from endless coordination."""
MAX_WORK = 60_000
"""Rule applications per sentence."""


class TooMuchWork(Exception):
    """The sentence is too tangled to parse within bounds."""


@lru_cache(maxsize=1024)
def by_first(phrases: tuple[str, ...]) -> dict[str, list[tuple[str, ...]]]:
    """Phrases as words, by their first word."""
    table: dict[str, list[tuple[str, ...]]] = {}
    for phrase in phrases:
        words = tuple(phrase.split())
        table.setdefault(words[0], []).append(words)
    return table


class Parser:
    """The tokens of one sentence with the memory of the rules applied to them."""

    def __init__(self, tokens: list[Token]) -> None:
        self.tokens = tokens
        self.words = [t.word if t.kind in ("word", "punct", "sign", "number") else "" for t in tokens] + ["", "", ""]
        self.end = len(tokens)
        self.memo: dict[tuple[Any, ...], list[tuple[Any, int]]] = {}
        self.far = 0
        self.work = 0

    def span(self, i: int, j: int) -> Span:
        """Characters of tokens i..j-1."""
        if not self.tokens:
            return (0, 0)
        last = self.tokens[max(i, j - 1)] if i < len(self.tokens) else self.tokens[-1]
        return (self.tokens[min(i, len(self.tokens) - 1)].span[0], last.span[1])

    def reach(self, j: int) -> int:
        """Note that the words before `j` were understood."""
        if j > self.far:
            self.far = j
        return j

    def one(self, i: int, words: frozenset[str] | set[str] | str) -> int:
        """i + 1 if the word there is `words` (or among them), else 0."""
        word = self.words[i] if i < self.end else ""
        if not word:
            return 0
        if (word == words) if isinstance(words, str) else (word in words):
            return self.reach(i + 1)
        return 0

    def opt(self, i: int, *words: str) -> int:
        """i + 1 if the word there is among `words`, else i."""
        return self.reach(i + 1) if i < self.end and self.words[i] in words else i

    def seq(self, i: int, phrase: str) -> int:
        """The position after `phrase`, or 0."""
        if i >= self.end or not phrase.startswith(self.words[i]):
            return 0
        for word in _split(phrase):
            if i >= self.end or self.words[i] != word:
                return 0
            i += 1
            self.reach(i)
        return i

    def standing(self, i: int, phrases: Collection[str]) -> Iterator[tuple[str, int]]:
        """Those of `phrases` that stand here, in their order, each with the position after it."""
        if i < self.end:
            for words in by_first(tuple(phrases)).get(self.words[i], ()):
                phrase = " ".join(words)
                if j := self.seq(i, phrase):
                    yield phrase, j

    def any_of(self, i: int, phrases: tuple[str, ...]) -> int:
        """The position after the longest of `phrases` that stands here, or 0."""
        if i >= self.end:
            return 0
        best = 0
        for words in by_first(phrases).get(self.words[i], ()):
            j = i
            for word in words:
                if self.words[j] != word or j >= self.end:
                    break
                j += 1
                self.reach(j)
            else:
                best = max(best, j)
        return best

    def lex(self, i: int, category: Mapping[str, M]) -> M | None:
        """What the word at i means in a table of the lexicon."""
        if i >= self.end:
            return None
        found = category.get(self.words[i])
        if found is not None:
            self.reach(i + 1)
        return found

    def token(self, i: int) -> Token | None:
        return self.tokens[i] if i < self.end else None

    def number(self, i: int) -> int | None:
        """A whole number in digits or words at i."""
        token = self.token(i)
        if token is None:
            return None
        if token.kind == "number" and isinstance(token.value, float) and token.value.is_integer():
            self.reach(i + 1)
            return int(token.value)
        return self.lex(i, lexicon.NUMBER) if token.kind == "word" else None

    def figure(self, i: int) -> float | None:
        """Any number at i."""
        token = self.token(i)
        if token is not None and token.kind == "number" and isinstance(token.value, float):
            self.reach(i + 1)
            return token.value
        whole = self.number(i)
        return None if whole is None else float(whole)


@lru_cache(maxsize=4096)
def _split(phrase: str) -> tuple[str, ...]:
    return tuple(phrase.split())


def rule(
    body: Callable[Concatenate[Parser, int, A], Results[M]],
) -> Callable[Concatenate[Parser, int, A], list[tuple[M, int]]]:
    """Memoise a rule: its distinct readings at a place, in order of preference, bounded in number."""
    name = f"{body.__module__}.{body.__qualname__}"

    @wraps(body)
    def apply(p: Parser, i: int, *args: A.args, **kwargs: A.kwargs) -> list[tuple[M, int]]:
        key = (name, i, args, tuple(kwargs.items()))
        found = p.memo.get(key)
        if found is None:
            p.memo[key] = []
            p.work += 1
            if p.work > MAX_WORK:
                raise TooMuchWork
            seen: dict[tuple[Any, int], None] = {}
            for reading in body(p, i, *args, **kwargs):
                seen.setdefault(reading)
                if len(seen) >= MAX_READINGS:
                    break
            found = p.memo[key] = list(seen)
            for _, j in found:
                p.reach(j)
        return found

    return cast(Callable[Concatenate[Parser, int, A], list[tuple[M, int]]], apply)
