""" "Stack them all, red, green and blue": the list behind "them" says which blocks are meant."""

from __future__ import annotations

from rpg.language.grammar.clauses.out_of_these import several
from rpg.language.grammar.core import Parser, Results
from rpg.language.grammar.talk.slots import Patterns
from rpg.language.grammar.things.nouns import noun_phrase
from rpg.language.meaning import Coord, Meaning, Noun, replace

_THEM = Patterns("them|these all|both|together? up?", "all of_them|of_these up?")
_FEW = 3
"""So many that stand behind "them" with no mark between are a list."""
_AT_ONCE = 4
"""The word before which "them" stands in a command that nothing stands before."""


def them_listed(p: Parser, i: int) -> Results[Meaning]:
    """Where nothing in the sentence comes before it that "them" could stand for."""
    if i >= _AT_ONCE:
        return
    for j in _THEM.matches(p, i):
        listed = p.opt(j, ",", ":")
        for theme, k in noun_phrase(p, listed):
            if several(theme) and (listed > j or _many(theme) >= _FEW):
                yield replace(theme, cost=theme.cost + 2), k


def _many(theme: Meaning) -> int:
    if isinstance(theme, Coord):
        return len(theme.items)
    return max(len(theme.traits.colors), len(theme.traits.labels)) if isinstance(theme, Noun) else 0
