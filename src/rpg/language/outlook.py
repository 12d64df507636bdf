"""What a rule of the grammar makes of the next few words, remembered from sentence to sentence.

Most rules that are tried at a place fail after a glance at a word or two, and most that succeed are done within a few.
When a rule meets words that it has not seen yet, it is run on a view of the sentence that notes what it looks at. If
that is little, the rule's outlook keeps what came of it: as a decision tree over the words around a place, with
readings at its leaves. What a leaf says depends on the rule and on these words alone, not on what was read before.
"""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, fields, is_dataclass
from functools import cache, lru_cache
from typing import Any

from rpg.language.meaning import Meaning
from rpg.language.tokens import Token

DEPTH = 3
"""Words that a rule looks at where its outlook is kept, its neighbours before and behind among them."""
MOST = 2000
"""Leaves that one rule keeps."""
ROOM = 3000
"""Frames that rules on views may take: what is known already has no say in how deep a sentence may nest."""
END = ""
"""The key from a sentence's end on."""
_PLAIN = frozenset({"str", "bool", "tuple[str, ...]"})
_SHOWN = frozenset({"word", "number", "punct", "sign"})
_SPANS = frozenset({"Span", "Span | None"})
_INSIDE = 1000
_PADS = 3
_CODED = 1_000_000

Char = Callable[[int, int], int]
"""The character where a token begins (side 0) or ends (side 1)."""


class Hidden(Exception):
    """A rule asks for what a view does not show."""

    def __init__(self, view: View) -> None:
        super().__init__()
        self.view = view


def free_of_places(rule: Callable[..., Any]) -> bool:
    """Whether what a rule is told besides the place, if anything, says nothing of the sentence."""
    return all(kind in _PLAIN for kind in [*rule.__annotations__.values()][2:-1])


def key_of(token: Token) -> str | None:
    """What a view shows of a token; None if that is not all that rules can see in it."""
    if token.word == token.raw and token.kind == "word" and token.value is None:
        return token.word
    if token.kind not in _SHOWN or " " in token.word or " " in token.raw:
        return None
    return f"{token.kind} {token.word} {token.raw} {token.value!r}"


class Sighted:
    """A token in a view: where it stands in the text is not seen."""

    __slots__ = ("kind", "raw", "value", "word")

    def __init__(self, key: str) -> None:
        self.kind, self.word, self.raw, value = key.split(" ") if " " in key else ("word", key, key, "None")
        self.value = None if value == "None" else float(value)


sighted = lru_cache(maxsize=4096)(Sighted)


class View:
    """A sentence around `base`, which stands for a place in it, with a note of what was looked at: `path`, as offsets
    from the base with keys. `words`, `tokens`, `keys` and `end` stand for those of a parser.
    """

    def __init__(self, keys: Sequence[str | None], i: int) -> None:
        self.base = _INSIDE if i > 0 else 0
        self.path: list[tuple[int, str | None]] = []
        self._all = keys
        self._shift = i - self.base
        self._known: dict[int, str] = {}
        self.words, self.tokens, self.keys, self.end = Words(self), Tokens(self), Keys(self), Edge(self)

    def key(self, index: int) -> str:
        """The key at an index."""
        found = self._known.get(index)
        if found is None:
            place = index + self._shift
            if len(self.path) == DEPTH or place < 0:
                raise Hidden(self)
            key = self._all[place]
            self.path.append((index - self.base, key))
            if key is None:
                raise Hidden(self)
            found = self._known[index] = key
        return found

    def ends(self, index: int) -> bool:
        """Whether the sentence ends before an index, and not earlier."""
        return self.key(index) == END and (index == 0 or self.key(index - 1) != END)

    def char(self, index: int, side: int) -> int:
        """A code for a side of a token, relative to the base."""
        return _CODED + 2 * (index - self.base) + side


class _Part:
    __slots__ = ("view",)

    def __init__(self, view: View) -> None:
        self.view = view


class Keys(_Part):
    """The keys of a view."""

    def __getitem__(self, index: int) -> str:
        return self.view.key(index)


class Words(_Part):
    """The words of a view, with empty ones after the end."""

    def __getitem__(self, at: Any) -> Any:
        if isinstance(at, slice):
            return self._several(at.start, at.stop)
        if at < -_PADS:
            raise Hidden(self.view)
        return "" if at < 0 else sighted(self.view.key(at)).word

    def _several(self, start: int | None, stop: int | None) -> list[str]:
        if start is None or stop is None or start < 0 or stop > start + _PADS:
            raise Hidden(self.view)
        found = [sighted(self.view.key(index)).word for index in range(start, stop)]
        if found and not found[0] and not self.view.ends(start):
            raise Hidden(self.view)
        return found


class Tokens(_Part):
    """The tokens of a view."""

    def __getitem__(self, at: Any) -> Sighted:
        if isinstance(at, slice) or at < 0 or not (key := self.view.key(at)):
            raise Hidden(self.view)
        return sighted(key)

    def __bool__(self) -> bool:
        raise Hidden(self.view)


class Edge(_Part):
    """Where the sentence ends. To be compared with an index it looks at the words there."""

    def __gt__(self, index: int) -> bool:
        return self.view.key(index) != END

    def __le__(self, index: int) -> bool:
        return self.view.key(index) == END

    def __eq__(self, index: object) -> bool:
        return isinstance(index, int) and self.view.ends(index)

    __hash__ = None  # type: ignore[assignment]


@dataclass(frozen=True, slots=True)
class Leaf:
    """What came of a rule: its readings, with places relative to where it began, and how far it got."""

    readings: list[tuple[Any, int]]
    far: int
    bare: bool

    def at(self, i: int, char: Char) -> list[tuple[Any, int]]:
        """The readings with the rule begun at `i`."""
        if self.bare:
            return [(found, i + length) for found, length in self.readings]
        return [(_placed(found, i, char), i + length) for found, length in self.readings]


def leaf_of(readings: list[tuple[Any, int]], base: int, far: int) -> Leaf:
    """The leaf for what was found at `base`."""
    relative = [(found, j - base) for found, j in readings]
    return Leaf(relative, far - base, all(_is_bare(found) for found, _ in relative))


@cache
def _places(kind: Any) -> tuple[tuple[str, bool], ...] | None:
    """The fields of a kind of record, and which are spans; None for other kinds."""
    return tuple((f.name, f.type in _SPANS) for f in fields(kind)) if is_dataclass(kind) else None


def _is_bare(found: Any) -> bool:
    """Whether nothing in a meaning says where it stands."""
    if isinstance(found, tuple):
        return all(_is_bare(part) for part in found)
    kind: Any = type(found)
    names = _places(kind)
    return names is None or not (
        isinstance(found, Meaning) or any(not _is_bare(getattr(found, name)) for name, _ in names)
    )


def _placed(found: Any, i: int, char: Char) -> Any:
    """A meaning with its codes for places resolved from `i`."""
    if found.__class__ is tuple:
        return tuple([_placed(part, i, char) for part in found]) if found else found
    names = _places(found.__class__)
    if names is None or not (names and (names[0][1] or not _is_bare(found))):
        return found
    new = object.__new__(found.__class__)
    for name, is_span in names:
        value = getattr(found, name)
        if is_span:
            value = value and (_resolved(value[0], i, char), _resolved(value[1], i, char))
        elif value.__class__ not in _ATOMS:
            value = _placed(value, i, char)
        object.__setattr__(new, name, value)
    return new


_ATOMS = frozenset({str, int, bool, float, type(None)})


def _resolved(code: int, i: int, char: Char) -> int:
    if code < _CODED // 2:
        return code
    place, side = divmod(code - _CODED, 2)
    return char(i + place, side)


Attempt = Callable[[View, tuple[Any, ...]], Leaf]
OPEN = None
"""Stands where a rule looks at more than an outlook keeps: it is to be tried."""


class Outlook:
    """What one rule makes of words that it has seen. `attempt` runs it on a view.

    The trees by the rule's arguments are a cache: what is dropped is found again. A branch is how far from the place
    the word stands that decides, and what follows by its key.
    """

    def __init__(self, attempt: Attempt) -> None:
        self.attempt = attempt
        self.trees: dict[Any, Any] = {}
        self.leaves = 0

    def recall(self, keys: Sequence[str | None], i: int, args: tuple[Any, ...]) -> Leaf | None:
        """What the rule finds at `i`, or OPEN."""
        branches = self.trees
        key: Any = (args, i > 0)
        while True:
            try:
                node = branches[key]
            except KeyError:
                return self._grow(branches, key, keys, i, args)
            if node.__class__ is not tuple:
                return node  # type: ignore[no-any-return]
            offset, branches = node
            key = keys[i + offset] if i + offset >= 0 else None
            if key is None:
                return OPEN

    def _grow(
        self, branches: dict[Any, Any], key: Any, keys: Sequence[str | None], i: int, args: tuple[Any, ...]
    ) -> Leaf | None:
        """Give a tree the leaf that it lacks. Met again while that goes on, the rule counts as open."""
        known = self._known(keys, i, args)
        if self.leaves >= MOST:
            self.trees, self.leaves = {}, 0
        branches[key] = OPEN
        view = View(keys, i)
        leaf: Leaf | None = OPEN
        try:
            with _room():
                leaf = self.attempt(view, args)
        except Hidden as hidden:
            if hidden.view is not view:
                del branches[key]
                raise
        self.leaves += 1
        if [offset for offset, _ in view.path][: len(known)] != known:
            return leaf
        for offset, answer in view.path[len(known) :]:
            further: dict[Any, Any] = {}
            branches[key] = (offset, further)
            branches, key = further, answer
        if key is not None:
            branches[key] = leaf
        return leaf

    def _known(self, keys: Sequence[str | None], i: int, args: tuple[Any, ...]) -> list[int]:
        """How far from the place the words stand by which the tree decides, as far as it goes."""
        node = self.trees.get((args, i > 0))
        found = []
        while node is not None:
            offset, branches = node
            found.append(offset)
            node = branches.get(keys[i + offset])
        return found


@contextmanager
def _room() -> Iterator[None]:
    limit = sys.getrecursionlimit()
    sys.setrecursionlimit(max(limit, ROOM))
    try:
        yield
    finally:
        sys.setrecursionlimit(limit)
