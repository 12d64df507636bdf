"""Rows as they are written, a slash between them: "2x2 grid: A B / C D"."""

from __future__ import annotations

from dataclasses import replace
from itertools import takewhile

from rpg.language import lexicon
from rpg.language.tokens import Token

_GRIDS = frozenset({"grid", "rows", "matrix", "wall", "table"})
_CLOSING = frozenset({".", "!", ";", ")"})


def rows_in_words(tokens: list[Token]) -> list[Token]:
    """The same, with "row by row" in words and a comma behind each block; other tokens as they are."""
    at = next((n for n, token in enumerate(tokens) if token.word == ":"), None)
    if at is None or not any(token.word in _GRIDS or token.kind == "dims" for token in tokens[:at]):
        return tokens
    told = list(takewhile(lambda token: token.word not in _CLOSING, tokens[at + 1 :]))
    lots: list[list[Token]] = [[]]
    for token in told:
        if token.word == "/":
            lots.append([])
        elif token.word != ",":
            lots[-1].append(token)
    long = {len(lot) for lot in lots}
    if len(lots) < 2 or len(long) > 1 or min(long) < 2 or not all(_is_name(token) for lot in lots for token in lot):
        return tokens
    colon = tokens[at]

    def word(said: str, like: Token) -> Token:
        return replace(like, kind="punct" if said in (",", ":") else "word", word=said, raw=said, value=None)

    ahead = [word(said, colon) for said in (",", "row", "by", "row", ":")]
    blocks = [token for lot in lots for token in lot]
    listed = [part for token in blocks for part in (token, word(",", token))][:-1]
    return [*tokens[:at], *ahead, *listed, *tokens[at + 1 + len(told) :]]


def _is_name(token: Token) -> bool:
    symbol = token.kind == "number" or (token.kind == "word" and len(token.raw) == 1 and token.raw.isupper())
    return symbol or token.word in lexicon.COLOR
