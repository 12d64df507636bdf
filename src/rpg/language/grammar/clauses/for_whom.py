"""Whom something is done for, between a verb and what it is done with: "build us a wall"."""

from __future__ import annotations

from rpg.language import lexicon
from rpg.language.grammar.core import Parser

_GIVING = frozenset({"place", "build", "stack", "arrange", "spell", "sort", "pick"})
_RAISING = frozenset({"build", "stack"})
"""What is done up: "stack me up a tower"."""
_US = ("me", "us")
_BEGINS = frozenset({"a", "an", "the", "some", "one", "another", "any", "all", *lexicon.NUMBER})
"""What is done something with begins with these."""


def behind_us(p: Parser, j: int, sense: str) -> int:
    """The position behind "us" in "build us a wall", "stack me up a tower", "put me a red block there"; else `j`."""
    given = sense in _GIVING and p.stands(j, _US)
    up = given and sense in _RAISING and p.stands(j + 1, ("up",))
    what = j + 1 + up
    return p.reach(what) if given and p.stands(what, _BEGINS) else j
