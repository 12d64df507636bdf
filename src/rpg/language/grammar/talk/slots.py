"""Phrases told by their parts, as a grammar asks for them."""

from __future__ import annotations

from collections.abc import Iterable

from rpg.language.grammar.core import Parser
from rpg.language.phrases import Classes, Rows

_NONE = Classes()


class Patterns:
    """Phrases as rows of slots, which may speak of classes; see `Row` for how they are written."""

    def __init__(self, *patterns: str, classes: Classes = _NONE) -> None:
        self.rows = Rows(patterns, classes)

    @property
    def words(self) -> frozenset[str]:
        """The words of the phrases."""
        return self.rows.words

    @property
    def firsts(self) -> frozenset[str]:
        """The words that they begin with."""
        return self.rows.firsts

    def matches(self, p: Parser, i: int) -> Iterable[int]:
        """Positions after the patterns that stand at i, nearest first."""
        if not p.stands(i, self.rows.firsts):
            return []
        found = []
        step, j = self.rows.begin.after(p.words[i]), i + 1
        while step is not None:
            if step.whole:
                found.append(p.reach(j))
            step, j = (step.after(p.words[j]) if j < p.end else None), j + 1
        return found
