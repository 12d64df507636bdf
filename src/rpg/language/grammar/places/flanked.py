"""Rows that have other blocks at their ends: "three white cubes in a row, flanked by two blue ones"."""

from __future__ import annotations

from rpg.language.grammar.core import Parser, Results, choice
from rpg.language.grammar.things.nouns import simple
from rpg.language.meaning import Absolute, Amount, Meaning, Noun, Places

_FLANKED = ("flanked by", "and flanked by", "framed by", "and framed by", "bordered by", "bookended by")
_MARKED = frozenset({"flanked", "framed", "bordered", "bookended"})
_ROWS = frozenset({"row", "line", "lined"})
_AT_ENDS = tuple(
    f"{at} {ends}"
    for at in ("at", "on")
    for ends in ("each end", "both ends", "either end", "the ends", "its ends", "both sides", "each side",
                 "either side")
)  # fmt: skip
_PAIR = Amount(2, 2)


@choice
def flanked(p: Parser, i: int) -> Results[Absolute]:
    """One block at each end, or two of a kind, of which one is at each."""
    if not p.rarely(_MARKED) or not p.anywhere(_ROWS):
        return
    begin = p.opt(i, ",")
    j = p.any_of(begin, _FLANKED)
    for theme, k in simple(p, j) if j else ():
        end = p.any_of(k, _AT_ENDS) or k
        if _at_ends(theme, told=end > k):
            both = Places(side="ends", unit="block", each=end > k and _lone(theme), span=p.span(k, end))
            yield Absolute(theme=theme, adjuncts=(both,), span=p.span(i, end)), end


def _at_ends(theme: Meaning, *, told: bool) -> bool:
    """Whether these can be the blocks at the two ends. `told`: it is said that they are there."""
    if not isinstance(theme, Noun) or theme.head == "patch" or theme.part_of is not None:
        return False
    return theme.amount == _PAIR or (theme.plural and theme.amount is None) or (told and _lone(theme))


def _lone(theme: Meaning) -> bool:
    return isinstance(theme, Noun) and not theme.plural and theme.det in ("a", "bare")
