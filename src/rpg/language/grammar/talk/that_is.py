""" "Sort by kind, i.e. three letters and three digits in two groups": what is said once more behind "i.e."."""

from __future__ import annotations

from rpg.language.grammar.rows.parting import STOPS
from rpg.language.tokens import Token

_TELLS = frozenset({"is", "are", "must", "has", "have", "should", "stands", "stand", "lies", "lie", "goes", "go",
                    "touch", "touches"})  # fmt: skip


def that_is(tokens: list[Token]) -> list[Token] | None:
    """The words with what explains in a sentence of its own, or listed behind a colon; None where nothing does."""
    at = next((n for n, token in enumerate(tokens) if n and token.raw.lower().startswith("i.e")), 0)
    begin = at - (tokens[at - 1].word == ",") if at else 0
    end = next((n for n in range(at, len(tokens)) if tokens[n].word in STOPS), len(tokens))
    if begin < 2 or tokens[begin - 1].word == "(" or end == at + 1:
        return None
    told = not _TELLS.isdisjoint(token.word for token in tokens[at + 1 : end])
    mark = ":" if tokens[begin - 2].word == "by" else "." if told else ","
    return [*tokens[:begin], tokens[at].saying(mark), *tokens[at + 1 :]]
