"""Phrases word by word: which of many stand at a place is seen in one walk over the words there."""

from __future__ import annotations

from collections.abc import Collection
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
    tree: dict[str | None, Any] = {}
    for rank, phrase in enumerate(phrases):
        branch = tree
        for word in phrase.split():
            branch = branch.setdefault(word, {})
        branch.setdefault(None, (rank, phrase))
    if len(TREES) >= MOST_TREES:
        TREES.clear()
        _KEPT.clear()
    _KEPT.append(phrases)
    TREES[id(phrases)] = tree
    return tree


MOST_TREES = 4096
TREES: dict[int, dict[str | None, Any]] = {}
_KEPT: list[Collection[str]] = []
"""The phrases of these trees, so that nothing else comes to be where they are."""


@lru_cache(maxsize=4096)
def words_of(phrase: str) -> tuple[str, ...]:
    """The words of a phrase."""
    return tuple(phrase.split())
