"""What blocks are called, also where goods are kept and games are played: "the red stock", "three dice"."""

from __future__ import annotations

from rpg.language import lexicon
from rpg.language.grammar.core import Parser, Results
from rpg.language.grammar.things.strangers import STRANGERS

_MASSES = ("stock", "cargo", "freight", "merchandise")
_COLORED = frozenset({*_MASSES, *STRANGERS, "unit", "units", "goods"})
"""Something else where no colour stands in front of them."""
_DETERMINED = frozenset({"goods", "cargo", "freight"})
_DETERMINERS = ("the", "all", "these", "those")


def goods(p: Parser, i: int) -> Results[bool]:
    """Whether blocks that are named here are several."""
    for table in (lexicon.BLOCK, lexicon.LOOSE_BLOCK):
        if (plural := p.lex(i, table)) is not None and not _may_be_one(p, i):
            yield plural, i + 1
    j = p.follows(i, lexicon.COLOR) and p.one(i, _COLORED)
    if j := j or (p.follows(i, _DETERMINERS) and p.one(i, _DETERMINED)):
        yield p.words[i].endswith("s") or p.words[i] in _MASSES, j


def _may_be_one(p: Parser, i: int) -> bool:
    """ "The red dice": people say so of one."""
    at = i - 1
    while p.stands(at, lexicon.COLOR):
        at -= 1
    return p.stands(i, ("dice",)) and at < i - 1 and p.stands(at, ("the", "a", "an"))
