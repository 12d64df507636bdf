"""Letters or digits typed in one go, as they follow each other: "abcde in a row", "the digits 12345 in a tower"."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from itertools import pairwise

from rpg.language.tokens import Token

_LEAST = 3
"""So many of them are no word, and no number of blocks that there could be."""
_READ = frozenset({
    "spell", "spells", "spelling", "spelled", "spelt", "write", "writes", "writing", "read", "reads", "reading", "say",
    "says", "saying", "show", "shows", "word", "name", "number", "in", "by", "out",
})  # fmt: skip
"""Behind these it is one word or number, or an order."""
_FLAT = ("row", "line", "column")
_LINES = (*_FLAT, "tower", "stack")


def runs_apart(tokens: list[Token]) -> list[Token]:
    """The tokens with a comma between the symbols of such a run, which along the table is an order."""
    out: list[Token] = []
    for n, token in enumerate(tokens):
        before, behind = tokens[n - 1].word if n else "", [t.word for t in tokens[n + 1 : n + 4]]
        if not _run(token) or before in _READ or not (_in_line(behind, _LINES) or behind[:1] == ["from"]):
            out.append(token)
            continue
        for k, symbol in enumerate(token.raw):
            out += [token.saying(",")] * (k > 0)
            digit = symbol.isdigit()
            one = replace(token, word=symbol.lower(), raw=symbol.upper(), value=float(symbol) if digit else None)
            out.append(one)
        out += map(token.saying, ("in", "this", "order") if _in_line(behind, _FLAT) else ())
    return out


def _run(token: Token) -> bool:
    """Whether each symbol is the next one, or each the one before."""
    shown = token.raw if token.kind in ("word", "number") else ""
    steps = {ord(b) - ord(a) for a, b in pairwise(shown.lower())}
    plain = shown.isdigit() or (shown.isascii() and shown.isalpha() and not shown.isupper())
    return plain and len(shown) >= _LEAST and len(steps) == 1 and steps <= {1, -1}


def _in_line(behind: list[str], lines: Sequence[str]) -> bool:
    """Whether what is said next is that they lie in such a line."""
    return behind[:1] in (["in"], ["as"]) and behind[1:2] in (["a"], ["one"]) and behind[2:3] in [[x] for x in lines]
