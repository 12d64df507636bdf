""" "Two green blocks, two purple ones and a green mat": "ones" in a list are what was named before them."""

from __future__ import annotations

from rpg.language.grammar.core import Parser
from rpg.language.meaning import Coord, Meaning, Noun, replace

_ONES = frozenset({"one", "ones"})


def of_their_kind(p: Parser, listed: Meaning) -> Meaning:
    """A list whose ones are of the kind named last before them: blocks, where there are mats behind them alone."""
    if not isinstance(listed, Coord) or listed.op != "and":
        return listed
    items = _flat(listed)
    nouns = [item for item in items if isinstance(item, Noun)]
    if len(nouns) < len(items) or all(noun.head != "patch" for noun in nouns):
        return listed
    kind, found = "block", []
    for noun in nouns:
        if noun.head != "any":
            kind = "patch" if noun.head == "patch" else "block"
        found.append(replace(noun, head=kind) if noun.head == "any" and says_ones(p, noun) else noun)
    return listed if found == nouns else replace(listed, items=tuple(found))


def begins_with_ones(p: Parser, listed: Meaning) -> bool:
    """Whether what is named first in a list stands for something before the list."""
    first = _flat(listed)[0]
    return isinstance(first, Noun) and first.head == "any" and says_ones(p, first)


def _flat(listed: Meaning) -> tuple[Meaning, ...]:
    if isinstance(listed, Coord) and listed.op == "and":
        return tuple(part for item in listed.items for part in _flat(item))
    return (listed,)


def says_ones(p: Parser, noun: Noun) -> bool:
    """Whether "one" or "ones" is its noun."""
    return any(token.word in _ONES and token.span[1] == noun.span[1] for token in p.tokens)
