"""The language that edits share with instructions: tokens, rules for noun phrases and places, their meanings."""

from __future__ import annotations

from dataclasses import replace
from functools import lru_cache

from rpg.language import lexicon
from rpg.language import meaning as m
from rpg.language.grammar.core import Parser, Results, TooMuchWork, rule
from rpg.language.grammar.places.measures import bounds
from rpg.language.grammar.places.regions import named_regions as region_name
from rpg.language.grammar.places.relations import loc
from rpg.language.grammar.structures.orders import order
from rpg.language.grammar.structures.sizes import dimensions, in_lines
from rpg.language.grammar.things.adjectives import adjectives, colors
from rpg.language.grammar.things.amounts import count, length
from rpg.language.grammar.things.labels import label_list, literal
from rpg.language.grammar.things.nouns import noun_phrase as plain_noun_phrase
from rpg.language.grammar.things.nouns import simple
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


@rule
def noun_phrase(p: Parser, i: int) -> Results[m.Meaning]:
    """A noun phrase of the language, or "all three of them", "the two of them"."""
    for found, j in plain_noun_phrase(p, i):
        yield found, j
        yield from _with_one(p, i, found, j)
    yield from _by_its_blocks(p, i)
    j = longest(p, i, "all | the | these | those")
    for number, k in count(p, j) if j else ():
        if end := longest(p, k, "of them | of these | of those"):
            them = m.Pronoun(word="them", span=p.span(k, end))
            amount = m.Amount(number, number)
            yield m.Noun(head="any", det="all", amount=amount, plural=True, part_of=them, span=p.span(i, end)), end


def _with_one(p: Parser, i: int, found: m.Meaning, j: int) -> Results[m.Meaning]:
    """Phrases such as "the tower with the green block": a structure by one of its blocks."""
    if not isinstance(found, m.Structure) or found.det != "the" or found.members is not None or found.plural:
        return
    k = longest(p, j, "with | containing | that has | which has | that contains | holding")
    for block, end in simple(p, k) if k else ():
        if isinstance(block, m.Noun) and block.det in ("the", "a") and not block.plural:
            yield replace(found, members=replace(block, det="the", amount=None), span=p.span(i, end)), end


def _by_its_blocks(p: Parser, i: int) -> Results[m.Meaning]:
    """Phrases such as "the green on red tower"."""
    j = p.one(i, "the")
    for (upper, _), k in colors(p, j) if j else ():
        n = p.one(k, "on")
        for (lower, _), end in colors(p, n) if n and len(upper) == 1 else ():
            if len(lower) == 1 and p.one(end, frozenset({"tower", "stack"})):
                below = m.Noun(head="block", det="the", traits=m.Traits(colors=lower), span=p.span(n, end))
                on = (m.Loc(rel="on", landmark=below, span=p.span(k, end)),)
                top = m.Noun(head="block", det="the", traits=m.Traits(colors=upper), conditions=on, span=p.span(j, end))
                yield m.Structure(kind="stack", det="the", members=top, span=p.span(i, end + 1)), p.reach(end + 1)


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
    "in_lines",
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
    "region_name",
    "rule",
    "simple",
    "tokenize",
]
