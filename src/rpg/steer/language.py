"""The language that edits share with instructions: tokens, rules for noun phrases and places, their meanings."""

from __future__ import annotations

from functools import lru_cache

from rpg.language import lexicon
from rpg.language import meaning as m
from rpg.language.grammar.adjectives import adjectives, colors
from rpg.language.grammar.amounts import count, length
from rpg.language.grammar.core import Parser, Results, TooMuchWork, rule
from rpg.language.grammar.labels import label_list, literal
from rpg.language.grammar.measures import bounds
from rpg.language.grammar.nouns import noun_phrase, simple
from rpg.language.grammar.orders import order
from rpg.language.grammar.relations import loc
from rpg.language.grammar.sizes import dimensions
from rpg.language.tokens import Token, tokenize


@lru_cache(maxsize=1024)
def phrases(text: str) -> tuple[str, ...]:
    """The phrases of a table, which are written with bars between them."""
    return tuple(phrase.strip() for phrase in text.split("|"))


def longest(p: Parser, i: int, table: str | tuple[str, ...]) -> int:
    """The position after the longest phrase of a table that stands at i, or 0."""
    if i >= p.end:
        return 0
    return max((p.seq(i, phrase) for phrase in _by_first_word(table).get(p.words[i], ())), default=0)


@lru_cache(maxsize=1024)
def _by_first_word(table: str | tuple[str, ...]) -> dict[str, tuple[str, ...]]:
    found: dict[str, tuple[str, ...]] = {}
    for phrase in phrases(table) if isinstance(table, str) else table:
        first = phrase.split()[0]
        found[first] = (*found.get(first, ()), phrase)
    return found


__all__ = [
    "Parser",
    "Results",
    "Token",
    "TooMuchWork",
    "adjectives",
    "bounds",
    "colors",
    "count",
    "dimensions",
    "label_list",
    "length",
    "lexicon",
    "literal",
    "loc",
    "longest",
    "m",
    "noun_phrase",
    "order",
    "phrases",
    "rule",
    "simple",
    "tokenize",
]
