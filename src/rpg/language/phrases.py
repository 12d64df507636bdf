"""Phrases word by word: which of many stand at a place is seen in one walk over the words there."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from functools import cached_property, lru_cache
from typing import Any, NamedTuple

Beginnings = dict[str, list[tuple[str, ...]]]


@lru_cache(maxsize=1024)
def by_first(phrases: tuple[str, ...]) -> Beginnings:
    """Phrases as words, by their first word."""
    table: Beginnings = {}
    for phrase in phrases:
        words = tuple(phrase.split())
        table.setdefault(words[0], []).append(words)
    return table


def length_at(words: Sequence[str], at: int, phrases: Iterable[tuple[str, ...]]) -> int:
    """How many words the longest of some phrases has that stands at a place; 0 where none does."""
    return max((len(x) for x in phrases if tuple(words[at : at + len(x)]) == x), default=0)


def behind(words: Sequence[str], at: int, phrases: Iterable[tuple[str, ...]]) -> int:
    """The position behind the longest of some phrases that stands at a place; 0 where none does."""
    long = length_at(words, at, phrases)
    return at + long if long else 0


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


class Slot:
    """Phrases, with "_" inside, and <classes>, with "|" between them; "?" behind a slot that may be left out, "*"
    behind one that may also be said several times. What is not asked for is not made: there are thousands of slots."""

    def __init__(self, text: str) -> None:
        names = text.rstrip("?*").split("|")
        self.phrases = [name.replace("_", " ") for name in names if not name.startswith("<")]
        self.called = [name[1:-1] for name in names if name.startswith("<")]
        self.kind = text[-1] if text[-1] in "?*" else ""

    @cached_property
    def tree(self) -> dict[str | None, Any]:
        """Its phrases word by word."""
        return _grown(self.phrases)

    @cached_property
    def words(self) -> frozenset[str]:
        """The words of its phrases."""
        return frozenset(" ".join(self.phrases).split())

    @cached_property
    def firsts(self) -> frozenset[str]:
        """The words that its phrases begin with."""
        return frozenset(phrase.split(" ", 1)[0] for phrase in self.phrases)


_slot = lru_cache(maxsize=4096)(Slot)
"""Slots that are written alike are the same."""


class Row:
    """A row of slots, as it is written: slots between spaces."""

    def __init__(self, text: str, classes: Classes) -> None:
        self.classes = classes
        self.slots = [_slot(part) for part in text.split(" ")]
        self.least = max((n + 1 for n, slot in enumerate(self.slots) if not slot.kind), default=1)
        """As many slots are gone through before the row may be over."""

    @cached_property
    def firsts(self) -> frozenset[str]:
        """The words that it begins with."""
        firsts: set[str] = set()
        for slot in self.slots:
            firsts |= slot.firsts
            firsts.update(*map(self.classes.firsts, slot.called))
            if not slot.kind:
                break
        return frozenset(firsts)

    def words(self) -> frozenset[str]:
        """The words of its phrases."""
        return frozenset[str]().union(*(slot.words for slot in self.slots))


class Classes:
    """Named lists of rows, which may speak of one another, but not begin with one another."""

    def __init__(self, classes: Mapping[str, Iterable[str]] | None = None) -> None:
        self.rows = {name: [Row(row, self) for row in rows] for name, rows in (classes or {}).items()}
        self.begun: dict[str, frozenset[str]] = {}

    @cached_property
    def words(self) -> frozenset[str]:
        """The words of all of them."""
        return frozenset[str]().union(*(row.words() for rows in self.rows.values() for row in rows))

    def firsts(self, name: str) -> frozenset[str]:
        """The words that a class begins with."""
        if name not in self.begun:
            self.begun[name] = frozenset[str]().union(*(row.firsts for row in self.rows[name]))
        return self.begun[name]


class Place(NamedTuple):
    """A place in a row: before a slot, or behind words of a phrase in it; and the slot whose class the row is of."""

    row: Row
    slot: int
    said: tuple[str, ...]
    back: Place | None

    def after(self, word: str) -> Iterator[Place]:
        """Where a word leads."""
        slots = self.row.slots
        if self.said:
            branch = slots[self.slot].tree
            for said in self.said:
                branch = branch[said]
            if word in branch:
                yield from self._said(self.slot, (*self.said, word), branch[word])
            return
        classes = self.row.classes
        for slot in range(self.slot, len(slots)):
            if word in slots[slot].firsts:
                yield from self._said(slot, (word,), slots[slot].tree[word])
            for row in (
                row for name in slots[slot].called if word in classes.firsts(name) for row in classes.rows[name]
            ):
                if word in row.firsts:
                    yield from Place(row, 0, (), Place(self.row, slot, (), self.back)).after(word)
            if not slots[slot].kind:
                break

    def _said(self, slot: int, said: tuple[str, ...], branch: dict[str | None, Any]) -> Iterator[Place]:
        """Behind words of a phrase, and where it ends behind the slot."""
        if None not in branch or len(branch) > 1:
            yield Place(self.row, slot, said, self.back)
        if None in branch:
            yield from Place(self.row, slot, (), self.back)._full()

    def _full(self) -> Iterator[Place]:
        """Behind a slot in which all is said, and behind the rows that end with it."""
        row, slot, _, back = self
        if row.slots[slot].kind == "*":
            yield self
        elif slot + 1 < len(row.slots):
            yield Place(row, slot + 1, (), back)
        if slot + 1 >= row.least:
            yield from back._full() if back is not None else (Place(row, len(row.slots), (), None),)


class Rows:
    """Rows of slots, all of them walked at once: a word leads from where a sentence may be to where it may be then."""

    def __init__(self, rows: Iterable[str], classes: Classes) -> None:
        self.rows = [Row(row, classes) for row in rows]
        self.classes = classes
        self.steps: dict[frozenset[Place], Step] = {}
        self.begin = Step(self, frozenset(Place(row, 0, (), None) for row in self.rows))

    @cached_property
    def words(self) -> frozenset[str]:
        """All the words of them and of the classes that they may speak of."""
        return self.classes.words.union(*(row.words() for row in self.rows))

    @cached_property
    def firsts(self) -> frozenset[str]:
        """The words that they begin with."""
        return frozenset[str]().union(*(row.firsts for row in self.rows))

    def whole(self, words: Sequence[str]) -> bool:
        """Whether all of the words, and no more, are one of these rows."""
        step, n = self.begin.after(words[0]), 1
        while step is not None and n < len(words):
            step, n = step.after(words[n]), n + 1
        return step is not None and step.whole


class Step:
    """Where a sentence may be in rows, and whether one of them is complete there."""

    def __init__(self, rows: Rows, places: frozenset[Place]) -> None:
        self.rows = rows
        self.places = places
        self.whole = any(place.slot == len(place.row.slots) for place in places)
        self.next: dict[str, Step | None] = {}

    def after(self, word: str) -> Step | None:
        """The step behind a word, if any row goes on with it; each is made once."""
        if word in self.next or word not in self.rows.words:
            return self.next.get(word)
        places = frozenset(new for place in self.places for new in place.after(word))
        steps = self.rows.steps
        if places and places not in steps:
            steps[places] = Step(self.rows, places)
        self.next[word] = steps.get(places)
        return self.next[word]
