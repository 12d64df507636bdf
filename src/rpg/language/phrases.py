"""Phrases word by word: which of many stand at a place is seen in one walk over the words there."""

from __future__ import annotations

from collections.abc import Collection, Iterator
from functools import lru_cache
from typing import Any

Beginnings = dict[str, list[tuple[str, ...]]]


@lru_cache(maxsize=1024)
def by_first(phrases: tuple[str, ...]) -> Beginnings:
    """Phrases as words, by their first word."""
    table: Beginnings = {}
    for phrase in phrases:
        words = tuple(phrase.split())
        table.setdefault(words[0], []).append(words)
    return table


def tree_of(phrases: Collection[str]) -> dict[str | None, Any]:
    """Phrases word by word: what may follow each word, and under None the rank and the phrase that ends there.

    Phrases are known by where they are kept: to compare them all would take longer than to look for them. So a rule
    names them in one place, and does not put them together anew for every sentence.
    """
    found = TREES.get(id(phrases))
    if found is not None:
        return found
    if len(TREES) >= MOST_TREES:
        TREES.clear()
        _KEPT.clear()
    _KEPT.append(phrases)
    tree = TREES[id(phrases)] = _grown(phrases)
    return tree


def _grown(phrases: Collection[str]) -> dict[str | None, Any]:
    tree: dict[str | None, Any] = {}
    for rank, phrase in enumerate(phrases):
        branch = tree
        for word in phrase.split():
            branch = branch.setdefault(word, {})
        branch.setdefault(None, (rank, phrase))
    return tree


MOST_TREES = 4096
TREES: dict[int, dict[str | None, Any]] = {}
_KEPT: list[Collection[str]] = []
"""The phrases of these trees, so that nothing else comes to be where they are."""


@lru_cache(maxsize=4096)
def words_of(phrase: str) -> tuple[str, ...]:
    """The words of a phrase."""
    return tuple(phrase.split())


Place = tuple[int, int, tuple[str, ...]]
"""A row of slots, a slot of it, and the words said so far in that slot."""


class Rows:
    """Rows of slots, all of them walked at once: a word leads from where a sentence may be to where it may be then.

    A slot is what may stand there, and whether it may be empty.
    """

    def __init__(self, rows: list[list[tuple[tuple[str, ...], bool]]]) -> None:
        self.rows = [[(_grown(phrases), optional) for phrases, optional in row] for row in rows]
        self.steps: dict[frozenset[Place], Step] = {}
        self.begin = self.step({place for rank in range(len(rows)) for place in self._from(rank, 0)})

    def step(self, places: set[Place]) -> Step:
        """The step to these places; each is made once."""
        key = frozenset(places)
        if key not in self.steps:
            self.steps[key] = Step(self, key)
        return self.steps[key]

    def following(self, place: Place) -> dict[str | None, Any]:
        """What may follow at a place, word by word."""
        rank, slot, said = place
        tree = self.rows[rank][slot][0] if slot < len(self.rows[rank]) else {}
        for word in said:
            tree = tree[word]
        return tree

    def onward(self, place: Place, word: str) -> Iterator[Place]:
        """Where a word leads from a place."""
        rank, slot, said = place
        further = (rank, slot, (*said, word))
        yield further
        if None in self.following(further):
            yield from self._from(rank, slot + 1)

    def _from(self, rank: int, slot: int) -> Iterator[Place]:
        """The place where a slot of a row begins, and those behind it where it may be empty."""
        yield rank, slot, ()
        if slot < len(self.rows[rank]) and self.rows[rank][slot][1]:
            yield from self._from(rank, slot + 1)


class Step:
    """Where a sentence may be in rows. `ends`: the rows that are complete; `words`: those that lead on, from where."""

    def __init__(self, rows: Rows, places: frozenset[Place]) -> None:
        self.rows = rows
        self.ends = [rank for rank, slot, _ in places if slot == len(rows.rows[rank])]
        self.words: dict[str, list[Place]] = {}
        self.next: dict[str, Step] = {}
        for place in places:
            for word in rows.following(place):
                if word is not None:
                    self.words.setdefault(word, []).append(place)

    def after(self, word: str) -> Step | None:
        """The step behind a word, if any row goes on with it."""
        found = self.next.get(word)
        if found is None and word in self.words:
            onward = {new for place in self.words[word] for new in self.rows.onward(place, word)}
            found = self.next[word] = self.rows.step(onward)
        return found
