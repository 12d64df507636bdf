"""With which words a rule of the grammar may begin, found out by asking the rule itself.

Nearly every rule that is tried at a place asks for a few first words, does not find them and is done. So each rule is
run once on a first word that is none of those it asks for, with a note of what it asks: for every other word that it
does not ask for it does the very same, and need not be run. What a rule does besides asking (it looks at another place,
or into the word) makes it one that is always run.
"""

from __future__ import annotations

import string
from collections.abc import Callable, Iterable
from typing import Any

from rpg.language.tokens import Token

END = ""
"""Stands for the word where the sentence has ended."""
_PLAIN = frozenset({"str", "bool", "tuple[str, ...]"})


class Hidden(Exception):
    """A rule does with the first word what says nothing of other words."""


def free_of_places(rule: Callable[..., Any]) -> bool:
    """Whether what a rule is told besides the place, if anything, says nothing of the sentence."""
    return all(kind in _PLAIN for kind in [*rule.__annotations__.values()][2:-1])


def head_of(token: Token) -> str | None:
    """The word by which a rule may be spared a token; None if rules can see more in it than the word."""
    plain = token.kind in ("word", "punct") and not (len(token.raw) > 1 and token.raw.isupper())
    return token.word if plain and token.value is None else None


Firsts = tuple[frozenset[str], frozenset[str], frozenset[str], frozenset[str] | None, tuple[Any, ...]]
"""What a rule asks of the word where it begins.

The words that it asks for; those that it asks for in front of that word, and anywhere in the sentence; the words that
it asks for where it finds some of these (None: any); its readings before all other words and at the end of the
sentence, of no length.
"""
MOST_TRIED = 400
"""As many answers at most are tried on a rule that asks for words at other places."""


class Asked:
    """The note of what a rule asks for at `base`. `kind`: that of the token there, END at the end of the sentence."""

    def __init__(self) -> None:
        self.kind = END
        self.base = 0
        self.words: set[str | None] = set()
        self.behind: set[str] = set()
        self.anywhere: set[str] = set()
        self.further: set[str | None] | None = set()
        self.answers: list[bool] = []
        self.given = self.tried = 0

    def answer(self) -> bool:
        """Whether words that a rule asks for stand at other places: every row of answers is tried, beginning with "no"
        to all."""
        if self.given == len(self.answers):
            self.answers.append(False)
        self.given += 1
        return self.answers[self.given - 1]

    def others(self) -> bool:
        """Whether there are further answers to try, which are given then, and too few of them to give up."""
        while self.answers and self.answers[-1]:
            self.answers.pop()
        if self.answers:
            self.answers[-1] = True
        self.given, self.tried = 0, self.tried + 1
        if self.tried > MOST_TRIED:
            self.further = None
        if self.further is None:
            self.answers.clear()
        return bool(self.answers)

    def here(self, index: int) -> None:
        if index != self.base:
            raise Hidden

    def note(self, index: int, words: Iterable[str | None]) -> None:
        """The rule asks whether the word at an index is one of these."""
        self.here(index)
        if not any(self.answers[: self.given]):
            self.words.update(words)
        elif self.further is not None:
            self.further.update(words)

    def firsts(self, found: tuple[Any, ...]) -> Firsts:
        """What the rule asks for, with its readings before all other words."""
        words = frozenset(word for word in self.words if word)
        further = None if self.further is None else frozenset(word for word in self.further if word)
        return words, frozenset(self.behind), frozenset(self.anywhere), further, found


class _Part:
    """Something of a sentence that says nothing but what its class lets it say."""

    __slots__ = ("asked",)

    def __init__(self, asked: Asked) -> None:
        self.asked = asked

    def __getattr__(self, name: str) -> Any:
        raise Hidden

    def __getitem__(self, at: Any) -> Any:
        raise Hidden

    def __hash__(self) -> int:
        raise Hidden

    def __bool__(self) -> bool:
        raise Hidden

    def __len__(self) -> int:
        raise Hidden


class AnyWord(_Part):
    """A word that is none of those it is compared with."""

    __slots__ = ()

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, str):
            raise Hidden
        self.asked.note(self.asked.base, (other,))
        return False

    def __bool__(self) -> bool:
        return True

    __hash__ = _Part.__hash__


class AnyRaw(_Part):
    """A word as it is written: of several letters, and not in capitals. Letters may be what a rule asks for here."""

    __slots__ = ()

    def __len__(self) -> int:
        self.asked.note(self.asked.base, string.ascii_lowercase)
        return 2

    def isupper(self) -> bool:
        return len(self) == 1

    def strip(self, _: str) -> AnyRaw:
        return self

    upper = lower = lambda self: self


class AnyToken(_Part):
    """A token with any word."""

    __slots__ = ()

    @property
    def kind(self) -> str:
        return self.asked.kind

    @property
    def word(self) -> AnyWord:
        return AnyWord(self.asked)

    @property
    def raw(self) -> AnyRaw:
        return AnyRaw(self.asked)

    @property
    def value(self) -> None:
        return None


class Tokens(_Part):
    """The tokens of a sentence of which nothing is known but that one stands at the base."""

    __slots__ = ()

    def __getitem__(self, index: Any) -> AnyToken:
        if index != self.asked.base or not self.asked.kind:
            raise Hidden
        return AnyToken(self.asked)


class Words(_Part):
    """The words of such a sentence."""

    __slots__ = ()

    def __getitem__(self, at: Any) -> Any:
        if isinstance(at, slice):
            base = self.asked.base
            if at.start != base or at.stop is None or not base <= at.stop <= base + 3:
                raise Hidden
            return [self[index] if index == base else _Part(self.asked) for index in range(at.start, at.stop)]
        self.asked.here(at)
        return AnyWord(self.asked) if self.asked.kind else ""


class Edge(_Part):
    """Where the sentence ends: at the base, or somewhere behind it."""

    __slots__ = ()

    def __gt__(self, index: int) -> bool:
        self.asked.here(index)
        return self.asked.kind != ""

    def __le__(self, index: int) -> bool:
        return not self > index

    def __eq__(self, index: object) -> bool:
        return isinstance(index, int) and self <= index

    __hash__ = _Part.__hash__


class Heads:
    """Says of every token that rules are to be run on it."""

    def __getitem__(self, index: int) -> None:
        return None
