"""All others that nothing is to be done with: "(do not move) anything else"."""

from __future__ import annotations

from rpg.language.grammar.core import Parser

_ANY_OTHER = ("anything else", "any of the others", "any of the other blocks", "any of the other cubes",
              *(f"any other {block}" for block in ("block", "blocks", "cube", "cubes", "one", "object", "objects")),
              "other blocks", "other cubes")  # fmt: skip
_DISTURB = frozenset({"move", "touch", "disturb"})
_DISTURBING = frozenset({"moving", "disturbing"})
_BEGINS = frozenset({"", ",", ";", ":", "and", "but", "please"})


def left_alone(p: Parser, i: int) -> int:
    """ "(Do not move) anything else", "(without disturbing) any other block": the position behind all the others."""
    if not p.rarely(_DISTURB | _DISTURBING):
        return 0
    behind = p.words[i - 2] == "without" if p.follows(i, _DISTURBING) else False
    if p.follows(i, _DISTURB) and i > 2:
        behind = p.words[i - 3 : i - 1] == ["do", "not"] and (i == 3 or p.words[i - 4] in _BEGINS)
    return p.any_of(i, _ANY_OTHER) if behind else 0
