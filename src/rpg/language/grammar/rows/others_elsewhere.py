"""So many blocks at a place, and so many others that are anywhere else: "exactly three cubes inside the yellow patch,
the remaining two anywhere else on the table" is exactly three of the five."""

from __future__ import annotations

import re

from rpg.language.grammar.rows.parting import text_of
from rpg.language.grammar.rows.said_short import PUT
from rpg.language.grammar.rows.turned import Turns, all_of_it, turned
from rpg.language.grammar.rows.vocabulary import COLOR, MANY, MUST, number
from rpg.language.patterns import on_demand
from rpg.language.tokens import Token

_BLOCKS = "(?:blocks?|cubes?|bricks?|boxes|box)"
_BE = f"(?:{MUST} (?:be|lie|go|stand)|is|are|lie|lies|go|goes)"
_MAY = f"(?:{_BE}|(?:may|can|could) (?:be|lie|go|stay|stand))"
_ELSE = "(?:(?:anywhere|somewhere|wherever)(?: else| but (?:there|on it|in it))?|elsewhere)"
_TOLD = on_demand(
    f"(?:^|(?<=[.:;!] ))(?:{PUT} )?(?:exactly |just |only )?(?P<many>{MANY})(?: of (?:the )?(?P<all>{MANY}))?(?: "
    f"(?P<color>{COLOR}))?(?P<noun> {_BLOCKS})?(?: {_BE})? (?P<place>(?:on|onto|in|into|inside) the [^,.;:]+?) "
    f"(?:,|;|\\.|"
    f"and)(?: and| but)? the (?:other|remaining)(?: (?P<others>{MANY}))?(?: (?P<like>{COLOR}))?(?P<ones> "
    f"{_BLOCKS}| ones?)?"
    f"(?: {_MAY})? {_ELSE}(?: (?:on|around|about)(?: the table)?| you like| they like)?(?= [.;!]|$)"
)
_COUNTED = on_demand(f"\\b({MANY}) (?:{COLOR} )?{_BLOCKS}\\b")
_WHERE = frozenset({"anywhere", "somewhere", "wherever", "elsewhere"})


def others_elsewhere(tokens: list[Token]) -> list[Token]:
    """The tokens with so many of them all, where it is only said of the others that they are elsewhere."""
    if _WHERE.isdisjoint(token.word for token in tokens):
        return tokens
    text = text_of(tokens)
    told = _TOLD.search(text)
    if told is None or not (told["others"] or told["ones"]) or told["like"] not in (None, told["color"]):
        return tokens
    if not told["others"] and (told["ones"] or "").endswith("s"):
        return tokens  # "the other blocks", of which it is not said how many they are
    total = number(told["many"]) + number(told["others"] or "1")
    there = [number(many) for many in _COUNTED.findall(text[: told.start()])]
    if (told["all"] and number(told["all"]) != total) or (not told["noun"] and (told["color"] or there != [total])):
        return tokens
    whole = f"the {total} {told['color'] or ''} blocks" if told["noun"] else "them"
    said = f"exactly {told['many']} of {whole} must be {told['place']}"
    return turned(tokens, Turns([(f"(?<![^ ]){re.escape(told.group())}(?![^ ])", said)]), all_of_it)
