"""How blocks lie around one that four go around: ", one on each side", ", touching it"."""

from __future__ import annotations

from rpg.language.grammar.core import Parser
from rpg.language.grammar.things.nouns import simple
from rpg.language.meaning import Noun, Traits

_LEADS = (",", ":", "(", ", with", "with", ", so that there is", "so that there is")
_ONE = ("one", "one block", "one of them", "one cube")
_SIDES = ("each side", "every side", "each of its sides", "each of its four sides", "each of the sides",
          "each of the four sides", "all four sides", "all sides", "all four of its sides")  # fmt: skip
_EACH_SIDE = tuple(f"{on} {sides}{of}" for on in ("on", "at", "to", "for") for sides in _SIDES for of in ("", " of it"))
_THEY_TOUCH = tuple(
    f"{joint}{touch}"
    for joint in (", ", "")
    for touch in ("touching it", "all touching it", "each touching it", "so that they touch it",
                  "so that they all touch it", "so that all of them touch it", "so that each of them touches it",
                  "that touch it", "which touch it")
)  # fmt: skip
_SO_THAT = (", so that", "so that", ", such that", "such that")
_EVERY_SIDE = tuple(f"{sides}{of}" for sides in (*_SIDES, "all its sides", "all of its sides") for of in ("", " of it"))
_BY = ("is touched by", "are touched by", "touches", "touch")
_THEM = ("one of them", "one of those", "one of these", "one", "them")


def one_on_each(p: Parser, i: int) -> int:
    """The position behind words that put one block on each of the four sides, or 0."""
    begin = p.any_of(i, _LEADS) or i
    one = p.any_of(begin, _ONE)
    each = p.any_of(one, _EACH_SIDE) if one else 0
    return p.one(each, ")") if each and p.words[begin - 1] == "(" else each


def touching(p: Parser, i: int, look: Traits) -> int:
    """The position behind ", touching it", or behind ", so that each side of it is touched by a red block", if these
    have that look; or 0."""
    if k := p.any_of(i, _THEY_TOUCH):
        return k
    so = p.any_of(i, _SO_THAT)
    sides = p.any_of(so, _EVERY_SIDE) if so else 0
    by = p.any_of(sides, _BY) if sides else 0
    if not by:
        return 0
    alike = [k for one, k in simple(p, by) if isinstance(one, Noun) and one.det == "a" and one.traits == look]
    return p.any_of(by, _THEM) or max(alike, default=0)
