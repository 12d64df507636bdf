"""How a frame is put into words: gaps, and choices between phrasings."""

from __future__ import annotations

import re
from random import Random
from typing import Any

COLORS = ("red", "orange", "yellow", "green", "cyan", "blue", "purple", "pink", "brown", "black", "gray", "white")
RAINBOW = COLORS[:8]
CHOICE = re.compile(r"\[([^\[\]]*)\]")
NUMBERS = ("no", "one", "two", "three", "four", "five", "six", "seven", "eight", "nine", "ten")
PUT = "[put|place|arrange|line up|lay]"
WANT = "[I want|I'd like|give me|please make|make|build]"
BLOCKS = "[blocks|cubes]"
BLOCK = "[block|cube]"
RIGHT = "[from left to right|left to right|from the left to the right|starting from the left|beginning on the left]"

Meaning = dict[str, Any]


def said(rng: Random, text: str, gaps: dict[str, str]) -> str:
    """`text` with one of each [choice|of phrasings] and its {gaps} filled, which may hold choices themselves."""
    text = re.sub(r"\{(\w+)\}", lambda gap: gaps[gap[1]], text)
    while CHOICE.search(text):
        text = CHOICE.sub(lambda choice: rng.choice(choice[1].split("|")), text)
    text = " ".join(text.split()).replace(" ,", ",").replace(" .", ".").replace(" :", ":")
    text = re.sub(r"\b([Aa]) (?=orange)", r"\1n ", text)
    return text if rng.random() < 0.4 else text[0].upper() + text[1:] + ("" if text[-1] in ".?!" else ".")


def joined(items: list[str], last: str = " and ") -> str:
    """A list in words."""
    return ", ".join(items[:-1]) + last + items[-1]


def listed(rng: Random, items: list[str]) -> str:
    """The same in one of the ways in which people list."""
    return joined(items, rng.choice((" and ", " and ", ", and ", ", ")))


def count(rng: Random, number: int) -> str:
    """A number in words or digits."""
    return rng.choice((NUMBERS[number], NUMBERS[number], str(number)))


def once(labels: list[str]) -> Meaning:
    """How often each look is there."""
    return {label: labels.count(label) for label in labels}
