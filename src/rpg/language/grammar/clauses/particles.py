"""Words between what is moved and where it goes that tell no more: "move it over to the mat", "from there"."""

from __future__ import annotations

from rpg.language.grammar.core import Parser
from rpg.language.meaning import Loc, Meaning, Structure, replace

_ACROSS = frozenset({"over", "round", "around", "across", "along"})
WHITHER = frozenset({"on", "onto", "in", "into", "behind", "beside", "next", "near", "by", "upon", "under", "beneath"})
"""Before these words of place the others tell no more than that something moves."""
_THENCE = ("from there", "from here", "away from there", "off there", "from where it is", "from where it is now")
_THITHER = WHITHER | {"to", "over"}


def across(p: Parser, k: int, sense: str, *, told: bool) -> int:
    """The position behind such words, which may stand behind the verb's object. `told`: something was told before, so
    that "there" may be where it is."""
    k = p.opt(k, "places", "positions", "around", "over", "round") if sense == "swap" else k
    k = k + 1 if sense == "place" and p.stands(k, _ACROSS) and p.stands(k + 1, WHITHER) else k
    thence = p.any_of(k, _THENCE) if told else 0
    return thence if thence and p.stands(thence, _THITHER) else k


def added(lemma: str, found: tuple[Meaning, ...]) -> tuple[Meaning, ...]:
    """ "Add a red block to the tower": on top of it."""
    return tuple(replace(x, rel="on", cost=0) if lemma == "add" and _into_a_tower(x) else x for x in found)


def _into_a_tower(place: Meaning) -> bool:
    mark = place.landmark if isinstance(place, Loc) and place.rel == "in" else None
    return isinstance(mark, Structure) and mark.kind == "stack" and not mark.plural
