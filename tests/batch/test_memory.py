"""What a process keeps while it compiles thousands of tasks is bounded. `make bench-memory` measures it."""

from __future__ import annotations

import functools
import gc
from random import Random

from rpg.language.grammar.core import BEGINNINGS
from rpg.pipeline import compile_instruction

SENTENCES = (
    "Stack the {} block on the {} block",
    "Put the {} block to the left of the {} block on the {} patch",
    "Make a row of three {} blocks and two {} blocks",
    "Stack {} {} blocks",
    "Spell the word {}",
)
FILLINGS = (
    ("red", "blue", "green", "3", "CAT"),
    ("yellow", "pink", "black", "4", "DOG"),
    ("purple", "cyan", "brown", "5", "ROBOT"),
    ("orange", "white", "gray", "2", "HI"),
)
MOST = 4096
"""Entries that a cache may hold at most."""
FEW = 200
"""Entries of a cache without bound, as one by classes may be: there are no more of them."""


def caches() -> dict[str, functools._lru_cache_wrapper[object]]:
    """Every cache of rpg that is alive, by its name."""
    found = [each for each in gc.get_objects() if isinstance(each, functools._lru_cache_wrapper)]
    return {f"{each.__module__}.{each.__qualname__}": each for each in found if each.__module__.startswith("rpg.")}


def compile_all(words: tuple[str, ...], seed: int) -> None:
    colors = Random(seed).sample(words[:3], 3)
    filled = [sentence.format(*colors) for sentence in SENTENCES[:3]]
    for text in (*filled, SENTENCES[3].format(words[3], words[0]), SENTENCES[4].format(words[4])):
        compile_instruction(text)


def test_caches_are_bounded_or_of_things_that_are_few() -> None:
    for number, words in enumerate(FILLINGS):
        compile_all(words, number)
    found = {name: cache.cache_info() for name, cache in caches().items()}
    assert any(info.misses for info in found.values())
    for name, info in found.items():
        if info.maxsize is not None:
            assert info.maxsize <= MOST, name
        else:
            assert info.currsize <= FEW, name


def test_what_rules_remember_of_their_beginnings_is_bounded() -> None:
    for number, words in enumerate(FILLINGS):
        compile_all(words, number)
    assert any(each.firsts for each in BEGINNINGS)
    assert all(len(each.firsts) <= FEW for each in BEGINNINGS)
