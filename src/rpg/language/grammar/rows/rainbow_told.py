"""A rainbow that is announced and then told colour by colour: "Let us make a rainbow! One red, one orange, ... in
a row": the row that is told has its order; or told by the two colours that it runs between, "one block for each color
from red to purple"."""

from __future__ import annotations

import re

from rpg.language import lexicon
from rpg.language.grammar.rows.parting import STOPS
from rpg.language.grammar.rows.turned import Turn
from rpg.language.grammar.rows.vocabulary import BUILD, COLOR, CUBE, LINE, NO_NUMBER
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


_EACH = (
    f"(?:(?:(?:one|a)(?: {CUBE})? )?(?:for |of |in )?(?:each|every)|(?:one|a)(?: {CUBE})? per|all(?: of)?(?: the)?|the)"
    "(?: rainbow)? colors?(?: of the rainbow)?(?: ,)?"
)
_SPAN = f"(?:from|between) ({COLOR}) (?:to|and) ({COLOR})"
RAINBOW_SPANS: tuple[Turn, ...] = (
    (f"\\b(rainbow\\b{NO_NUMBER})(?: ,| :)? {_EACH} {_SPAN}", "{1} from {2} to {3}"),
    (f"\\b({LINE}) (?:of|from|with|out of|made of) {_EACH} {_SPAN}", "{1} in rainbow order from {2} to {3}"),
    (f"^(?:{BUILD} )?{_EACH} {_SPAN}(?: ,)? (?:in|as|into) an? (?:straight )?({LINE})\\b",
     "a {3} in rainbow order from {1} to {2}"),
    (f"^stack(?: up)? {_EACH} {_SPAN}\\b", "a tower in rainbow order from {1} to {2}"),
    (f"^line up {_EACH} {_SPAN}\\b", "line up blocks in rainbow order from {1} to {2}"),
)  # fmt: skip
"""What is looked for in a sentence that cannot be read as it stands, and what is said instead."""
