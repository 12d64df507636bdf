"""Cubes that are counted and named, with others besides: "there are three letter cubes A, B and C and three plain
cubes", each by itself."""

from __future__ import annotations

from rpg.language import lexicon
from rpg.language.grammar.rows.parting import STOPS
from rpg.language.grammar.rows.row_places import word_of
from rpg.language.tokens import Token

_KINDS = frozenset({"letter", "digit", "number"})
_CUBES = frozenset({"cubes", "blocks"})
_THERE = frozenset({"are", "have", "got"})


def labels_counted(tokens: list[Token]) -> list[Token]:
    """The tokens with "an A block, a B block and a C block" for "three letter cubes A, B and C", where more follow."""
    for at in range(1, len(tokens) - 5):
        many = tokens[at].many
        counted = tokens[at - 1].word in _THERE and many > 1 and tokens[at + 1].word in _KINDS
        if not counted or tokens[at + 2].word not in _CUBES:
            continue
        named, end = _labels(tokens, at + 3)
        more = end < len(tokens) - 1 and tokens[end].word in ("and", ",") and tokens[end + 1].word not in STOPS
        if len(named) != many or not more or not tokens[end + 1].many:
            return tokens
        base = tokens[at]
        listed: list[Token] = []
        for n, label in enumerate(named):
            listed += [base.saying(",")] if n else []
            listed += [base.saying("a"), label, base.saying("block")]
        return [*tokens[:at], *listed, *tokens[end:]]
    return tokens


def _labels(tokens: list[Token], at: int) -> tuple[list[Token], int]:
    """The symbols of a list, and the position behind the last of them."""
    found: list[Token] = []
    end = at
    while at < len(tokens) and (word_of(tokens, at)[0] == "@" or tokens[at].raw in lexicon.DIGIT):
        found.append(tokens[at])
        end = at + 1
        at = end
        while at < len(tokens) and tokens[at].word in (",", "and"):
            at += 1
    return found, end
