"""What is chosen by chance: words that mean the same, and looks that are not in the sentence yet."""

from __future__ import annotations

from collections.abc import Sequence
from random import Random
from typing import TypeVar

T = TypeVar("T")
COLORS = ("red", "green", "blue", "yellow", "orange", "purple", "white", "black", "gray", "pink", "brown", "cyan")
LETTERS = "BCDEFGHKLMNPRTXZ"
NUMBERS = {1: "one", 2: "two", 3: "three", 4: "four", 5: "five"}


class Chance:
    """Choices for one sentence, from a stream of random numbers."""

    def __init__(self, rng: Random) -> None:
        self._rng = rng
        self._colors, self._letters = list(COLORS), list(LETTERS)

    def of(self, *choices: T) -> T:
        """One of several."""
        return self._rng.choice(choices)

    def number(self, low: int, high: int) -> int:
        """A number from `low` to `high`, both included."""
        return self._rng.randint(low, high)

    def often(self, share: float) -> bool:
        """True in that share of all cases."""
        return self._rng.random() < share

    def colors(self, count: int) -> list[str]:
        """Colours that nothing in the sentence has yet."""
        return [self._taken(self._colors) for _ in range(count)]

    def letters(self, count: int) -> list[str]:
        """Letters that no cube in the sentence shows yet."""
        return [self._taken(self._letters) for _ in range(count)]

    def looks(self, count: int) -> list[str]:
        """All of them colours, or all letters."""
        return self.letters(count) if self.often(0.3) else self.colors(count)

    def _taken(self, pool: list[str]) -> str:
        return pool.pop(self._rng.randrange(len(pool)))

    def word(self, words: Sequence[str]) -> str | None:
        """A word that can still be spelled; its letters are taken then."""
        left = [word for word in words if all(letter in self._letters for letter in word)]
        if not left:
            return None
        word = self._rng.choice(left)
        for letter in word:
            self._letters.remove(letter)
        return word

    @property
    def block(self) -> str:
        return self.of("block", "cube")

    @property
    def blocks(self) -> str:
        return self.of("blocks", "cubes")

    @property
    def put(self) -> str:
        return self.of("put", "place", "set")

    @property
    def must_be(self) -> str:
        return self.of("is", "must be", "should be", "has to be")

    def start(self, text: str) -> str:
        """As a sentence begins, mostly."""
        return text[0].upper() + text[1:] if self.often(0.7) else text


def a(noun: str) -> str:
    """ "a red", "an orange"."""
    return f"an {noun}" if noun[0] in "aeio" else f"a {noun}"


def listed(words: Sequence[str]) -> str:
    """ "red, green and blue"."""
    return " and ".join((", ".join(words[:-1]), words[-1])) if len(words) > 1 else words[0]


def the(look: str, chance: Chance) -> str:
    """ "the red block", "the A"."""
    return f"the {look}" if look in LETTERS else f"the {look} {chance.block}"
