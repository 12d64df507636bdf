"""The words of a text, and what was found to begin at each of them."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import wraps
from typing import Any, TypeVar

from rpg.language.compose.items import Item

T = TypeVar("T")
Ways = list[tuple[T, int]]
"""What is read from a word on, in all ways, each with where it ends."""


def remembered(rule: Callable[..., Ways[T]]) -> Callable[..., Ways[T]]:
    """A rule that is asked once only of what begins at a word."""

    @wraps(rule)
    def asked(self: Text, at: int) -> Ways[T]:
        key = (rule.__name__, at)
        if key not in self.known:
            self.known[key] = []  # what begins with itself has no reading
            self.known[key] = list(dict.fromkeys(rule(self, at)))
        return self.known[key]

    return asked


class Text:
    """The words of one text, and what was found to begin at each."""

    def __init__(self, items: Sequence[Item]) -> None:
        self.items = items
        self.known: dict[tuple[str, int], list[Any]] = {}

    def text(self, at: int) -> str:
        """The word there; nothing behind the last one."""
        return self.items[at].text if 0 <= at < len(self.items) else ""

    def number(self, at: int) -> int:
        """The number that a word is, else 0."""
        return self.items[at].number if 0 <= at < len(self.items) else 0

    def past(self, at: int, words: Sequence[str]) -> int:
        """Where these words end, if they begin here; else 0."""
        return at + len(words) if [i.text for i in self.items[at : at + len(words)]] == list(words) else 0

    def past_any(self, at: int, *ways: str) -> int:
        """Where the longest of these ends that begins here; else 0."""
        return max((self.past(at, way.split()) for way in ways), default=0)
