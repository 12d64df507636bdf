"""Texts parted into sentences, before any of them is read."""

from __future__ import annotations

from collections.abc import Collection

from rpg.language.tokens import Token

STOPS = frozenset({".", "!", "?", ";"})


def sentences(tokens: list[Token], stops: Collection[str] = STOPS) -> list[list[Token]]:
    """The sentences, each with the stop behind it."""
    out: list[list[Token]] = [[]]
    for token in tokens:
        out[-1].append(token)
        if token.kind == "punct" and token.word in stops:
            out.append([])
    return [sentence for sentence in out if sentence]


def text_of(tokens: list[Token]) -> str:
    """The words of a sentence with blanks between them; one of several words is one word."""
    return " ".join(token.word.replace(" ", "_") or "_" for token in tokens)
