"""How the place of what was spoken of is told."""

from __future__ import annotations

from rpg.language.grammar.core import Parser
from rpg.language.meaning import Meaning, Noun

IN_ITS_PLACE = ("in its place", "in its position", "in its spot", "in its stead", "where it was", "where it is")


def in_its_place(p: Parser, k: int, theme: Meaning) -> bool:
    """ "Put a blue block in its place": in that of another block; "put it back where it was" is its own."""
    return isinstance(theme, Noun) and p.words[k - 1] != "back" and bool(p.any_of(k, IN_ITS_PLACE))
