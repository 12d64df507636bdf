"""Colours told behind what is asked: "each on a different patch. The patches are red, green and blue", "stack the other
three on it. The others are yellow"."""

from __future__ import annotations

import re

from rpg.language import lexicon
from rpg.language.grammar.rows.parting import text_of
from rpg.language.grammar.rows.vocabulary import COLOR, CUBE, FEW, PATCH, PATCHES
from rpg.language.patterns import on_demand
from rpg.language.tokens import Token

_LIST = rf"{COLOR}(?:(?: ,| and| , and)+ {COLOR})+"
_MANY = rf"(?:{FEW}|\d+)"
_AS_WELL = r"(?: ,)? and (there (?:is|are) [^.;!]+)"
_PATCHES_ARE = on_demand(rf"^(?:the |all )*(?:({_MANY}) )?(?:{PATCHES}) are ({_LIST})(?:{_AS_WELL})? [.;!]$")
_ONE_PATCH = on_demand(
    rf"^one (?:{PATCH}) is ({COLOR})(?: ,| and| , and) the other(?: one| {PATCH})?(?: is)? ({COLOR}) [.;!]$"
)
_OTHERS_ARE = on_demand(
    rf"^the (?:others|rest|other ones|other {CUBE}s|(?:other|remaining) ({_MANY})(?: {CUBE}s| ones)?) are (?:all )?"
    rf"(?:({_LIST})|(?:({_MANY}) )?({COLOR})(?: {CUBE}s| ones)?) [.;!]$"
)
_OTHER = on_demand(rf"\bthe (?:other|remaining) ({_MANY})\b")
_NAMED = on_demand(rf"\b(?:the|an?) ({COLOR}) (?:{CUBE}|one)\b")
_COUNTED = on_demand(rf"\b(?:{_MANY}|all|both|each|every|no) ({COLOR})\b|\b{COLOR} (?:{CUBE}s|ones)\b")


def colors_behind(part: list[Token], rest: list[Token]) -> list[Token] | None:
    """A sentence that tells what there is, in the place of one that tells the colours of what the others speak of."""
    text, asked = text_of(part), text_of(rest)
    listed = _patches(text, asked) or _blocks(text, asked)
    told = _PATCHES_ARE.match(text)
    more = f"{told[3]} . " if told and told[3] else ""
    return [part[0].saying(word) for word in f"{more}there are {' and '.join(listed)} .".split()] if listed else None


def _patches(text: str, asked: str) -> list[str]:
    if re.search(rf"\b{COLOR} (?:{PATCH}|{PATCHES})\b", asked):
        return []  # some of them are named already
    if one := _ONE_PATCH.match(text):
        return [f"a {color} patch" for color in one.groups()]
    told = _PATCHES_ARE.match(text)
    colors = re.findall(COLOR, told[2]) if told else []
    many = lexicon.NUMBER.get(told[1], 0) or int(told[1]) if told and told[1] else len(colors)
    return [f"a {color} patch" for color in colors] if len(set(colors)) == len(colors) == many else []


def _blocks(text: str, asked: str) -> list[str]:
    """The blocks that are named one by one, and the others."""
    told, named = _OTHERS_ARE.match(text), list(dict.fromkeys(_NAMED.findall(asked)))
    if told is None or not named or _COUNTED.search(asked):
        return []
    counts = {_number(many) for many in (told[1], told[3], *_OTHER.findall(asked)) if many}
    if told[2]:
        others = re.findall(COLOR, told[2])
        plain = len(set(others)) == len(others) and not {*others} & {*named} and counts <= {len(others)}
        return [f"a {color} block" for color in (*named, *others)] if plain else []
    if len(counts) != 1 or told[4] in named:
        return []
    many = next((word for word in FEW.split("|") if lexicon.NUMBER[word] in counts), "")
    return [*(f"a {color} block" for color in named), f"{many} {told[4]} blocks"] if many else []


def _number(word: str) -> int:
    return lexicon.NUMBER.get(word, 0) or int(word)
