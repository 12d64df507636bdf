"""Words between what is moved and where it goes that tell no more: "move it over to the mat", "from there"."""

from __future__ import annotations

from rpg.language.grammar.core import Parser

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
