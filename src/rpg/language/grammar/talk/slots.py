"""Phrases told by classes of words, as rows of slots.

A slot lists phrases and, in angle brackets, classes, with "_" inside a phrase; "?" stands behind what may be left out,
"*" behind what may be said several times. A class is a list of such rows.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from typing import Any

from rpg.language.grammar.core import Parser
from rpg.language.grammar.talk.frames import Phrases
from rpg.language.phrases import tree_of

Row = tuple[tuple[dict[str | None, Any], tuple[str, ...], str], ...]
"""Slots: phrases word by word, classes, and "?", "*" or nothing."""


class Classes:
    """Named lists of rows, which may speak of one another."""

    def __init__(self, classes: Mapping[str, Iterable[str]]) -> None:
        self.rows = {name: tuple(map(_row, rows)) for name, rows in classes.items()}
        self.words = frozenset(word for rows in classes.values() for word in _words(rows))
        self.firsts: dict[str, frozenset[str]] = {}

    def begin(self, name: str) -> frozenset[str]:
        """The words that a class begins with."""
        if name not in self.firsts:
            self.firsts[name] = frozenset[str]().union(*map(self.first_of, self.rows[name]))
        return self.firsts[name]

    def first_of(self, row: Row) -> frozenset[str]:
        """The words that a row begins with."""
        firsts: set[str] = set()
        for tree, names, kind in row:
            firsts |= {word for word in tree if word is not None}
            for name in names:
                firsts |= self.begin(name)
            if not kind:
                break
        return frozenset(firsts)

    def after(self, p: Parser, i: int, row: Row) -> set[int]:
        """The positions after a row."""
        ends = {i}
        for tree, names, kind in row:
            after: set[int] = set()
            at = ends
            while at:
                at = self._slot(p, at, tree, names) - after
                after |= at
                at = at if kind == "*" else set()
            ends = after | ends if kind else after
            if not ends:
                break
        return ends

    def _slot(self, p: Parser, ends: set[int], tree: dict[str | None, Any], names: tuple[str, ...]) -> set[int]:
        found: set[int] = set()
        for at in ends:
            branch: dict[str | None, Any] | None = tree
            j = at
            while j < p.end and branch is not None and (branch := branch.get(p.words[j])) is not None:
                j += 1
                if None in branch:
                    found.add(j)
            for name in names:
                found |= self.ends(p, at, name)
        return found

    def ends(self, p: Parser, i: int, name: str) -> set[int]:
        """The positions after a class."""
        if i >= p.end or p.words[i] not in self.begin(name):
            return set()
        return {j for row in self.rows[name] for j in self.after(p, i, row)} - {i}


class Rows(Phrases):
    """Phrases that rows of classes describe."""

    def __init__(self, classes: Classes, *rows: str) -> None:
        super().__init__()
        self.classes = classes
        self.begun: dict[str, list[Row]] = {}
        for row in map(_row, rows):
            for word in classes.first_of(row):
                self.begun.setdefault(word, []).append(row)
        self.words = classes.words | _words(rows)

    def matches(self, p: Parser, i: int) -> Iterator[int]:
        """Positions after the phrases that stand at i."""
        rows = p.peek(i, self.begun)
        for j in sorted({j for row in rows for j in self.classes.after(p, i, row)} - {i}) if rows else ():
            yield p.reach(j)


def _row(text: str) -> Row:
    slots = []
    for part in text.split(" "):
        names = part.rstrip("?*").split("|")
        phrases = tuple(name.replace("_", " ") for name in names if not name.startswith("<"))
        classes = tuple(name[1:-1] for name in names if name.startswith("<"))
        slots.append((tree_of(phrases), classes, part[-1] if part[-1] in "?*" else ""))
    return tuple(slots)


def _words(rows: Iterable[str]) -> frozenset[str]:
    names = (name for row in rows for part in row.split(" ") for name in part.rstrip("?*").split("|"))
    return frozenset(word for name in names if not name.startswith("<") for word in name.split("_"))
