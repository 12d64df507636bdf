"""Rows as they are written, a mark between them or none: "2x2 grid: A B / C D", "2x2 grid: A, B, C, D"."""

from __future__ import annotations

from dataclasses import replace
from itertools import takewhile
from math import prod

from rpg.language import lexicon
from rpg.language.tokens import Token

_GRIDS = frozenset({"grid", "rows", "matrix", "wall", "table"})
_FIGURES = _GRIDS | lexicon.PATCH.keys() | {"columns", "square", "rectangle", "wide", "high", "tall", "deep"}
_PASSING = frozenset({",", "and", "a", "an", "the", "block", "cube"})
_CLOSING = frozenset({".", "!", ")", "?", "please", "thanks"})


def rows_in_words(tokens: list[Token]) -> list[Token]:
    """The same, with "row by row" in words and a comma behind each block; other tokens as they are."""
    at = next((n for n, token in enumerate(tokens) if token.word == ":"), None)
    if at is None or not any(token.word in _GRIDS or token.kind == "dims" for token in tokens[:at]):
        return tokens
    for closing in (_CLOSING, _CLOSING | {";"}):
        told = list(takewhile(lambda token: token.word not in closing, tokens[at + 1 :]))  # noqa: B023
        if told and (blocks := _row_by_row(tokens, at, told)):
            return [*_with(tokens, at, blocks), *tokens[at + 1 + len(told) :]]
    return tokens


def _row_by_row(tokens: list[Token], at: int, told: list[Token]) -> list[Token]:
    """The names in what is told, where these are rows of one length, or as many as the figure ahead has cells."""
    lots: list[list[Token]] = [[]]
    for token in told:
        if token.word in ("/", ";"):
            lots.append([])
        elif token.word not in _PASSING or _is_name(token):
            lots[-1].append(token)
    names = [token for lot in lots for token in lot]
    counted = len({token.word in lexicon.COLOR for token in names if token.kind == "number" or len(token.word) > 1}) > 1
    long = {len(lot) for lot in lots}
    if counted or len(long) > 1 or min(long) < 2 or not all(map(_is_name, names)):
        return []
    if len(lots) == 1 and (len(lots[0]) != _cells(tokens[:at]) or any(token.word == "order" for token in tokens)):
        return []
    return names


def _cells(ahead: list[Token]) -> int:
    """How many blocks a figure has whose rows and columns are told: "a 2x3 grid", "a grid of 2 rows and 3 columns"; 0
    where something else stands before the colon, as in "a 2x2 grid from these blocks:"."""
    dims = next((token.value for token in ahead if token.kind == "dims"), None)
    lines = dims if isinstance(dims, tuple) else tuple(token.many for token in ahead if token.many)
    figure = ahead[-1].word in _FIGURES or ahead[-1].kind == "dims" or ahead[-1].many
    return prod(lines) if figure and len(lines) == 2 else 0


def _with(tokens: list[Token], at: int, blocks: list[Token]) -> list[Token]:
    colon = tokens[at]

    def word(said: str, like: Token) -> Token:
        return replace(like, kind="punct" if said in (",", ":") else "word", word=said, raw=said, value=None)

    ahead = [word(said, colon) for said in (",", "row", "by", "row", ":")]
    listed = [part for token in blocks for part in (token, word(",", token))][:-1]
    return [*tokens[:at], *ahead, *listed]


def _is_name(token: Token) -> bool:
    symbol = token.kind == "number" or (token.kind == "word" and len(token.raw) == 1 and token.raw.isupper())
    return symbol or token.word in lexicon.COLOR
