"""Lists whose first is at the bottom or whose last is on top: "stack red, green, blue with red at the bottom"."""

from __future__ import annotations

from rpg.language.grammar.core import Parser
from rpg.language.meaning import Absolute, At, Coord, Meaning, Noun, OrderBy, Places, Using

_FEWEST = 3
"""Of two blocks the other one is told by what is said of one of them."""
_AT = {"bottom": 0, "first": 0, "top": -1, "last": -1}


def in_turn(p: Parser, j: int, k: int, theme: Meaning, told: tuple[Meaning, ...]) -> tuple[Meaning, ...]:
    """What is told of the stack, with the order of the list at j..k where an end of it is told as it is listed.

    A list with "and" says which blocks there are; in which order they are does not follow from one of them.
    """
    looks = _looks(theme)
    ends = [end for end in (_end(told, n) for n in range(len(told))) if end is not None]
    if len(looks) < _FEWEST or len(ends) != 1 or "and" in p.words[j:k] or any(isinstance(x, OrderBy) for x in told):
        return told
    look, side = ends[0]
    fits = len(set(looks)) == len(looks) and side in _AT and looks[_AT[side]] == look
    return (*told, OrderBy(by="given", span=p.span(j, k))) if fits else told


def _looks(theme: Meaning) -> list[str]:
    """The looks of single blocks that are listed."""
    if isinstance(theme, Coord):
        listed = [_look(x) for x in theme.items] if theme.op == "and" else []
        return [] if None in listed else [x for x in listed if x]
    if isinstance(theme, Noun) and theme.amount is None and theme.head != "patch":
        return [*(theme.traits.labels or theme.traits.colors)]
    return []


def _look(block: Meaning) -> str | None:
    """What a single block shows, or its colour."""
    single = isinstance(block, Noun) and not block.plural and block.head != "patch"
    shown = block.traits.labels or block.traits.colors if isinstance(block, Noun) and single else ()
    return shown[0] if len(shown) == 1 else None


def _end(told: tuple[Meaning, ...], n: int) -> tuple[str, str] | None:
    """What is at which place, where an adjunct, or it and the next one, says that."""
    one = told[n]
    place = one.adjuncts[0] if isinstance(one, Absolute) and len(one.adjuncts) == 1 else None
    block: Meaning | None = one.theme if isinstance(one, Absolute) else None
    if isinstance(one, Using) and n + 1 < len(told):
        block, place = one.members, told[n + 1]
    look = _look(block) if block is not None else None
    if look is None or not isinstance(place, At | Places) or place.index not in (None, 1):
        return None
    return look, place.side
