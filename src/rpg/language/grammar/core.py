"""The parser's bones: a token row, memoised rules that give every reading, and how far any of them came.

A rule is a generator of (meaning, next position). Positions that matched are never 0, so that helpers return the next
position or 0 for "no".
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import lru_cache, wraps
from itertools import chain, islice
from typing import Any, Concatenate, ParamSpec, TypeVar, cast

from rpg.core.diagnostics import Span
from rpg.language import lexicon
from rpg.language.meaning import cost_of
from rpg.language.outlook import END, Hidden, Leaf, Outlook, View, free_of_places, key_of, leaf_of
from rpg.language.tokens import Token

M = TypeVar("M")
A = ParamSpec("A")
Results = Iterator[tuple[M, int]]

MAX_READINGS = 48
"""Readings kept per rule and place; more than this only arises from endless coordination."""
MAX_WEIGHED = 400
"""Readings among which the cheapest are kept."""
MAX_WORK = 60_000
"""Rule applications per sentence."""
MAX_STEPS = 100_000
"""Words taken per sentence, over all readings: twenty times what the longest natural sentences need."""


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


@lru_cache(maxsize=1024)
def tree_of(phrases: tuple[str, ...]) -> dict[str | None, Any]:
    """Phrases word by word: what may follow each word, and under None the rank and the phrase that ends there."""
    tree: dict[str | None, Any] = {}
    for rank, phrase in enumerate(phrases):
        branch = tree
        for word in phrase.split():
            branch = branch.setdefault(word, {})
        branch.setdefault(None, (rank, phrase))
    return tree


class Parser:
    """The tokens of one sentence with the memory of the rules applied to them."""

    def __init__(self, tokens: list[Token]) -> None:
        self.tokens = tokens
        self.words = [t.word if t.kind in ("word", "punct", "sign", "number") else "" for t in tokens] + ["", "", ""]
        self.keys: Sequence[str | None] = [*map(key_of, tokens), *[END] * len(tokens), END, END, END]
        self.end = len(tokens)
        self.memo: dict[tuple[Any, ...], list[tuple[Any, int]]] = {}
        self.far = 0
        self.work = 0
        self.steps = 0

    def span(self, i: int, j: int) -> Span:
        """Characters of tokens i..j-1."""
        if not self.tokens:
            return (0, 0)
        last = self.tokens[max(i, j - 1)] if i < len(self.tokens) else self.tokens[-1]
        return (self.tokens[min(i, len(self.tokens) - 1)].span[0], last.span[1])

    def char(self, index: int, side: int) -> int:
        """The character where a token begins (side 0) or ends (side 1)."""
        return self.tokens[index].span[side]

    def reach(self, j: int) -> int:
        """Note that the words before `j` were understood."""
        self.steps += 1
        if self.steps > MAX_STEPS:
            raise TooMuchWork
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

    def standing(self, i: int, phrases: Collection[str]) -> list[tuple[str, int]]:
        """Those of `phrases` that stand here, in their order, each with the position after it."""
        branch = tree_of(tuple(phrases)).get(self.words[i]) if i < self.end else None
        if branch is None:
            return []
        return [(phrase, j) for (_, phrase), j in sorted(self._met(i, branch))]

    def any_of(self, i: int, phrases: tuple[str, ...]) -> int:
        """The position after the longest of `phrases` that stands here, or 0."""
        branch = tree_of(phrases).get(self.words[i]) if i < self.end else None
        if branch is None:
            return 0
        found = self._met(i, branch)
        return found[-1][1] if found else 0

    def _met(self, i: int, branch: dict[str | None, Any] | None) -> list[tuple[tuple[int, str], int]]:
        """The phrases below a branch that stand here, with their ranks and the positions after them, shortest first."""
        found: list[tuple[tuple[int, str], int]] = []
        j = i
        while branch is not None:
            j += 1
            if None in branch:
                found.append((branch[None], j))
                if len(branch) == 1:
                    break
            branch = branch.get(self.words[j])
        self.reach(j)
        return found

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


class Glimpse(Parser):
    """A parser on a view."""

    def __init__(self, view: View) -> None:
        self.tokens, self.words, self.keys, self.end = cast(Any, (view.tokens, view.words, view.keys, view.end))
        self.view = view
        self.memo = {}
        self.far = view.base
        self.work = 0
        self.steps = 0

    def span(self, i: int, j: int) -> Span:
        """Codes for the place of tokens i..j-1."""
        if not self.view.key(i):
            raise Hidden(self.view)
        return (self.char(i, 0), self.char(max(i, j - 1), 1))

    def char(self, index: int, side: int) -> int:
        """The code for where a token begins (side 0) or ends (side 1)."""
        return self.view.char(index, side)


@dataclass(frozen=True)
class Attempt:
    """Tries a rule on a view."""

    name: str
    body: Callable[..., Results[Any]]

    def __call__(self, view: View, args: tuple[Any, ...]) -> Leaf:
        p = Glimpse(view)
        p.memo[(self.name, view.base, args)] = []
        found = _distinct(self.body(p, view.base, *args))
        return leaf_of(found, view.base, max([p.far, *[j for _, j in found]]))


def rule(
    body: Callable[Concatenate[Parser, int, A], Results[M]],
) -> Callable[Concatenate[Parser, int, A], list[tuple[M, int]]]:
    """Memoise a rule: its distinct readings at a place, in order of preference, bounded in number.

    Its outlook spares it what it has seen in other sentences.
    """
    name = f"{body.__module__}.{body.__qualname__}"
    outlook = Outlook(Attempt(name, body)) if free_of_places(body) else None

    @wraps(body)
    def apply(p: Parser, i: int, *args: A.args, **kwargs: A.kwargs) -> list[tuple[M, int]]:
        assert not kwargs
        key = (name, i, args)
        found = p.memo.get(key)
        if found is None:
            leaf = outlook.recall(p.keys, i, args) if outlook is not None else None
            if leaf is not None:
                p.reach(i + leaf.far)
                found = p.memo[key] = leaf.at(i, p.char) if leaf.readings else []
                return found
            p.memo[key] = []
            p.work += 1
            if p.work > MAX_WORK:
                raise TooMuchWork
            found = p.memo[key] = _distinct(body(p, i, *args, **kwargs))
            for _, j in found:
                p.reach(j)
        return found

    return cast(Callable[Concatenate[Parser, int, A], list[tuple[M, int]]], apply)


def _distinct(readings: Results[M]) -> list[tuple[M, int]]:
    """The readings that differ: the first ones, or of many the cheapest."""
    first = list(islice(readings, 2))
    if len(first) < 2:
        return first
    seen: dict[tuple[Any, int], None] = {}
    for reading in chain(first, readings):
        seen.setdefault(reading)
        if len(seen) >= MAX_WEIGHED:
            break
    if len(seen) <= MAX_READINGS:
        return list(seen)
    found = list(seen)
    costs = [cost_of(meaning) for meaning, _ in found]
    kept = sorted(range(len(found)), key=costs.__getitem__)[:MAX_READINGS]
    return [found[n] for n in sorted(kept)]
