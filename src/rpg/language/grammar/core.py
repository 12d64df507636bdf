"""The parser's bones: a token row, memoised rules that give every reading, and how far any of them came.

A rule is a generator of (meaning, next position). Positions that matched are never 0, so that helpers return the next
position or 0 for "no". A rule looks for its first word by these helpers and before all else, so that it can be asked
with which words it begins (`outlook`): it is not run before others.
"""

from __future__ import annotations

import sys
from collections.abc import Callable, Collection, Iterable, Iterator, Mapping, Sequence
from functools import wraps
from itertools import islice
from typing import Any, Concatenate, ParamSpec, TypeVar, cast

from rpg.core.diagnostics import Span
from rpg.language import lexicon
from rpg.language.meaning import cost_of
from rpg.language.outlook import END, Asked, Edge, Firsts, Heads, Hidden, Tokens, Words, free_of_places, head_of
from rpg.language.phrases import TREES, tree_of, words_of
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


class Parser:
    """The tokens of one sentence with the memory of the rules applied to them.

    `thorough`: nothing is spared, so that `far` is as far as any rule comes.
    """

    def __init__(self, tokens: list[Token], thorough: bool = False) -> None:
        self.thorough = thorough
        self.tokens = tokens
        self.words = [t.word if t.kind in ("word", "punct", "sign", "number") else "" for t in tokens] + ["", "", ""]
        self.heads: Sequence[str | None] = [*map(head_of, tokens), *[END] * len(tokens), END, END, END]
        self.end = len(tokens)
        self.all = frozenset(self.words)
        self.memo: dict[tuple[Any, ...], list[tuple[Any, int]]] = {}
        self.lasts: dict[Callable[..., Any], int] = {}
        self.far = 0
        self.work = 0
        self.steps = 0

    def span(self, i: int, j: int) -> Span:
        """Characters of tokens i..j-1."""
        if i < j:
            return (self.tokens[i].span[0], self.tokens[j - 1].span[1])
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

    def one(self, i: int, words: Collection[str]) -> int:
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
        for word in words_of(phrase):
            if i >= self.end or self.words[i] != word:
                return 0
            i += 1
            self.reach(i)
        return i

    def standing(self, i: int, phrases: Collection[str]) -> list[tuple[str, int]]:
        """Those of `phrases` that stand here, in their order, each with the position after it."""
        branch = tree_of(phrases).get(self.words[i]) if i < self.end else None
        if branch is None:
            return []
        return [(phrase, j) for (_, phrase), j in sorted(self._met(i, branch))]

    def any_of(self, i: int, phrases: tuple[str, ...]) -> int:
        """The position after the longest of `phrases` that stands here, or 0."""
        if i >= self.end:
            return 0
        tree = TREES.get(id(phrases))  # as in tree_of, without a call: nothing is asked as often
        branch = (tree_of(phrases) if tree is None else tree).get(self.words[i])
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

    def peek(self, i: int, category: Mapping[str, M]) -> M | None:
        """What the word at i means in a table, before it is known whether it is taken for that."""
        return category.get(self.words[i]) if i < self.end else None

    def stands(self, i: int, words: Collection[str]) -> bool:
        """Whether the word at i is among `words`, before it is known whether it is taken for one."""
        return i < self.end and self.words[i] in words

    def follows(self, i: int, words: Collection[str]) -> bool:
        """Whether the word before i is among `words`."""
        return i > 0 and self.words[i - 1] in words

    def anywhere(self, words: frozenset[str]) -> bool:
        """Whether the sentence has one of `words`, without which it is not worth while to look further."""
        return self.thorough or not self.all.isdisjoint(words)

    rarely = anywhere
    """The same of rare words: a sentence without them is spared whatever asks for them."""

    def last(self, body: Callable[[Parser, int], Iterable[object]]) -> int:
        """The last place where a rule finds something: none before it is sought behind it."""
        if self.thorough:
            return self.end
        if body not in self.lasts:
            self.lasts[body] = next((i for i in range(self.end - 1, -1, -1) if any(True for _ in body(self, i))), -1)
        return self.lasts[body]

    def told(self, i: int, firsts: Firsts) -> list[tuple[Any, int]] | None:
        """The readings at a place where no word tells what a rule makes of it: it is to be run."""
        return None

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


class Inquiry(Parser):
    """A parser that stands in for every sentence, and notes what a rule asks for where it begins."""

    def __init__(self, asked: Asked) -> None:
        self.asked = asked
        self.tokens, self.words, self.end = cast(Any, (Tokens(asked), Words(asked), Edge(asked)))
        self.heads = cast(Any, Heads())
        self.memo = {}
        self.far = self.work = self.steps = 0

    def span(self, i: int, j: int) -> Span:
        raise Hidden

    def char(self, index: int, side: int) -> int:
        raise Hidden

    def one(self, i: int, words: Collection[str]) -> int:
        self.asked.note(i, (words,) if isinstance(words, str) else words)
        return 0

    def opt(self, i: int, *words: str) -> int:
        self.asked.note(i, words)
        return i

    def seq(self, i: int, phrase: str) -> int:
        self.asked.note(i, words_of(phrase)[:1])
        return 0

    def standing(self, i: int, phrases: Collection[str]) -> list[tuple[str, int]]:
        self.asked.note(i, tree_of(phrases))
        return []

    def any_of(self, i: int, phrases: tuple[str, ...]) -> int:
        self.asked.note(i, tree_of(phrases))
        return 0

    def lex(self, i: int, category: Mapping[str, M]) -> M | None:
        self.asked.note(i, category)
        return None

    peek = lex

    def stands(self, i: int, words: Collection[str]) -> bool:
        self.asked.note(i, words)
        return False

    def follows(self, i: int, words: Collection[str]) -> bool:
        self.asked.here(i)
        self.asked.behind.update(words)
        return self.asked.answer()

    def anywhere(self, words: frozenset[str]) -> bool:
        return True

    def rarely(self, words: frozenset[str]) -> bool:
        self.asked.anywhere.update(words)
        return self.asked.answer()

    def last(self, body: Callable[[Parser, int], Iterable[object]]) -> int:
        return sys.maxsize

    def told(self, i: int, firsts: Firsts) -> list[tuple[Any, int]] | None:
        words, behind, anywhere, further, found = firsts
        self.asked.note(i, words)
        self.asked.behind |= behind
        self.asked.anywhere |= anywhere
        if self.asked.further is not None:
            self.asked.further = None if further is None else self.asked.further | further
        return [(meaning, i) for meaning in found]


class Beginning:
    """Spares a rule, or a choice of one, words with which it cannot begin. `firsts`: what it asks for, by arguments."""

    def __init__(self, body: Callable[..., Results[Any]]) -> None:
        self.body = body
        self.firsts: dict[tuple[Any, ...], Firsts | None] = {}
        self.met: set[tuple[Any, ...]] = set()
        BEGINNINGS.append(self)

    def meet(self, args: tuple[Any, ...]) -> None:
        """A rule is asked when it is met again: the rules that it tries have been met by then, and have told."""
        if args in self.met:
            self.firsts[args] = self._asked(args)
        else:
            self.met.add(args)

    def _asked(self, args: tuple[Any, ...]) -> Firsts | None:
        """What the rule asks of the word where it begins, at the start of a sentence and inside; None: too much."""
        asked = Asked()
        found = []
        for asked.kind in ("word", "punct", END):
            for asked.base in (0, 1000):
                found.append(self._tried(asked, args))
                while asked.others():
                    if self._tried(asked, args) != found[0]:
                        asked.further = None
        return asked.firsts(found[0]) if len(set(found)) == 1 and found[0] is not None else None

    def _tried(self, asked: Asked, args: tuple[Any, ...]) -> tuple[Any, ...] | None:
        """The readings of no length that the rule has there; None: it asks too much."""
        try:
            return tuple(meaning for meaning, _ in _distinct(self.body(Inquiry(asked), asked.base, *args)))
        except Hidden:
            return None


_NOTHING: list[Any] = []
BEGINNINGS: list[Beginning] = []
"""Those of all rules and choices."""


def rule(
    body: Callable[Concatenate[Parser, int, A], Results[M]],
) -> Callable[Concatenate[Parser, int, A], list[tuple[M, int]]]:
    """Memoise a rule: its distinct readings at a place, in order of preference, bounded in number."""
    name = f"{body.__module__}.{body.__qualname__}"
    return cast(Callable[Concatenate[Parser, int, A], list[tuple[M, int]]], _sparing(body, name))


def choice(
    body: Callable[Concatenate[Parser, int, A], Results[M]],
) -> Callable[Concatenate[Parser, int, A], Iterable[tuple[M, int]]]:
    """Make a part of a rule one that is not entered before words with which it cannot begin; it has no memory."""
    return cast(Callable[Concatenate[Parser, int, A], Iterable[tuple[M, int]]], _sparing(body, None))


def _sparing(body: Callable[..., Any], name: str | None) -> Callable[..., Any]:
    """A rule that is run where it may begin, and at a place once if it has a name. All is done in one function, which
    is called a thousand times for a sentence and most of the time in vain."""
    beginning = Beginning(body)
    firsts, free = beginning.firsts, free_of_places(body)

    @wraps(body)
    def apply(p: Parser, i: int, *args: Any) -> Any:
        known = firsts.get(args) if free else None
        if known is not None:
            words, behind, anywhere, further, found = known
            head = p.heads[i]
            if head is None:
                if (told := p.told(i, known)) is not None:
                    return told
            elif not (
                head in words
                or (behind and (further is None or head in further) and i > 0 and p.words[i - 1] in behind)
                or (anywhere and (further is None or head in further) and not p.all.isdisjoint(anywhere))
            ):
                if i > p.far:
                    p.far = i
                if not p.thorough:
                    return [(meaning, i) for meaning in found] if found else _NOTHING
        elif free and args not in firsts:
            beginning.meet(args)
        if name is None:
            return body(p, i, *args)
        key = (name, i, args)
        readings = p.memo.get(key)
        if readings is None:
            p.memo[key] = []
            p.work += 1
            if p.work > MAX_WORK:
                raise TooMuchWork
            readings = p.memo[key] = _distinct(body(p, i, *args))
            for _, j in readings:
                p.reach(j)
        return readings

    return apply


def _distinct(readings: Results[M]) -> list[tuple[M, int]]:
    """The readings that differ: the first ones, or of many the cheapest."""
    found = list(islice(readings, MAX_READINGS))
    if len(found) < 2 or len({j for _, j in found}) == len(found) < MAX_READINGS:
        return found
    seen = dict.fromkeys(found)
    if len(found) == MAX_READINGS:
        for reading in readings:
            seen.setdefault(reading)
            if len(seen) >= MAX_WEIGHED:
                break
    found = list(seen)
    if len(found) <= MAX_READINGS:
        return found
    costs = [cost_of(meaning) for meaning, _ in found]
    kept = sorted(range(len(found)), key=costs.__getitem__)[:MAX_READINGS]
    return [found[n] for n in sorted(kept)]
