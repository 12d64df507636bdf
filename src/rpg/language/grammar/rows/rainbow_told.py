"""A rainbow that is announced and then told colour by colour: "Let us make a rainbow! One red, one orange, ... in
a row": the row that is told has its order."""

from __future__ import annotations

import re

from rpg.language import lexicon
from rpg.language.grammar.rows.parting import STOPS
from rpg.language.tokens import Token

_ANNOUNCED = re.compile(
    "^(?:(?:today|now|ok|okay) ,? ?)?(?:please )?(?:let us |we (?:will |want to )?|i (?:want|would like) (?:to )?)?"
    "(?:make |build |lay |do |have )?(?:out )?(?:me |us )?a (?:nice |beautiful |pretty |little |big )?rainbow(?: "
    "please)?$"
)
_LINES = frozenset({"row", "line", "column", "tower", "stack"})
_LEAST = 4
"""So many colours of it, one after the other, are the rainbow."""


def announced_rainbow(tokens: list[Token]) -> list[Token]:
    """The tokens without a first sentence that announces a rainbow, whose order is told of the row behind it."""
    end = next((n for n, token in enumerate(tokens) if token.kind == "punct" and token.word in STOPS), 0)
    if not end or not _ANNOUNCED.match(" ".join(token.word for token in tokens[:end])):
        return tokens
    rest = tokens[end + 1 :]
    told = [lexicon.COLOR[token.word] for token in rest if token.word in lexicon.COLOR][: len(lexicon.RAINBOW)]
    first = told[: next((n for n, color in enumerate(told) if color in told[:n]), len(told))]
    ranks = [lexicon.RAINBOW.index(color) for color in first if color in lexicon.RAINBOW]
    whole = len(ranks) == len(first) >= _LEAST and ranks in (sorted(ranks), sorted(ranks, reverse=True))
    line = next((n for n, token in enumerate(rest) if token.word in _LINES), 0)
    if not (whole and line):
        return tokens
    return [*rest[: line + 1], *map(rest[line].saying, ("in", "rainbow", "order")), *rest[line + 1 :]]
