"""Blocks that are listed where another one is named as well: "move the black cube away, then stack the cubes. The cubes
are red and blue.", "black is on the mat. The other cubes are red and blue. Stack them."."""

from __future__ import annotations

import re
from functools import lru_cache

from rpg.language.grammar.rows.turned import Turns, all_of_it, turned
from rpg.language.grammar.rows.vocabulary import AND, COLOR
from rpg.language.patterns import on_demand
from rpg.language.tokens import Token

_BLOCKS = "(?:cubes|blocks|bricks)"
_LISTED = on_demand(f"(?:^|\\. )the (?:(?:other|remaining) )?{_BLOCKS} are ({COLOR}(?:{AND} {COLOR})+)(?= [.,]|$)")
_NAMED = on_demand(f"\\b({COLOR}) (?:block|cube|brick)\\b")


def listed_of_all(tokens: list[Token]) -> list[Token]:
    """The tokens with the listed ones named where "the cubes" or, right behind the list, "them" stand for them: no
    other one is meant."""
    words = [token.word for token in tokens]
    if "are" not in words or {"cubes", "blocks", "bricks"}.isdisjoint(words):
        return tokens
    text = " ".join(words)
    told = _LISTED.search(text)
    if told is None:
        return tokens
    listed = re.findall(COLOR, told[1])
    if {*_NAMED.findall(text)} <= {*listed}:
        return tokens
    return turned(tokens, _turns(told[1], tuple(listed)), all_of_it)


@lru_cache(maxsize=64)
def _turns(told: str, listed: tuple[str, ...]) -> Turns:
    named = " and ".join(f"the {color} block" for color in listed)
    return Turns((
        (f"\\bthe (?:other|remaining) {_BLOCKS} are {told} \\. ([^.]*?)\\bthem\\b", f"{{1}} {named}"),
        (f"\\bthe {_BLOCKS}(?! are {told})(?= |$)", named),
        (f"(are {told} \\. [^.]*?)\\bthem\\b", f"{{1}} {named}"),
    ))  # fmt: skip
