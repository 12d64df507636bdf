"""Whom something is done for, between a verb and what it is done with: "build us a wall"."""

from __future__ import annotations

from rpg.language import lexicon
from rpg.language.grammar.core import Parser

_GIVING = frozenset({"place", "build", "stack", "arrange", "spell", "sort", "pick"})
_US = ("me", "us")
_BEGINS = frozenset({"a", "an", "the", "some", "one", "another", "any", "all", *lexicon.NUMBER})
"""What is done something with begins with these."""


def behind_us(p: Parser, j: int, sense: str) -> int:
    """The position behind "us" in "build us a wall", "put me a red block on the mat"; else `j`."""
    given = sense in _GIVING and p.stands(j, _US) and p.stands(j + 1, _BEGINS)
    return p.reach(j + 1) if given else j
