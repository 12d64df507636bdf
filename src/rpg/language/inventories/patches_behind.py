"""Patches that are named behind the word for all of them: "all six blocks on the two mats, as many on the pink mat as
on the green one"."""

from __future__ import annotations

from rpg.language import lexicon
from rpg.language.grammar.rows.parting import text_of
from rpg.language.grammar.rows.vocabulary import COLOR, FEW, PATCH, PATCHES
from rpg.language.patterns import on_demand
from rpg.language.tokens import Token

_ALL_OF_THEM = on_demand(rf"\b(?:(both)(?: of)?(?: the)?|(?:the|these|my)(?: ({FEW}|\d+))?) {PATCHES}\b")
_THERE = on_demand(rf"\bthere (?:is|are) (?:(?!\.).)*\b(?:{PATCH}|{PATCHES})\b")
_NAMED = on_demand(rf"\b({COLOR}) {PATCH}\b")
_ON_ONE = on_demand(rf"\b(?:on|onto|in|into) (?:the )?({COLOR})(?: one)?(?=$| (?:[,.;!:]|(?:and|as|than|but|or)\b))")
"""What behind a patch that is named is another one."""


def patches_behind(tokens: list[Token]) -> list[Token] | None:
    """A sentence that tells which patches there are, where as many are named by their colors as all of them are."""
    text = text_of(tokens)
    spoken = _ALL_OF_THEM.search(text)
    if spoken is None or _THERE.search(text):
        return None
    first = _NAMED.search(text)
    colors = [*_NAMED.findall(text), *(_ON_ONE.findall(text, first.start()) if first else ())]
    several = dict.fromkeys(colors)
    both, many = spoken.groups()
    if len(several) != (2 if both else lexicon.NUMBER.get(many, 0) or int(many) if many else max(len(several), 2)):
        return None
    listed = " and ".join(f"a {color} patch" for color in several)
    return [tokens[0].saying(word) for word in f"there are {listed} .".split()]
