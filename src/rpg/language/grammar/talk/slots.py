"""Phrases as a grammar asks for them: listed one by one, or told by their parts."""

from __future__ import annotations

from collections.abc import Iterable

from rpg.language.grammar.core import Parser
from rpg.language.phrases import Classes, Rows

_NONE = Classes()


class Phrases:
    """A set of phrases."""

    def __init__(self, *phrases: str) -> None:
        self.phrases = phrases
        self.words = frozenset(word for phrase in phrases for word in phrase.split())

    def matches(self, p: Parser, i: int) -> Iterable[int]:
        """Positions after the phrases that stand at i."""
        return [j for _, j in p.standing(i, self.phrases)]


class Patterns(Phrases):
    """Phrases by their parts: rows of slots, which may speak of classes."""

    def __init__(self, *patterns: str, classes: Classes = _NONE) -> None:
        super().__init__()
        rows = Rows(patterns, classes)
        self.begin, self.firsts, self.words = rows.begin, rows.firsts, rows.words

    def matches(self, p: Parser, i: int) -> Iterable[int]:
        """Positions after the patterns that stand at i, nearest first."""
        if not p.stands(i, self.firsts):
            return []
        found = []
        step, j = self.begin.after(p.words[i]), i + 1
        while step is not None:
            if step.whole:
                found.append(p.reach(j))
            step, j = (step.after(p.words[j]) if j < p.end else None), j + 1
        return found
